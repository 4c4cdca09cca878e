"""The peer of benches/batch.rs: whole PreXYT campaigns from the same files with pandas and SciPy, as a laboratory's script does
it. Reads exports and encoders, makes the world frame, joins, identifies 14 parameters (MINPACK's lm, 2-point numeric Jacobian),
computes the errors of all poses before and after, and writes them as JSON. It computes no uncertainty, and checks nothing.

Residuals are written in two ways: one observation after the other, as the equations are in a thesis, and with NumPy's arrays of
all observations at once.

usage: batch_scipy.py POSES CAMPAIGN...    (the calibration poses are 1 to POSES)
Prints for each way the median time of a campaign in seconds (imports are not counted), and the parameter s of the first in mm.
"""

import json
import math
import pathlib
import sys
import time

import numpy as np
import pandas as pd
from scipy.optimize import least_squares

NAMES = "beta gamma epsilon_theta s d3 d x_c y_c x_o y_o delta delta2 delta3 l_kl".split()
NOMINAL = np.array([0, 0, 0, 394, 0, 116, 73, -73, 22.5, -30.5, 1, 1, 1, 146.0])


def balls(p, rho):
    """Positions of K and L (n, 4) in arrays."""
    beta, gamma, epsilon, s, d3, d, x_c, y_c, x_o, y_o, delta, delta2, delta3, l_kl = p
    y2, reach3 = delta2 * rho[:, 1], delta3 * rho[:, 2]
    run, y3 = s - reach3 * np.sin(beta) - d3 * np.tan(beta), reach3 * np.cos(beta) + d3
    theta = np.arctan2(y3 - y2, run)
    x = (delta * rho[:, 0] + d + y2 * np.tan(gamma)) / (1 - np.tan(gamma) * np.tan(theta))
    y = y2 + x * np.tan(theta)
    c, sine = np.cos(theta + epsilon), np.sin(theta + epsilon)
    k = x + x_o - (x_c * c - y_c * sine), y + y_o - (x_c * sine + y_c * c)
    return np.column_stack([k[0], k[1], k[0] + l_kl * c, k[1] + l_kl * sine])


def one_by_one(p, rho):
    """Positions of K and L (n, 4), one observation after the other."""
    beta, gamma, epsilon, s, d3, d, x_c, y_c, x_o, y_o, delta, delta2, delta3, l_kl = p
    found = []
    for rho1, rho2, rho3 in rho.tolist():
        y2, reach3 = delta2 * rho2, delta3 * rho3
        run, y3 = s - reach3 * math.sin(beta) - d3 * math.tan(beta), reach3 * math.cos(beta) + d3
        theta = math.atan2(y3 - y2, run)
        x = (delta * rho1 + d + y2 * math.tan(gamma)) / (1 - math.tan(gamma) * math.tan(theta))
        y = y2 + x * math.tan(theta)
        c, sine = math.cos(theta + epsilon), math.sin(theta + epsilon)
        k = x + x_o - (x_c * c - y_c * sine), y + y_o - (x_c * sine + y_c * c)
        found.append((*k, k[0] + l_kl * c, k[1] + l_kl * sine))
    return np.array(found)


def points(file):
    return pd.read_csv(file, sep=r"\s+", header=None, names=["label", "x", "y", "z"])


def unit(v):
    return v / np.linalg.norm(v)


def world(folder):
    """Origin and axes (columns) of the world frame: plane of the rails, axis of actuator 2, towards rail 3."""
    mean = points(folder / "exports/world.txt").groupby("label")[["x", "y", "z"]].mean()
    a, b, c, home, end = (mean.loc[name].to_numpy() for name in ["rail2_a", "rail2_b", "rail3_a", "R_home", "R_end"])
    z = unit(np.cross(b - a, c - a))
    y = unit(end - home - z * (z @ (end - home)))
    x = np.cross(y, z)
    if x @ (c - home) < 0:
        x, z = -x, -z
    return home, np.column_stack([x, y, z])


def campaign(folder, poses, model):
    origin, axes = world(folder)
    read = points(folder / "exports/poses.txt")
    read[["target", "pose", "run"]] = read["label"].str.split("_", expand=True)
    read[["pose", "run"]] = read[["pose", "run"]].astype(int)
    read[["x", "y", "z"]] = (read[["x", "y", "z"]].to_numpy() - origin) @ axes
    wide = read.pivot(index=["pose", "run"], columns="target", values=["x", "y"])
    wide.columns = [f"{axis}_{target}" for axis, target in wide.columns]
    rows = wide.reset_index().merge(pd.read_csv(folder / "encoders.csv"), on=["pose", "run"])
    rho = rows[["RP1", "RP2", "RP3"]].to_numpy()
    measured = rows[["x_K", "y_K", "x_L", "y_L"]].to_numpy()
    used = (rows["pose"] <= poses).to_numpy()
    found = least_squares(lambda p: (model(p, rho[used]) - measured[used]).ravel(), NOMINAL, method="lm", x_scale="jac")
    answer = {"parameters": dict(zip(NAMES, found.x.tolist()))}
    for name, values in [("before", NOMINAL), ("after", found.x)]:
        errors = (model(values, rho) - measured).reshape(-1, 2, 2)
        size = np.linalg.norm(errors, axis=2)
        turn = np.diff(np.arctan2(errors[:, 1, 1] - errors[:, 0, 1], values[-1]))
        judged = size[~used]
        answer[name] = {
            "mean_mm": judged.mean(),
            "rms_mm": math.sqrt((judged**2).mean()),
            "p95_mm": float(np.quantile(judged, 0.95)),
            "max_mm": judged.max(),
            "turn_rms_rad": math.sqrt((turn**2).mean()),
            "by_pose": [{"pose": int(p), "run": int(r), "mm": e} for p, r, e in zip(rows["pose"], rows["run"], size.tolist())],
        }
    (folder / "scipy.json").write_text(json.dumps(answer))
    return answer["parameters"]["s"]


poses, folders = int(sys.argv[1]), [pathlib.Path(folder) for folder in sys.argv[2:]]
for way, model in [("observation by observation", one_by_one), ("in arrays", balls)]:
    times, found = [], []
    for folder in folders:
        clock = time.perf_counter()
        found.append(campaign(folder, poses, model))
        times.append(time.perf_counter() - clock)
    print(f"{way}: {np.median(times)} {found[0]}")

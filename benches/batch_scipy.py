"""The peer of benches/batch.rs: the identification of a PreXYT with SciPy, 2-point numeric Jacobian, written in two ways: one
observation after the other, as the equations are in a thesis, and with NumPy's arrays of all observations at once.

usage: batch_scipy.py observations.csv POSES    (the calibration poses are 1 to POSES)
Prints for each way the median time of the fit alone in seconds, of data that are in memory already, and the parameter s in mm.
"""

import math
import sys
import time

import numpy as np
from scipy.optimize import least_squares

rows = np.genfromtxt(sys.argv[1], delimiter=",", names=True, dtype=None, encoding="utf-8")
rows = rows[rows["pose"] <= int(sys.argv[2])]
at_k, at_l = rows[rows["target"] == "K"], rows[rows["target"] == "L"]
rho = [at_k[f"rho{i}_mm"] for i in (1, 2, 3)]
xy = np.concatenate([at_k["x_mm"], at_k["y_mm"], at_l["x_mm"], at_l["y_mm"]])
# beta gamma epsilon_theta s d3 d x_c y_c x_o y_o delta delta2 delta3 l_kl
NOMINAL = np.array([0, 0, 0, 394, 0, 116, 73, -73, 22.5, -30.5, 1, 1, 1, 146.0])
FREE = np.arange(14)


def balls(p):
    beta, gamma, epsilon, s, d3, d, x_c, y_c, x_o, y_o, delta, delta2, delta3, l_kl = p
    y2, reach3 = delta2 * rho[1], delta3 * rho[2]
    run, y3 = s - reach3 * np.sin(beta) - d3 * np.tan(beta), reach3 * np.cos(beta) + d3
    theta = np.arctan2(y3 - y2, run)
    x = (delta * rho[0] + d + y2 * np.tan(gamma)) / (1 - np.tan(gamma) * np.tan(theta))
    y = y2 + x * np.tan(theta)
    c, s = np.cos(theta + epsilon), np.sin(theta + epsilon)
    k = x + x_o - (x_c * c - y_c * s), y + y_o - (x_c * s + y_c * c)
    return np.concatenate([k[0], k[1], k[0] + l_kl * c, k[1] + l_kl * s])


def one_by_one(p):
    beta, gamma, epsilon, s, d3, d, x_c, y_c, x_o, y_o, delta, delta2, delta3, l_kl = p
    k, l = [], []
    for rho1, rho2, rho3 in readings:
        y2, reach3 = delta2 * rho2, delta3 * rho3
        run, y3 = s - reach3 * math.sin(beta) - d3 * math.tan(beta), reach3 * math.cos(beta) + d3
        theta = math.atan2(y3 - y2, run)
        x = (delta * rho1 + d + y2 * math.tan(gamma)) / (1 - math.tan(gamma) * math.tan(theta))
        y = y2 + x * math.tan(theta)
        c, sine = math.cos(theta + epsilon), math.sin(theta + epsilon)
        k.append((x + x_o - (x_c * c - y_c * sine), y + y_o - (x_c * sine + y_c * c)))
        l.append((k[-1][0] + l_kl * c, k[-1][1] + l_kl * sine))
    return np.concatenate([np.array(k).T.ravel(), np.array(l).T.ravel()])


readings = list(zip(*(reading.tolist() for reading in rho)))
for way, model in [("observation by observation", one_by_one), ("in arrays", balls)]:

    def residuals(free):
        p = NOMINAL.copy()
        p[FREE] = free
        return model(p) - xy

    times = []
    for _ in range(21):
        clock = time.perf_counter()
        found = least_squares(residuals, NOMINAL[FREE], method="lm", x_scale="jac")
        times.append(time.perf_counter() - clock)
    print(f"{way}: {np.median(times)} {found.x[3]}")

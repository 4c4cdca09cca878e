"""Three reflectors on the tool and three on the table, measured at each pose; commanded joints (deg)."""

import numpy as np


def frame(points):
    a, b, c = points
    x = (b - a) / np.linalg.norm(b - a)
    z = np.cross(x, c - a)
    z /= np.linalg.norm(z)
    return np.column_stack([x, np.cross(z, x), z]), a


def read(folder, options):
    load = lambda name: np.loadtxt(folder / name)
    joints = load("basic/commanded_joints_full.txt")
    table = np.stack([load(f"full_raw/measured_base_{k}.txt") for k in (1, 2, 3)], axis=1)
    tool = np.stack([load(f"full_raw/measured_SMR_{k}.txt") for k in (1, 2, 3)], axis=1)
    sizes = lambda p: np.linalg.norm(p - np.roll(p, 1, axis=1), axis=2)
    seen = (np.abs(table).sum(2) > 0).all(1) & (np.abs(tool).sum(2) > 0).all(1)
    # a beam on the wrong reflector shows in the distances
    rigid = [np.abs(sizes(p) - np.median(sizes(p)[seen], axis=0)).max(1) < 1.0 for p in (table, tool)]
    rows = []
    for k in np.flatnonzero(seen & rigid[0] & rigid[1]):
        turned, origin = frame(table[k])
        for t in range(3):
            xyz = (turned.T @ (tool[k, t] - origin)).tolist()
            rows.append({"pose": str(k + 1), "target": f"SMR_{t + 1}", "joints": joints[k].tolist(), "xyz": xyz})
    return [f"q{k}_deg" for k in range(1, 7)], rows

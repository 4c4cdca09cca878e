"""Reference values of tests/laws/identify/cell.rs: the same equations solved by scipy.optimize.least_squares with rotation
vectors and numerical derivatives. Data are synthetic, from a seeded generator. Run: python3 cell_scipy.py > cell_scipy.json"""

import json
import sys

import numpy as np
import scipy
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

rng = np.random.default_rng(45)


def pose(turn, size):
    return Rotation.from_rotvec(rng.uniform(-turn, turn, 3)), rng.uniform(-size, size, 3)


def then(a, b):
    return a[0] * b[0], a[0].apply(b[1]) + a[1]


def inverse(a):
    back = a[0].inv()
    return back, -back.apply(a[1])


def row(a):
    return [*a[1], *np.roll(a[0].as_quat(), 1)]


def solve(residuals, start):
    found = least_squares(residuals, start, x_scale="jac", method="lm", xtol=1e-15, ftol=1e-15, gtol=1e-15, max_nfev=100000)
    assert found.success
    return found.x


def tool_point():
    tool, fixed = rng.uniform(-200, 200, 3), rng.uniform(-900, 900, 3)
    poses = []
    for _ in range(7):
        turn, _ = pose(0.8, 1)
        poses.append((turn, fixed - turn.apply(tool) + rng.normal(0, 0.05, 3)))
    turns, places = [p[0] for p in poses], [p[1] for p in poses]
    rows = np.vstack([np.hstack([t.as_matrix(), -np.eye(3)]) for t in turns])
    x, squares, _, _ = np.linalg.lstsq(rows, -np.concatenate(places), rcond=None)
    covariance = np.linalg.inv(rows.T @ rows) * squares[0] / (rows.shape[0] - 6)
    return {"poses": [row(p) for p in poses], "tool": list(x[:3]), "fixed": list(x[3:]), "covariance": covariance[:3, :3].tolist()}


def tool_reflector():
    tool, world = rng.uniform(-200, 200, 3), pose(1.5, 2000)
    poses = [pose(1.0, 600) for _ in range(9)]
    points = [then(world, p)[0].apply(tool) + then(world, p)[1] + rng.normal(0, 0.05, 3) for p in poses]

    def residuals(x):
        turn = Rotation.from_rotvec(x[6:9])
        return np.concatenate([m - turn.apply(p[0].apply(x[:3]) + p[1]) - x[3:6] for p, m in zip(poses, points)])

    start = np.concatenate([tool + 1.0, world[1] + 1.0, world[0].as_rotvec() + 1e-3])
    x = solve(residuals, start)
    return {
        "poses": [row(p) for p in poses], "points": [list(p) for p in points], "tool": list(x[:3]),
        "world_T_base": row((Rotation.from_rotvec(x[6:9]), x[3:6])),
        "deviation": float(np.sqrt(np.sum(residuals(x) ** 2) / (3 * len(poses) - 9))),
    }


def hand_eye():
    hand, base = pose(1.5, 150), pose(1.5, 1000)
    poses = [pose(0.9, 500) for _ in range(10)]
    measured = []
    for p in poses:
        exact = then(inverse(base), then(p, hand))
        measured.append((Rotation.from_rotvec(rng.normal(0, 2e-4, 3)) * exact[0], exact[1] + rng.normal(0, 0.05, 3)))

    def residuals(x):
        tool, world = (Rotation.from_rotvec(x[3:6]), x[:3]), (Rotation.from_rotvec(x[9:12]), x[6:9])
        out = []
        for p, m in zip(poses, measured):
            predicted = then(world, then(p, tool))
            out += [(m[1] - predicted[1]) / 0.05, (m[0] * predicted[0].inv()).as_rotvec() / 2e-4]
        return np.concatenate(out)

    world = inverse(base)
    x = solve(residuals, np.concatenate([hand[1] + 0.1, hand[0].as_rotvec() + 1e-3, world[1] + 0.1, world[0].as_rotvec() + 1e-3]))
    return {
        "poses": [row(p) for p in poses], "measured": [row(m) for m in measured],
        "hand": row((Rotation.from_rotvec(x[3:6]), x[:3])),
        "base_T_world": row(inverse((Rotation.from_rotvec(x[9:12]), x[6:9]))),
    }


def work_object():
    frame = pose(1.5, 1000)
    known = [rng.uniform(-300, 300, 3) for _ in range(6)]
    u = [rng.uniform(0.01, 0.1, 3) for _ in known]
    measured = [frame[0].apply(k) + frame[1] + rng.normal(0, s) for k, s in zip(known, u)]

    def residuals(x):
        turn = Rotation.from_rotvec(x[3:6])
        return np.concatenate([(m - turn.apply(k) - x[:3]) / s for k, m, s in zip(known, measured, u)])

    x = solve(residuals, np.concatenate([frame[1] + 0.1, frame[0].as_rotvec() + 1e-3]))
    return {
        "known": [list(k) for k in known], "measured": [list(m) for m in measured], "u": [list(s) for s in u],
        "frame": row((Rotation.from_rotvec(x[3:6]), x[:3])),
    }


json.dump(
    {"scipy": scipy.__version__, "tool_point": tool_point(), "tool_reflector": tool_reflector(), "hand_eye": hand_eye(), "object": work_object()},
    sys.stdout,
)

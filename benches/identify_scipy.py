"""The peer of benches/identify.rs: the same fit with SciPy, vectorised NumPy, 2-point numeric Jacobian.

usage: identify_scipy.py observations.csv EXTRA    (EXTRA: how many of three of bending and three of coupling)
Prints, for the two methods of least_squares, the time of the whole job (base and reflectors found from 20 random
starts on every 25th pose, then all parameters) and of its last fit alone.
"""

import sys
import time

import numpy as np
from scipy.optimize import least_squares

rows = np.genfromtxt(sys.argv[1], delimiter=",", names=True, dtype=None, encoding="utf-8")
extra = int(sys.argv[2])
poses = np.unique(rows["pose"])
first = np.unique(rows["pose"], return_index=True)[1]
q = np.radians(np.stack([rows[f"q{j}_deg"][first] for j in range(1, 7)], axis=1))
xyz = np.stack([rows["x_mm"], rows["y_mm"], rows["z_mm"]], axis=1).reshape(len(poses), -1, 3)
T = 6 + 3 * xyz.shape[1]  # base and reflectors
train = np.arange(len(poses)) % 10 < 7
NOMINAL = np.array(
    [(0, 0, 0, 290), (-90, 0, -90, 0), (0, 270, 0, 0), (-90, 70, 0, 302), (90, 0, 0, 0), (-90, 0, 180, 72)], float
)
NOMINAL[:, [0, 2]] = np.radians(NOMINAL[:, [0, 2]])
FREE = [(j, k) for j in range(1, 6) for k in range(4) if (j, k) not in [(2, 3), (5, 2), (5, 3)]]


def turn(angle, axis):
    c, s = np.cos(angle), np.sin(angle)
    m = {0: [[1, 0, 0], [0, c, -s], [0, s, c]], 1: [[c, 0, s], [0, 1, 0], [-s, 0, c]], 2: [[c, -s, 0], [s, c, 0], [0, 0, 1]]}
    return np.array(m[axis])


def turn_z(angles):
    m = np.zeros((len(angles), 3, 3))
    c, s = np.cos(angles), np.sin(angles)
    m[:, 0, 0], m[:, 0, 1], m[:, 1, 0], m[:, 1, 1], m[:, 2, 2] = c, -s, s, c, 1
    return m


def predict(x, q):
    mdh, beta, q = NOMINAL.copy(), 0.0, q.copy()
    if len(x) > T:
        for value, (j, k) in zip(x[T : T + 17], FREE):
            mdh[j, k] += value * (1 if k in (1, 3) else 1e-2)
        beta = x[T + 17] * 1e-2
        q *= 1 + x[T + 18 : T + 24] * 1e-3
    if len(x) > T + 24:
        c = np.append(x[T + 24 :], np.zeros(6))[:6] * 1e-3
        upper, fore = q[:, 1].copy(), q[:, 1] + q[:, 2]
        q[:, 5] += c[4] * q[:, 3] + c[5] * q[:, 4]
        q[:, 4] += c[3] * q[:, 3]
        q[:, 1] += c[0] * np.sin(upper) + c[1] * np.cos(fore)
        q[:, 2] += c[2] * np.cos(fore)
    r = np.broadcast_to(turn(x[5], 2) @ turn(x[4], 1) @ turn(x[3], 0), (len(q), 3, 3))
    p = np.broadcast_to(x[:3], (len(q), 3))
    for i, (alpha, a, theta, d) in enumerate(mdh):
        p = p + r[:, :, 0] * a
        r = r @ turn(alpha, 0)
        if i == 2:
            r = r @ turn(beta, 1)
        r = r @ turn_z(q[:, i] + theta)
        p = p + r[:, :, 2] * d
    return p[:, None, :] + np.einsum("nij,kj->nki", r, x[6:T].reshape(-1, 3))


def residuals(x, which):
    return (predict(x, q[which]) - xyz[which]).ravel()


def find_base():
    subset = np.arange(len(poses)) % 25 == 0
    random, best = np.random.default_rng(0), None
    for _ in range(20):
        x = np.zeros(T)
        x[:3], x[3:6] = xyz[subset].mean((0, 1)), random.uniform(-3, 3, 3)
        found = least_squares(residuals, x, args=(subset,), method="lm")
        if best is None or found.cost < best.cost:
            best = found
    return best.x


clock = time.perf_counter()
start = np.concatenate([find_base(), np.zeros(24 + extra)])
finding = time.perf_counter() - clock
for method in ("lm", "trf"):
    clock = time.perf_counter()
    found = least_squares(residuals, start, args=(train,), method=method, x_scale="jac")
    seconds = time.perf_counter() - clock
    error = np.linalg.norm(residuals(found.x, ~train).reshape(-1, 3), axis=1)
    print(f"{method}, whole job (test mean {error.mean():.4f} mm): {finding + seconds}")
    print(f"{method}, the last fit alone: {seconds}")

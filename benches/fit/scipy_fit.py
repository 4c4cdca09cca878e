"""Circle, sphere and cylinder by scipy.optimize.least_squares with their exact Jacobian, the plane by NumPy:
scipy_fit.py ELEMENT FILE RUNS cx cy cz dx dy dz radius. Answers with the median seconds and the numbers found."""

import sys
import time

import numpy as np
from scipy.optimize import least_squares

element, path, runs = sys.argv[1:4]
cx, cy, cz, dx, dy, dz, radius = map(float, sys.argv[4:])
points = np.fromfile(path).reshape(-1, 2 if element == "circle2d" else 3)


def ball(start):
    def residuals(x):
        return np.linalg.norm(points - x[:-1], axis=1) - x[-1]

    def jacobian(x):
        w = x[:-1] - points
        j = np.empty((len(points), len(x)))
        j[:, :-1] = w / np.linalg.norm(w, axis=1)[:, None]
        j[:, -1] = -1
        return j

    return least_squares(residuals, start, jacobian, method="lm", x_scale="jac").x


def cylinder():
    centre, d0 = np.array([cx, cy, cz]), np.array([dx, dy, dz]) / np.linalg.norm([dx, dy, dz])
    e1 = np.cross(d0, [1, 0, 0]) / np.linalg.norm(np.cross(d0, [1, 0, 0]))
    e2 = np.cross(d0, e1)

    def seen(x):
        a, b, u, v, _ = x
        d = d0 + u * e1 + v * e2
        length = np.linalg.norm(d)
        d = d / length
        w = points - (centre + a * e1 + b * e2)
        t = w @ d
        across = w - np.outer(t, d)
        rho = np.linalg.norm(across, axis=1)
        return t, across / rho[:, None], rho, length

    def residuals(x):
        return seen(x)[2] - x[4]

    def jacobian(x):
        t, g, _, length = seen(x)
        g1, g2 = g @ e1, g @ e2
        return np.column_stack([-g1, -g2, -t * g1 / length, -t * g2 / length, np.full(len(t), -1.0)])

    x = least_squares(residuals, [0, 0, 0, 0, radius], jacobian, method="lm", x_scale="jac").x
    d = d0 + x[2] * e1 + x[3] * e2
    return [*(d / np.linalg.norm(d)), x[4]]


def plane():
    w = points - points.mean(axis=0)
    return np.linalg.eigh(w.T @ w)[1][:, 0]


fit = {
    "plane": plane,
    "circle2d": lambda: ball([cx, cy, radius]),
    "sphere": lambda: ball([cx, cy, cz, radius]),
    "cylinder": cylinder,
}[element]
times = []
for _ in range(int(runs)):
    start = time.perf_counter()
    answer = fit()
    times.append(time.perf_counter() - start)
print(float(np.median(times)), *map(float, answer))

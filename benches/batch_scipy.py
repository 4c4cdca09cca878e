"""The peer of benches/batch.rs: the identification of a PreXYT with SciPy, vectorised NumPy, 2-point numeric Jacobian.

usage: batch_scipy.py observations.csv POSES    (the calibration poses are 1 to POSES)
Prints the median time of the fit alone in seconds, of data that are in memory already, and the parameter s in mm.
"""

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


def residuals(free):
    p = NOMINAL.copy()
    p[FREE] = free
    return balls(p) - xy


times = []
for _ in range(21):
    clock = time.perf_counter()
    found = least_squares(residuals, NOMINAL[FREE], method="lm", x_scale="jac")
    times.append(time.perf_counter() - clock)
print(np.median(times), found.x[3])

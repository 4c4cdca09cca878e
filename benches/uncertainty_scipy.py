"""The peer of benches/uncertainty.rs: identifications of a DexTAR from drawn readings with SciPy, arrays of all observations at once.

usage: uncertainty_scipy.py observations.csv POSES UM    (the calibration poses are 1 to POSES; readings are drawn with UM micrometres)
Prints the median time of one identification in seconds, from the nominal parameters, with a 2-point numeric Jacobian, and the
parameter l23 in mm of the readings as they are.
"""

import sys
import time

import numpy as np
from scipy.optimize import least_squares

rows = np.genfromtxt(sys.argv[1], delimiter=",", names=True, dtype=None, encoding="utf-8")
rows = rows[rows["pose"] <= int(sys.argv[2])]
q1, q2, side = np.radians(rows["theta1_deg"]), np.radians(rows["theta2_deg"]), rows["assembly"]
measured = np.concatenate([rows["x_mm"], rows["y_mm"]])
# l11 l12 l21 l22 d l23 gamma delta1 delta2 x_o y_o phi
NOMINAL = np.array([230.0, 230, 230, 230, 275, 230, 0, 0, 0, 263, 75, 0])


def residuals(p, readings):
    l11, l12, l21, l22, d, l23, gamma, delta1, delta2, x_o, y_o, phi = p
    x1, y1 = l11 * np.cos(q1 + delta1) - d / 2, l11 * np.sin(q1 + delta1)
    x2, y2 = l21 * np.cos(q2 + delta2) + d / 2, l21 * np.sin(q2 + delta2)
    bx, by = x2 - x1, y2 - y1
    square = bx * bx + by * by
    along = (l12 * l12 - l22 * l22 + square) / (2 * square)
    across = np.sqrt(l12 * l12 / square - along * along) * side
    vx, vy = x1 + along * bx - across * by - x2, y1 + along * by + across * bx - y2
    c, s = np.cos(gamma) * l23 / l22, np.sin(gamma) * l23 / l22
    ex, ey = x2 + c * vx - s * vy, y2 + s * vx + c * vy
    c, s = np.cos(phi), np.sin(phi)
    return np.concatenate([x_o + c * ex - s * ey, y_o + s * ex + c * ey]) - readings


random, times = np.random.default_rng(1), []
for _ in range(41):
    drawn = measured + random.normal(0, 1e-3 * float(sys.argv[3]), len(measured))
    clock = time.perf_counter()
    least_squares(residuals, NOMINAL, args=(drawn,), method="lm", x_scale="jac")
    times.append(time.perf_counter() - clock)
print(np.median(times), least_squares(residuals, NOMINAL, args=(measured,), method="lm", x_scale="jac").x[5])

"""The peer of benches/python.rs: reads names of calls, prints the seconds that each took."""

import sys
import time

import etalon
import numpy as np

points = np.fromfile("points.bin").reshape(-1, 3)


def cylinder():
    etalon.fit.cylinder(points)


def identify():
    etalon.identify("robot.toml", "observations.csv")


for line in sys.stdin:
    call = {"cylinder": cylinder, "identify": identify}[line.strip()]
    start = time.perf_counter()
    call()
    print(time.perf_counter() - start, flush=True)

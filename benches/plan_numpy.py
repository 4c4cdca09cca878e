"""The peer of benches/plan.rs: grouped greedy for O1 with one singular value decomposition per candidate.

usage: plan_numpy.py rows.csv POSITIONS START...    (rows: candidate, then the scaled Jacobian's row; two rows a configuration)
Prints the median time of three runs in milliseconds and the candidates in the order of choosing.
"""

import sys
import time

import numpy as np

table = np.loadtxt(sys.argv[1], delimiter=",")
blocks = [table[table[:, 0] == c, 1:] for c in range(int(table[:, 0].max()) + 1)]
positions, start = int(sys.argv[2]), [int(c) for c in sys.argv[3:]]


def o1(chosen):
    jacobian = np.vstack([blocks[c] for c in chosen])
    values = np.linalg.svd(jacobian, compute_uv=False)
    return np.exp(np.log(values).mean()) / np.sqrt(len(jacobian) / 2)


def greedy():
    chosen = list(start)
    while len(chosen) < positions:
        free = [c for c in range(len(blocks)) if c not in chosen]
        chosen.append(max(free, key=lambda c: o1(chosen + [c])))
    return chosen


times = []
for _ in range(3):
    before = time.perf_counter()
    chosen = greedy()
    times.append(1000 * (time.perf_counter() - before))
print(f"{sorted(times)[1]:.3f}", *chosen)

"""Readers of the published files of each source. `read(folder, options)` returns the names of the joint columns and the rows of a set.

A row is a dictionary: `pose` (text), `target`, `joints` (list), `xyz` (mm), and `q` (w, x, y, z) where the orientation is measured.
"""

import numpy as np


def quaternion(matrix):
    """Unit quaternion (w, x, y, z) of a rotation matrix, made orthogonal first."""
    u, _, v = np.linalg.svd(np.asarray(matrix, float))
    r = u @ np.diag([1, 1, np.linalg.det(u @ v)]) @ v
    k = np.array(
        [
            [r[0, 0] - r[1, 1] - r[2, 2], 0, 0, 0],
            [r[1, 0] + r[0, 1], r[1, 1] - r[0, 0] - r[2, 2], 0, 0],
            [r[2, 0] + r[0, 2], r[2, 1] + r[1, 2], r[2, 2] - r[0, 0] - r[1, 1], 0],
            [r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1], np.trace(r)],
        ]
    )
    x, y, z, w = np.linalg.eigh(k)[1][:, -1]  # Bar-Itzhack 2000, J. Guidance 23, 1085
    q = np.array([w, x, y, z])
    return (q if w >= 0 else -q).tolist()

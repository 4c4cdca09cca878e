"""A MATLAB table: pose, face, arm, camera and pixels, 13 joints (rad), position of the reflector (m). Each reading is repeated for each marker."""

import numpy as np
from scipy.io import loadmat


def read(folder, options):
    table = loadmat(folder / options["file"])["dataset"]
    joints = slice(7, 13) if options["arm"] == "right" else slice(13, 19)
    rows, seen = [], set()
    for line in table:
        key = tuple(line[6:22])
        if key in seen or not np.isfinite(line[19:22]).all() or not np.abs(line[19:22]).sum() > 0:
            continue
        seen.add(key)
        rows.append(
            {
                "pose": str(int(line[0])),
                "target": "reflector",
                "joints": np.degrees(line[joints]).tolist(),
                "xyz": (1e3 * line[19:22]).tolist(),
            }
        )
    return [f"q{k}_deg" for k in range(1, 7)], rows

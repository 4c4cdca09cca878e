"""A MATLAB table: seven joints (rad), seven torques (N m), and the pose of the probe as a matrix row by row (mm)."""

import numpy as np
from scipy.io import loadmat

from prepare import quaternion


def read(folder, options):
    table = loadmat(folder / options["file"])[options["variable"]]
    rows = []
    for number, line in enumerate(table, 1):
        pose = line[14:30].reshape(4, 4)
        if options.get("rows") and not options["rows"][0] <= number <= options["rows"][1]:
            continue
        rows.append(
            {
                "pose": str(number),
                "target": "probe",
                "joints": np.degrees(line[:7]).tolist(),
                "xyz": pose[:3, 3].tolist(),
                "q": quaternion(pose[:3, :3]),
            }
        )
    return [f"q{k}_deg" for k in range(1, 8)], rows

"""A pickle of lists: joints (rad) and poses of a camera against a board (m). Only arrays are read from it, no other class."""

import pickle

import numpy as np

from prepare import quaternion


class Arrays(pickle.Unpickler):
    def find_class(self, module, name):
        if (module, name) == ("numpy.core.multiarray", "_reconstruct"):
            return np._core.multiarray._reconstruct
        if (module, name) in (("numpy", "ndarray"), ("numpy", "dtype")):
            return getattr(np, name)
        raise pickle.UnpicklingError(f"{module}.{name} is refused")


def read(folder, options):
    with open(folder / "calib_data.pickle", "rb") as file:
        data = Arrays(file).load()
    rows = []
    for number, (q, pose) in enumerate(zip(data["joint_positions"], data["camera_poses"]), 1):
        pose = np.asarray(pose, float).reshape(4, 4)
        rows.append(
            {
                "pose": str(number),
                "target": "camera",
                "joints": np.degrees(np.asarray(q, float)).ravel()[:7].tolist(),
                "xyz": (1e3 * pose[:3, 3]).tolist(),
                "q": quaternion(pose[:3, :3]),
            }
        )
    return [f"q{k}_deg" for k in range(1, 8)], rows

"""YAML of a map: two joints (rad) and the pose of a target in the frame of a camera (m, quaternion), a value a line."""

import math
import re


def read(folder, options):
    rows, entry = [], {}
    for line in (folder / "positioner_kinematic_measurements.yaml").read_text().splitlines():
        if re.match(r"\S", line):
            entry = {"joints": []}
            rows.append(entry)
        elif found := re.match(r"\s+- (\S+)$", line):
            entry["joints"].append(math.degrees(float(found[1])))
        elif found := re.match(r"\s+(q[wxyz]|[xyz]): (\S+)$", line):
            entry[found[1]] = float(found[2])
    rows = [
        {
            "pose": str(k),
            "target": "target",
            "joints": e["joints"],
            "xyz": [1e3 * e[a] for a in "xyz"],
            "q": [e[f"q{a}"] for a in "wxyz"],
        }
        for k, e in enumerate(rows, 1)
    ]
    return ["q1_deg", "q2_deg"], rows

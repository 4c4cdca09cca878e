"""Series of a UR10: joints (rad), position (mm) and three angles (deg) of a T-Mac in the frame of the tracker, decimal commas."""

import csv
import math

import numpy as np

from prepare import quaternion

JOINTS = ["shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3"]


def axis(k, angle):
    c, s = math.cos(angle), math.sin(angle)
    i, j = (k + 1) % 3, (k + 2) % 3
    m = np.eye(3)
    m[i, i] = m[j, j] = c
    m[i, j], m[j, i] = -s, s
    return m


def read(folder, options):
    rows = []
    for series in options["series"]:
        with open(folder / series["file"], newline="") as file:
            for number, line in enumerate(csv.DictReader(file, delimiter=";"), 1):
                if number % series.get("each", 1):
                    continue
                value = lambda name: float(line[name].replace(",", "."))
                angles = [math.radians(value(f"measurement_r{a}")) for a in "xyz"]
                turned = axis(0, angles[0]) @ axis(1, angles[1]) @ axis(2, angles[2])
                rows.append(
                    {
                        "pose": f"{series['name']}{number}",
                        "series": series["name"],
                        "target": "tmac",
                        "joints": [math.degrees(value(f"{j}_joint")) for j in JOINTS],
                        "xyz": [value(f"measurement_{a}") for a in "xyz"],
                        "q": quaternion(turned),
                    }
                )
    return [f"q{k}_deg" for k in range(1, 7)], rows

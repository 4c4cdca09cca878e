"""CSV of four markers (m; the fourth repeats the third) and eight joints (m and rad)."""

import csv

NAMES = ["torso_lift_joint"] + [f"arm_{k}_joint" for k in range(1, 8)]


def read(folder, options):
    rows = []
    with open(folder / "qualysis_base_hand_calibration.csv", newline="") as file:
        for number, line in enumerate(csv.DictReader(file), 1):
            joints = [float(line[n]) for n in NAMES]
            for marker in (1, 2, 3):
                xyz = [1e3 * float(line[f"{a}{marker}"]) for a in "xyz"]
                rows.append({"pose": str(number), "target": f"marker_{marker}", "joints": joints, "xyz": xyz})
    return [f"{NAMES[0]}_m"] + [f"{n}_rad" for n in NAMES[1:]], rows

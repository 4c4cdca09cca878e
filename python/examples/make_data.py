"""Write arm.toml and arm.csv of the first example: an invented arm with known errors, measured with a noise of 10 um."""

import csv
import sys
from pathlib import Path

import numpy as np

import etalon

FOLDER = Path(__file__).parent
JOINTS = [(0, 0, 0, 290), (-90, 0, -90, 0), (0, 270, 0, 0), (-90, 70, 0, 302), (90, 0, 0, 0), (-90, 0, 180, 72)]
ERRORS = {(1, 2): 0.05, (2, 1): 0.35, (2, 2): -0.08}  # (joint, column): mm or deg


def toml(joints):
    rows = "\n".join(f"    {{ alpha_deg = {al}, a_mm = {a}, theta_deg = {th}, d_mm = {d} }}," for al, a, th, d in joints)
    return f'# six axes like those of an ABB IRB 120 (invented)\nmodel = "serial"\nconvention = "mdh"\njoint = [\n{rows}\n]\n'


def main(folder):
    noise = np.random.default_rng(1)
    true = [[value + ERRORS.get((i, k), 0) for k, value in enumerate(row)] for i, row in enumerate(JOINTS)]
    joints = noise.uniform([-150, -80, -80, -150, -100, -170], [150, 80, 60, 150, 100, 170], (60, 6)).round(3)
    flange = etalon.kinematics.direct(etalon.Robot.from_toml(toml(true)), joints).matrix
    measured = (flange @ [30, 10, 60, 1])[:, :3] + noise.normal(0, 0.010, (60, 3))
    (folder / "arm.toml").write_text(toml(JOINTS))
    with open(folder / "arm.csv", "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["pose", "cycle", "target", *(f"q{i}_deg" for i in range(1, 7)), "x_mm", "y_mm", "z_mm"])
        for i, (q, p) in enumerate(zip(joints, measured), start=1):
            table.writerow([i, 1, "SMR", *q, *p.round(4)])


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else FOLDER)
    print("arm.toml, arm.csv")

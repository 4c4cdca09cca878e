#!/usr/bin/env python3
"""Makes mistakes on sets of real measurements, and reports what `etalon identify` says of each.

    slips.py PROGRAM SET [SET ...] [--poses 120] [--only TEXT] [--show]

PROGRAM is the program `etalon`. SET is a folder with

    robot.toml          the robot (and its URDF, if robot.toml names one)
    observations.csv    pose,cycle,target,x_mm,y_mm,z_mm and a column of each joint with its unit
    options.txt         optional: further options of `etalon identify`, for example --standard-uncertainty-um 10

A line is printed for the data as they are and for each mistake: signs, pairs and offsets of joints, degrees and radians, metres and
inches, a left-handed frame, a log shifted by a row, one wrong reading, two exchanged poses, and a set-up that moved. Its verdict is

    ok, exit 1          the data as they are: no cause is named (exit 1: an uncertainty exceeds its bound)
    ACCUSED             the data as they are: refused, or a cause is named
    named               the mistake is named, or listed as not shown by these data
    WRONG CAUSE         another cause is named
    refused, warned     no cause is named
    SILENT              nothing is said

--poses N takes at most N poses of a set, --only TEXT the mistakes whose name contains it, --show prints the answers.

Needs Python 3.9 or later.
"""

import argparse
import collections
import copy
import csv
import math
import pathlib
import re
import shlex
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor

FIXED = ["pose", "cycle", "target", "x_mm", "y_mm", "z_mm"]
POINT = FIXED[3:]
UNIT = re.compile(r"_(deg|rad|mm|m)$")


def name(joint):
    return UNIT.sub("", joint)


def poses(rows):
    return list(dict.fromkeys(row["pose"] for row in rows))


def joints_by_pose(rows, joints):
    found = {}
    for row in rows:
        found.setdefault(row["pose"], [row[joint] for joint in joints])
    return found


def each(change):
    """Applies a change to every row."""

    def apply(rows):
        for row in rows:
            change(row)

    return apply


def of_joints(joints):
    """Mistakes in the columns of the joints: name, words that name the mistake, change of the rows."""
    turning = [joint for joint in joints if joint.endswith(("_deg", "_rad"))]

    def scale(factor):
        return each(lambda row: row.update({joint: row[joint] * factor for joint in turning}))

    for joint in dict.fromkeys([turning[1], turning[len(turning) // 2], turning[-1]]):
        reverse = each(lambda row, joint=joint: row.update({joint: -row[joint]}))
        yield f"reversed {name(joint)}", [f"`{name(joint)}` reversed"], reverse
    pairs = [(0, 1)] if len(turning) < 4 else [(1, 2), (-3, -1), (-2, -1)]
    for a, b in [(turning[i], turning[k]) for i, k in pairs]:
        exchange = each(lambda row, a=a, b=b: row.update({a: row[b], b: row[a]}))
        yield f"exchanged {name(a)} {name(b)}", [f"`{name(a)}` and `{name(b)}` swapped"], exchange
    for joint in [turning[1], turning[-2]] if len(turning) > 2 else []:
        right_angle = 90 if joint.endswith("_deg") else math.pi / 2
        number = joints.index(joint) + 1
        words = [f"deg added to `{name(joint)}`", f"`theta_{number}` = ", f"`delta{number}` = "]
        offset = each(lambda row, joint=joint, by=right_angle: row.update({joint: row[joint] + by}))
        yield f"90 deg {name(joint)}", words, offset
    yield "degrees and radians", ["instead of"], scale(math.pi / 180 if turning[0].endswith("_deg") else 180 / math.pi)


def of_points():
    """Mistakes in all points."""
    yield "points m", ["points in metres"], each(lambda row: row.update({c: row[c] * 1e-3 for c in POINT}))
    yield "points inch", ["points in inches"], each(lambda row: row.update({c: row[c] / 25.4 for c in POINT}))
    yield "left-handed", ["mirrored"], each(lambda row: row.update({"z_mm": -row["z_mm"]}))


def of_poses(joints, rows):
    """Mistakes at some poses."""
    all_poses = poses(rows)
    wrong, first, second = (all_poses[int(share * len(all_poses))] for share in (0.4, 0.3, 0.6))

    def shift(rows):
        known, before = joints_by_pose(rows, joints), dict(zip(all_poses[1:], all_poses))
        for row in (row for row in rows if row["pose"] in before):
            row.update(zip(joints, known[before[row["pose"]]]))

    def misread(rows):
        next(row for row in rows if row["pose"] == wrong)["x_mm"] += 300

    def exchange(rows):
        known, other = joints_by_pose(rows, joints), {first: second, second: first}
        for row in (row for row in rows if row["pose"] in other):
            row.update(zip(joints, known[other[row["pose"]]]))

    def move(shift_mm):
        late = set(all_poses[int(0.6 * len(all_poses)) :])
        return each(
            lambda row: row["pose"] in late
            and row.update({"x_mm": row["x_mm"] + 0.6 * shift_mm, "z_mm": row["z_mm"] - 0.8 * shift_mm})
        )

    yield "rows shifted", ["previous pose", "next pose"], shift
    yield "one reading 300 mm", [f"pose {wrong},"], misread
    yield "two poses exchanged", [f"poses {first} and {second}", f"poses {second} and {first}"], exchange
    for shift_mm in (1, 3):
        yield f"moved {shift_mm} mm", ["from pose"], move(shift_mm)


def read(folder, most):
    with open(folder / "observations.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    joints = [c for c in rows[0] if c not in FIXED and UNIT.search(c) and not c.startswith(("u", "tau"))]
    for row in rows:
        row.update({column: float(row[column]) for column in [*joints, *POINT]})
    kept = set(poses(rows)[:: max(1, math.ceil(len(poses(rows)) / most))])
    return joints, [row for row in rows if row["pose"] in kept]


def identify(program, folder, rows):
    options = folder / "options.txt"
    options = shlex.split(options.read_text()) if options.exists() else []
    with tempfile.TemporaryDirectory() as scratch:
        table = pathlib.Path(scratch) / "observations.csv"
        with open(table, "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, rows[0].keys())
            writer.writeheader()
            writer.writerows(rows)
        robot = (folder / "robot.toml").resolve()
        command = [program, "identify", "--robot", robot, "--observations", table, *options]
        answer = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)
    return answer.returncode, answer.stderr


def verdict(what, words, code, said):
    cause = "check that first" in said
    if what == "as it is":
        return "ACCUSED" if cause or code == 2 else "ok" if code == 0 else "exit 1"
    if any(text in said for text in words):
        return "named"
    if cause:
        return "WRONG CAUSE"
    return "refused" if code == 2 else "warned" if code or "warning[outliers]" in said else "SILENT"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("program")
    parser.add_argument("sets", nargs="+", type=pathlib.Path)
    parser.add_argument("--poses", type=int, default=120)
    parser.add_argument("--only", default="")
    parser.add_argument("--show", action="store_true")
    arguments = parser.parse_args()
    total = collections.Counter()
    for folder in arguments.sets:
        joints, rows = read(folder, arguments.poses)
        cases = [("as it is", [], lambda rows: None), *of_joints(joints), *of_points(), *of_poses(joints, rows)]
        cases = [case for case in cases if arguments.only in case[0]]

        def answer(case):
            changed = copy.deepcopy(rows)
            case[2](changed)
            return identify(arguments.program, folder, changed)

        with ThreadPoolExecutor(2) as pool:
            answers = list(pool.map(answer, cases))
        print(f"{folder.name}: {len(rows)} rows")
        for (what, words, _), (code, said) in zip(cases, answers):
            found = verdict(what, words, code, said)
            total[found] += 1
            ids = " ".join(dict.fromkeys(re.findall(r"^(?:error|warning)\[([a-z0-9-]+)\]", said, re.M)))
            print(f"    {what:26} exit {code} {found:12} {ids}", flush=True)
            if arguments.show:
                print("\n".join("        " + line for line in said.splitlines()))
    print(", ".join(f"{count} {found}" for found, count in total.most_common()))


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Checks the uncertainties that etalon states on a set of real measurements.

    uncertainty.py PROGRAM SET [SET ...] [--seed 1] [--poses N] [--subsets 12] [--details] [--compare]

PROGRAM is the program `etalon`. SET is a folder with

    robot.toml          the robot (and its URDF, if robot.toml names one)
    observations.csv    pose,cycle,target,x_mm,y_mm,z_mm and a column of each joint with its unit
    options.txt         optional: further options of `etalon identify`, for example --standard-uncertainty-um 10

A row of the table is printed for each set. No truth is known, so the checks compare results of parts of a set with each other:

    poses       number of poses
    rms         RMS residual of a coordinate, all poses (mm)
    stated      standard uncertainty of a coordinate that options.txt states (mm)
    from        basis of the uncertainties of the fit to all poses, as the program states it
    u/instr     ratio of the uncertainties to those from the instrument alone, as the program states it (1 if none is stated)
    u par       RMS over the subsets of the predicted standard uncertainty of a coordinate, from parameters alone (mm)
    par         its largest value over its smallest, over random subsets of 70 % of the poses, at the poses that each leaves out
    +misfit     the same for parameters and misfit
    u own       the same ratio for the standard uncertainty of a parameter of the robot: median over the parameters
    cover       share of coordinates at left-out poses within 1.96 times the predicted standard deviation (%; expected: 95)
    pred/seen   predicted over seen RMS error at left-out poses
    z random    RMS over the parameters of the robot of z = (v1 - v2) / sqrt(u1^2 + u2^2) for random halves of the poses (expected: 1)
    z xyz       the same for halves by measured x, y and z (RMS of the three)
    z joints    the same for halves by each joint (RMS over the joints)
    z order     the same for the first and the second half of the rows
    z worst     the largest z of a split by region, and the split
    refused     numbers of fits without a result, of fits with a result and exit code 1 (implausible), and of all fits

With --compare, the sets are measurements of one robot, and z is printed for each pair of them.

The variance of an error at a left-out pose is J C J' + s^2. C is the covariance of the parameters, J the derivative of the position
with respect to the parameters, and s^2 the residual variance of the fit, rms^2 n / (degrees of freedom): misfit^2 + instrument^2.
Positions are those of `etalon kinematics direct --parameters`, so that every arm with one chain can be checked; derivatives are
differences of these.

Needs Python 3.9 or later and NumPy.
"""

import argparse
import copy
import csv
import json
import math
import pathlib
import random
import shlex
import subprocess
import sys
import tempfile

import numpy as np

STEP = {"mm": 0.01, "deg": 0.001, "1": 1e-5}  # of differences
FIXED_COLUMNS = ["pose", "cycle", "target", "x_mm", "y_mm", "z_mm"]


class Refused(Exception):
    """The program gave no result."""


class Set:
    """Rows of a set, by pose."""

    def __init__(self, folder, poses, draw):
        self.folder = pathlib.Path(folder)
        self.name = self.folder.resolve().name
        with open(self.folder / "observations.csv", newline="") as file:
            reader = csv.DictReader(file)
            rows = list(reader)
            self.columns = reader.fieldnames
        self.joints = [c for c in self.columns if c not in FIXED_COLUMNS]
        self.by_pose = {}
        for row in rows:
            self.by_pose.setdefault(row["pose"], []).append(row)
        self.poses = list(self.by_pose)
        if poses and poses < len(self.poses):
            chosen = set(draw.sample(self.poses, poses))
            self.poses = [p for p in self.poses if p in chosen]
        options = self.folder / "options.txt"
        self.options = shlex.split(options.read_text()) if options.exists() else []
        name = "--standard-uncertainty-um"
        self.stated_mm = float(self.options[self.options.index(name) + 1]) / 1000 if name in self.options else None

    def rows(self, poses):
        return [row for pose in poses for row in self.by_pose[pose]]

    def measured(self, poses):
        return np.array([[float(row[c]) for c in ("x_mm", "y_mm", "z_mm")] for row in self.rows(poses)])

    def value(self, pose, column):
        return sum(float(row[column]) for row in self.by_pose[pose]) / len(self.by_pose[pose])


class Program:
    """The program on one set."""

    def __init__(self, path, data, folder):
        self.path, self.data, self.folder = path, data, pathlib.Path(folder)
        self.fits = self.refused = self.implausible = 0
        self.reasons = {}

    def run(self, *arguments):
        done = subprocess.run([self.path, *map(str, arguments)], capture_output=True, text=True)
        try:
            return json.loads(done.stdout), done.returncode
        except json.JSONDecodeError:
            lines = [line for line in done.stderr.splitlines() if line.strip()]
            raise Refused(lines[0] if lines else f"exit code {done.returncode}") from None

    def identify(self, poses):
        table = self.folder / "observations.csv"
        with open(table, "w", newline="") as file:
            writer = csv.DictWriter(file, self.data.columns)
            writer.writeheader()
            writer.writerows(self.data.rows(poses))
        self.fits += 1
        robot = self.data.folder / "robot.toml"
        try:
            document, code = self.run("identify", "--robot", robot, "--observations", table, "--json", *self.data.options)
        except Refused as refusal:
            self.refused += 1
            self.reasons[str(refusal)] = self.reasons.get(str(refusal), 0) + 1
            raise
        self.implausible += code != 0
        return Fit(document, code)

    def flange(self, document, poses):
        """Positions and rotations of the flange in the base, a row for each observation."""
        table, parameters = self.folder / "joints.csv", self.folder / "parameters.json"
        with open(table, "w", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(["pose", *self.data.joints])
            writer.writerows([pose, *(self.data.by_pose[pose][0][j] for j in self.data.joints)] for pose in poses)
        parameters.write_text(json.dumps(document))
        robot = self.data.folder / "robot.toml"
        answer, _ = self.run("kinematics", "direct", table, "--robot", robot, "--parameters", parameters, "--json")
        found = {str(entry["pose"]): entry for entry in answer["poses"]}
        if any(pose not in found for pose in poses):
            raise Refused("kinematics without an answer for some poses")
        at = [found[row["pose"]] for row in self.data.rows(poses)]
        return np.array([e["xyz_mm"] for e in at]), rotations(np.array([e["quaternion"] for e in at]))


class Fit:
    """Parameters of a fit, with covariance."""

    def __init__(self, document, code):
        self.document, self.code = document, code
        entries = document["parameters"]
        self.entries = {p["name"]: p for p in entries}
        self.values = {p["name"]: p["value"] for p in entries}
        self.u = {p["name"]: p["standard_uncertainty"] for p in entries if p["status"] == "identified"}
        without = set(document.get("covariance_without") or [])
        self.free = [n for n in self.u if n not in without]
        self.covariance = np.array(document["covariance"])
        if self.covariance.shape != (len(self.free), len(self.free)):
            raise Refused("no covariance")
        residuals = document["residuals"]
        self.rms = residuals["rms"]
        self.s2 = self.rms**2 * residuals["count"] / max(residuals["degrees_of_freedom"], 1)
        self.basis = residuals.get("uncertainties_from", "").removeprefix("residuals_by_")
        self.enlarged = residuals.get("uncertainties_enlarged_by", 1.0)

    def own(self):
        return [n for n in self.u if self.entries[n]["role"] == "robot"]


def rotations(q):
    w, x, y, z = q.T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.array(rows).transpose(2, 0, 1)


def turned_by(vector):
    """Rotation matrix of a rotation vector (rad)."""
    angle = np.linalg.norm(vector)
    if angle == 0:
        return np.eye(3)
    x, y, z = np.asarray(vector) / angle
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * k + (1 - math.cos(angle)) * (k @ k)


def positions(values, flange, targets):
    """Positions of the targets in the world, a row for each observation."""
    xyz, turn = flange
    places = np.array([[values[f"{t}_{c}"] for c in "xyz"] for t in targets])
    in_base = xyz + np.einsum("nij,nj->ni", turn, places)
    base = turned_by(np.radians([values[f"base_r{c}"] for c in "xyz"]))
    return in_base @ base.T + np.array([values[f"base_{c}"] for c in "xyz"])


def derivatives(program, fit, poses):
    """Derivative of each coordinate by each identified parameter, at the values of this fit: observations, coordinates, parameters.

    It has to be that of this fit: where large uncertainties of two parameters cancel, the derivatives of another fit do not cancel them.
    """
    targets = [row["target"] for row in program.data.rows(poses)]
    flange = program.flange(fit.document, poses)

    def at(number, entry, by):
        if entry["role"] != "robot":
            return positions({**fit.values, entry["name"]: entry["value"] + by}, flange, targets)
        document = copy.deepcopy(fit.document)
        document["parameters"][number]["value"] += by
        return positions(fit.values, program.flange(document, poses), targets)

    columns = []
    numbers = {entry["name"]: number for number, entry in enumerate(fit.document["parameters"])}
    for name in fit.free:
        number, entry = numbers[name], fit.entries[name]
        step = STEP[entry["unit"]]
        columns.append((at(number, entry, step) - at(number, entry, -step)) / (2 * step))
    return np.stack(columns, axis=-1)


def halves(data, draw):
    """Splits of the poses in two halves: by region, by order, and at random."""
    middle = len(data.poses) // 2
    for column in ["x_mm", "y_mm", "z_mm", *data.joints]:
        ordered = sorted(data.poses, key=lambda p: data.value(p, column))
        if data.value(ordered[0], column) != data.value(ordered[-1], column):
            yield column, ordered[:middle], ordered[middle:]
    yield "order", data.poses[:middle], data.poses[middle:]
    for i in range(3):
        mixed = draw.sample(data.poses, len(data.poses))
        yield f"random {i + 1}", mixed[:middle], mixed[middle:]


def z_of(first, second):
    """z of each parameter of the robot that both fits identified."""
    both = [n for n in first.own() if n in second.u]
    return {n: (first.values[n] - second.values[n]) / math.hypot(first.u[n], second.u[n]) for n in both}


def rms(values):
    values = np.asarray(list(values), dtype=float)
    return float(np.sqrt(np.mean(values**2))) if values.size else math.nan


def ratio(values):
    return max(values) / min(values) if values and min(values) > 0 else math.nan


class LeftOut:
    """Errors at poses that random subsets leave out, beside their prediction."""

    def __init__(self):
        self.of_parameters, self.with_misfit, self.inside, self.predicted, self.seen, self.own = [], [], [], [], [], {}

    def add(self, program, fit, left):
        data = program.data
        targets = [row["target"] for row in data.rows(left)]
        errors = data.measured(left) - positions(fit.values, program.flange(fit.document, left), targets)
        jacobian = derivatives(program, fit, left)
        variance = np.einsum("nci,ij,ncj->nc", jacobian, fit.covariance, jacobian, optimize=True)
        misfit2 = max(fit.s2 - (data.stated_mm or 0.0) ** 2, 0.0)
        self.of_parameters.append(math.sqrt(variance.mean()))
        self.with_misfit.append(math.sqrt(variance.mean() + misfit2))
        self.inside.append(float(np.mean(np.abs(errors) <= 1.96 * np.sqrt(variance + fit.s2))))
        self.predicted.append(math.sqrt(variance.mean() + fit.s2))
        self.seen.append(rms(errors.ravel()))
        for name in fit.own():
            self.own.setdefault(name, []).append(fit.u[name])
        return (
            f"rms {fit.rms:.4f}, from {fit.basis}, enlarged by {fit.enlarged:.1f}, u of parameters {self.of_parameters[-1]:.4f}, "
            f"predicted {self.predicted[-1]:.4f}, seen {self.seen[-1]:.4f} mm, inside {100 * self.inside[-1]:.1f} %"
        )

    def own_ratio(self):
        """Median over the parameters that all subsets identify."""
        ratios = [ratio(us) for us in self.own.values() if len(us) == len(self.seen)]
        return float(np.median(ratios)) if ratios else math.nan


def whole_set(program, details):
    """Fit to all poses. Its residuals have to be those of the kinematics with which predictions are computed."""
    data = program.data
    fit = program.identify(data.poses)
    targets = [row["target"] for row in data.rows(data.poses)]
    again = rms((data.measured(data.poses) - positions(fit.values, program.flange(fit.document, data.poses), targets)).ravel())
    if abs(again / fit.rms - 1) > 0.01:
        details.append(f"RMS residual {again:.4f} mm by kinematics, {fit.rms:.4f} mm by the fit")
    messages = sorted({m["id"] for m in fit.document.get("messages", [])})
    details.append(f"all poses: exit code {fit.code}, {len(fit.own())} own parameters, messages: {', '.join(messages)}")
    return fit


def subsets(program, draw, count, details):
    left_out = LeftOut()
    poses = program.data.poses
    for number in range(count):
        kept = set(draw.sample(poses, round(0.7 * len(poses))))
        try:
            fit = program.identify([p for p in poses if p in kept])
            text = left_out.add(program, fit, [p for p in poses if p not in kept])
        except Refused:
            continue
        details.append(f"subset {number + 1}: {text}")
    return left_out


def splits(program, draw, details):
    """z of each split, by its name: RMS over the parameters of the robot."""
    z = {}
    for name, one, other in halves(program.data, draw):
        try:
            first, second = program.identify(one), program.identify(other)
        except Refused:
            continue
        each = z_of(first, second)
        z[name] = rms(each.values())
        held = "" if set(first.own()) == set(second.own()) else "; other parameters are held"
        basis = f"{first.basis}/{second.basis}"
        details.append(f"halves by {name}: z {z[name]:.2f} of {len(each)} parameters, from {basis} ({largest(each)}){held}")
    return z


def largest(each):
    return ", ".join(f"{n} {each[n]:+.1f}" for n in sorted(each, key=lambda n: -abs(each[n]))[:3])


def check(path, data, arguments, folder):
    draw = random.Random(arguments.seed)
    program = Program(path, data, folder)
    details = []
    whole = whole_set(program, details)
    left_out = subsets(program, draw, arguments.subsets, details)
    z = splits(program, draw, details)
    details += [f"refused {count} times: {reason}" for reason, count in program.reasons.items()]

    def of(names):
        return f"{rms(z[n] for n in names if n in z):.2f}"

    region = {n: v for n, v in z.items() if not n.startswith("random") and not math.isnan(v)}
    worst = max(region, key=region.get, default=None)
    row = {
        "set": data.name,
        "poses": len(data.poses),
        "rms": f"{whole.rms:.4f}",
        "stated": f"{data.stated_mm:.3f}" if data.stated_mm else "-",
        "from": whole.basis,
        "u/instr": f"{whole.enlarged:.1f}",
        "u par": f"{rms(left_out.of_parameters):.4f}",
        "par": f"{ratio(left_out.of_parameters):.2f}",
        "+misfit": f"{ratio(left_out.with_misfit):.2f}",
        "u own": f"{left_out.own_ratio():.2f}",
        "cover": f"{100 * np.mean(left_out.inside):.1f}" if left_out.inside else "-",
        "pred/seen": f"{rms(left_out.predicted) / rms(left_out.seen):.2f}",
        "z random": of(n for n in z if n.startswith("random")),
        "z xyz": of(["x_mm", "y_mm", "z_mm"]),
        "z joints": of(data.joints),
        "z order": of(["order"]),
        "z worst": f"{region[worst]:.2f} ({worst.rsplit('_', 1)[0]})" if worst else "-",
        "refused": f"{program.refused}/{program.implausible}/{program.fits}",
    }
    return row, details


WIDTHS = {  # of the columns, in their order; negative: left-aligned
    "set": -14, "poses": 5, "rms": 7, "stated": 6, "from": -10, "u/instr": 7, "u par": 7, "par": 5, "+misfit": 7, "u own": 5, "cover": 5,
    "pred/seen": 9, "z random": 8, "z xyz": 5, "z joints": 8, "z order": 7, "z worst": -28, "refused": 7,
}


def line(row):
    cells = (str(row[name]).ljust(-width) if width < 0 else str(row[name]).rjust(width) for name, width in WIDTHS.items())
    return "  ".join(cells).rstrip()


def compare(path, sets, folder):
    """z of each pair of sets of one robot."""
    fits = {}
    for data in sets:
        try:
            fits[data.name] = Program(path, data, folder).identify(data.poses)
        except Refused as refusal:
            print(f"{data.name}: refused: {refusal}")
    for number, one in enumerate(fits):
        for other in list(fits)[number + 1 :]:
            each = z_of(fits[one], fits[other])
            print(f"{one:14} {other:14} z {rms(each.values()):5.2f} of {len(each)} parameters ({largest(each)})")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("sets", nargs="+", metavar="SET")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--poses", type=int, metavar="N", help="use N poses of a set, drawn at random, if it has more")
    parser.add_argument("--subsets", type=int, default=12, metavar="N")
    parser.add_argument("--details", action="store_true", help="print every subset and split below the row")
    parser.add_argument("--compare", action="store_true", help="compare the sets, which are of one robot")
    arguments = parser.parse_args()
    if arguments.compare:
        with tempfile.TemporaryDirectory() as scratch:
            sets = [Set(folder, arguments.poses, random.Random(arguments.seed)) for folder in arguments.sets]
            compare(arguments.program, sets, scratch)
        return 0
    print(line({name: name for name in WIDTHS}), flush=True)
    failed = False
    for folder in arguments.sets:
        data = Set(folder, arguments.poses, random.Random(arguments.seed))
        with tempfile.TemporaryDirectory() as scratch:
            try:
                row, details = check(arguments.program, data, arguments, scratch)
            except Refused as refusal:
                print(f"{data.name}: refused: {refusal}", flush=True)
                failed = True
                continue
        print(line(row), flush=True)
        if arguments.details:
            print(*(f"    {text}" for text in details), sep="\n", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

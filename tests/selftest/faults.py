#!/usr/bin/env python3
"""Seeded faults: builds the program with each of 32 faults (a sign, a constant, an index) and requires that
`etalon selftest` ends with 1.

    tests/selftest/faults.py --check           every fault applies to the sources exactly once
    tests/selftest/faults.py                   all faults, one build each (about an hour)
    tests/selftest/faults.py 3 7 12            these faults
    tests/selftest/faults.py --groups          faults with disjoint tests are built together

Works in a git worktree of its own, `target/faults`, and leaves the checkout as it is. With --groups, each fault must fail a test
that no other fault of its group can fail (the pattern of the fault, on `requirement: test`).
"""

import argparse
import json
import os
import pathlib
import re
import subprocess
import sys

# file, text, text with the fault, pattern of the tests that only this fault fails in its group
FAULTS = [
    # base
    ("src/base/geometry/pose.rs", "translation_mm: t.map(|v| -v) }", "translation_mm: t.map(|v| v) }", r"frames: transform composed"),
    ("src/base/geometry/pose.rs", "(sin / angle, (T::from(1.0) - cos) / square, cos)",
     "(sin / angle, (T::from(1.0) - cos) / angle, cos)", r"frames: rotation matrix of a rotation vector"),
    ("src/base/geometry/pose.rs", "[1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)]",
     "[1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z + w * y)]", r"frames: rotation of a quaternion"),
    ("src/base/geometry/scalar.rs", "self.combine(other, quotient, 1.0 / other.value, -quotient / other.value)",
     "self.combine(other, quotient, 1.0 / other.value, quotient / other.value)", r"uncertainty: u_ohm"),
    ("src/base/noise.rs", "((-2.0 * (1.0 - self.unit()).ln()).sqrt()", "((-2.1 * (1.0 - self.unit()).ln()).sqrt()",
     r"uncertainty: normal: standard uncertainty"),
    # math
    ("src/math/statistics.rs", "values.len().saturating_sub(1).max(1) as f64", "values.len().max(1) as f64",
     r"uncertainty: u_means"),
    ("src/math/least_squares.rs", "local[k] / (scale[k / n] * scale[k % n])", "local[k] / (scale[k / n] * scale[k / n])",
     r"solver: line: covariance"),
    # fit
    ("src/fit/solver.rs", "self.cost / degrees_of_freedom as f64", "self.cost / (degrees_of_freedom + 1) as f64",
     r"fits: sphere: standard uncertainty"),
    ("src/fit/elements/torus.rs", "-g_rho, F64x8::all(-1.0)])]", "-g_rho, F64x8::all(1.0)])]", r"fits: torus: (point|radius|sum|not)"),
    ("src/fit/rigid.rs", "[yz - zy, xx - yy - zz, xy + yx, zx + xz]", "[yz - zy, xx - yy - zz, xy + yx, zx - xz]",
     r"frames: transform between two sets"),
    # robots
    ("src/robots/five_bar.rs", "let b1 = [l11 * along1[0] - d * 0.5, l11 * along1[1]];",
     "let b1 = [l11 * along1[0] - d * 0.5, l21 * along1[1]];",
     r"kinematics: five_bar: positions"),
    ("src/robots/prexyt.rs", "let rho3 = (t * (s - d3 * beta.tan() - x) + y - d3)", "let rho3 = (t * (s + d3 * beta.tan() - x) + y - d3)",
     r"kinematics: prexyt: direct\(inverse"),
    ("src/robots/delta.rs", "turn_y(q + p[6]).shift(0, p[5])", "turn_y(q - p[6]).shift(0, p[5])", r"kinematics: delta: positions"),
    ("src/robots/delta.rs", ".turn_y(p[1]).turn_x(p[2])", ".turn_x(p[1]).turn_y(p[2])", r"kinematics: delta_linear: positions"),
    ("src/robots/hexapod.rs", "platform_mm: [p[3], p[4], p[5]], length_mm", "platform_mm: [p[3], p[5], p[4]], length_mm",
     r"kinematics: hexapod: positions"),
    ("src/robots/serial.rs", '(2.0, "cos2", false)', '(1.0, "cos2", false)', r"kinematics: serial mdh: positions"),
    ("src/campaign/robot/urdf.rs", "xyz.map(|m| 1000.0 * m)", "xyz.map(|m| 100.0 * m)", r"kinematics: urdf: positions"),
    # identify
    ("src/identify/model/prior.rs", "scale * p.tolerance / 3f64.sqrt()", "scale * p.tolerance / 2f64.sqrt()",
     r"reference: prexyt-priors: (not possible|\d+ parameters|standard)"),
    ("src/identify/model/kinds/distance.rs", "(0..3).for_each(|i| out[self.to + i] -= along[i]);",
     "(0..3).for_each(|i| out[self.to + i] += along[i]);", r"reference: serial-poe-distances: (not possible|\d+ parameters|standard)"),
    ("src/identify/model/kinds/orientation.rs", "body.then(&self.world_T_body(at.values).inverse()).rotation_vector_rad()",
     "body.then(&self.world_T_body(at.values).inverse()).rotation_vector_rad().map(|v| 1.01 * v)", r"reference: urdf-poses: (not possible|\d+ parameters|standard)"),
    ("src/identify/model/kinds/contact.rs", "out[i * at.values.len() + self.socket + i] -= 1.0",
     "out[i * at.values.len() + self.socket + i] -= 1.1", r"reference: serial-mdh-contacts: (not possible|\d+ parameters|standard)"),
    # stages
    ("src/stages/evaluate/accuracy.rs", "    Statistics { mean, rms, p95, max }", "    Statistics { mean, rms: mean, p95, max }",
     r"reference: prexyt-clean: errors"),
    # standards
    ("src/standards/iso230.rs", "repeatability_mm: 4.0 * estimator_mm })", "repeatability_mm: 3.0 * estimator_mm })",
     r"standards: r_forward_nm"),
    ("src/standards/iso9283/pose/characteristics/repeatability.rs", "        radius.mean + 3.0 * radius.deviation\n",
     "        radius.mean + 2.0 * radius.deviation\n", r"standards: RP$"),
    ("src/standards/iso9283/pose/characteristics/directions.rs", "if b.0 > a.0 { b } else { a }", "if b.0 < a.0 { b } else { a }", r"standards: vAP"),
    ("src/standards/iso9283/load.rs", "|(r, d)| r.force_n * d).sum::<f64>() / squares", "|(_, d)| d).sum::<f64>() / squares",
     r"standards: compliance"),
    ("src/standards/decision.rs", "cdf((limit - value) / standard_uncertainty)", "cdf((value - limit) / standard_uncertainty)",
     r"uncertainty: probability of conformity"),
    # formats
    ("src/formats/dialect/description.rs", "Self::Inch => 25.4,", "Self::Inch => 25.0,", r"formats: polyworks in inch: known"),
    ("src/formats/dialect/description.rs", "Self::Metre => 1000.0,", "Self::Metre => 100.0,", r"formats: xyz in m: known"),
    # controllers
    ("src/controllers/code/mod.rs", 'Operation::Subtract(..) => infix(" - "),', 'Operation::Subtract(..) => infix(" + "),',
     r"kinematics: prexyt: position computed by the exported"),
    ("src/controllers/json.rs", "Parameter { value: p.value, unit", "Parameter { value: p.nominal, unit", r"exports: json: values"),
    ("src/controllers/templates/genhexkins.hal.j2", '["platform", "a"]', '["platform", "b"]', r"exports: linuxcnc-hexapod"),
]

# faults of one group fail tests that no other fault of the group can fail
GROUPS = [
    [7, 8, 9, 10, 11, 12, 13, 14, 15, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30],
    [0, 1, 2, 4, 5, 6],
    [3, 16, 31],
]

ROOT = pathlib.Path(__file__).resolve().parents[2]


def applied(folder, numbers):
    for number in numbers:
        name, before, after, _ = FAULTS[number]
        path = folder / name
        text = path.read_text(encoding="utf-8")
        if text.count(before) != 1:
            sys.exit(f"fault {number} applies {text.count(before)} times to {name}: {before}")
        path.write_text(text.replace(before, after), encoding="utf-8")


def git(*arguments):
    return subprocess.run(["git", *arguments], check=True, capture_output=True, text=True, cwd=ROOT).stdout


def selftest(folder, flags):
    """Builds the program in a folder and runs its self test; None if it does not compile."""
    build = subprocess.run(["cargo", "build", "--locked", "--release", "--bin", "etalon", *flags], cwd=folder, capture_output=True,
                           text=True)
    if build.returncode != 0:
        print(build.stderr[-3000:])
        return None
    target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", folder / "target"))
    ran = subprocess.run([target / "release/etalon", "selftest", "--json"], capture_output=True, text=True, cwd=folder)
    failed = []
    if ran.stdout:
        for requirement in json.loads(ran.stdout)["requirements"]:
            failed += [f"{requirement['id']}: {check['test']}" for check in requirement["checks"] if not check["pass"]]
    return ran.returncode, failed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("numbers", nargs="*", type=int)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--groups", action="store_true")
    parser.add_argument("--flags", default="", help="arguments of cargo, for an unoptimised build")
    options = parser.parse_args()
    if options.check:
        for number, (name, before, after, _) in enumerate(FAULTS):
            count = (ROOT / name).read_text(encoding="utf-8").count(before)
            if count != 1 or before == after:
                sys.exit(f"fault {number} applies {count} times to {name}")
        print(f"{len(FAULTS)} faults apply")
        return
    folder = pathlib.Path(os.environ.get("ETALON_FAULTS", ROOT / "target/faults"))
    if not folder.exists():
        git("worktree", "add", "--detach", str(folder), "HEAD")
    grouped = {number for group in GROUPS for number in group}
    groups = GROUPS + [[n] for n in range(len(FAULTS)) if n not in grouped] if options.groups else [[n] for n in range(len(FAULTS))]
    if options.numbers:
        groups = [[n] for n in options.numbers]
    escaped = []
    for group in groups:
        subprocess.run(["git", "checkout", "--quiet", "--", "."], check=True, cwd=folder)
        applied(folder, group)
        result = selftest(folder, options.flags.split())
        code, failed = result or (None, [])
        for number in group:
            own = [test for test in failed if re.search(FAULTS[number][3], test)] if len(group) > 1 else failed
            noticed = code == 1 and bool(own)
            print(f"fault {number:2} {'noticed' if noticed else 'ESCAPED'}: {FAULTS[number][0]}: {(own or ['-'])[0][:90]}", flush=True)
            if not noticed:
                escaped.append(number)
    subprocess.run(["git", "checkout", "--quiet", "--", "."], check=True, cwd=folder)
    print(f"{sum(map(len, groups)) - len(escaped)} of {sum(map(len, groups))} faults are noticed")
    sys.exit(1 if escaped else 0)


main()

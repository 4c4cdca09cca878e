#!/usr/bin/env python3
"""Makes the reference campaigns: data from a seed, files of the campaign, and certified values.

    make.py FOLDER              writes every campaign into FOLDER
    make.py FOLDER NAME...      writes these campaigns
    make.py --check FOLDER      computes the certified values again from the files in FOLDER and compares them

It needs Python 3.9 and mpmath, and shares nothing with etalon.
"""

import csv
import hashlib
import json
import sys
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from mpmath import mp, mpf, sqrt

import campaigns
from estimation import (
    Contact, Distance, Group, KnownDistance, Orientation, Position, Problem, dependent, errors, flange_at, minimise,
    statistics,
)
from kinematics import inward, norm, of_quaternion, outward

STORED = 30
"""Significant digits of certified values in the files."""
PERMISSIBLE = "1e-9"
"""Maximum permissible error, relative to the scale of a value."""


def number(text):
    return mpf(text.strip())


def read(campaign, model, folder):
    """Groups of readings of a campaign, from the files that every program reads."""
    groups = {}
    known = []
    with open(folder / "observations.csv", newline="") as file:
        for row in csv.DictReader(file):
            kind = row.get("kind") or "point"
            if not row["pose"]:
                u = number(row["u_mm"])
                known.append(KnownDistance(row["target"], row["other"], number(row["distance_mm"]), u))
                continue
            pose = int(row["pose"])
            joints = [
                inward(unit, row[f"{name}_{unit}" if unit else name].strip()) for name, unit in model.joints
            ]
            group = groups.setdefault(pose, Group(pose, joints, []))
            u = campaign.sigma_mm
            if kind in ("point", "pose"):
                at = [number(row[f"{k}_mm"]) for k in "xyz"[: model.dimension]]
                group.readings.append(Position(row["target"], at, u))
            if kind == "pose":
                rotation = of_quaternion(*(number(row[f"q{k}"]) for k in "wxyz"))
                group.readings.append(Orientation(row["target"], rotation, campaign.sigma_rad))
            if kind == "distance":
                group.readings.append(Distance(row["target"], row["other"], number(row["distance_mm"]), u))
            if kind == "contact":
                group.readings.append(Contact(row["target"], row["socket"], u))
    return list(groups.values()), known


def order(model, names):
    """Order in which parameters take up what is not separable: base, targets and fixtures of a robot in space first."""
    if model.dimension == 2:
        return names
    role = {p.name: p.role for p in model.parameters}
    return sorted(names, key=lambda name: role[name] == "robot")


def certify(campaign, folder):
    """Certified values of a campaign, as a mapping for certified.json."""
    model = campaign.build()
    groups, known = read(campaign, model, folder)
    calibration = [g for g in groups if g.pose <= campaign.calibration]
    left_out = campaign.left_out
    if left_out:
        pose, target = left_out
        kept = lambda g: Group(g.pose, g.joints, [r for r in g.readings if (g.pose, r.target) != (pose, target)])
        calibration = [kept(g) for g in calibration]
    tie = [Group(None, None, known)] if known else []
    parameters, start = model.parameters, campaign.true_values()
    wanted = [p.name for p in parameters if not campaign.is_held(p)]
    every = order(model, wanted)
    redundant = dependent(Problem(model, calibration + tie, every).jacobian(start), every)
    free = [name for name in wanted if name not in redundant]
    priors = campaign.priors()
    for p in parameters:
        if p.name not in free:
            start[p.name] = p.nominal
    problem = Problem(model, calibration + tie, free, priors)
    values, covariance = minimise(problem, start)
    before = frames_alone(campaign, Problem(model, calibration + tie, free, priors), values)
    check_noise(campaign, problem, values, covariance)
    found = {
        "schema": "etalon-reference/1",
        "campaign": campaign.name,
        "title": campaign.title,
        "synthetic": campaigns.SYNTHETIC,
        "files": {name: hashlib.sha256((folder / name).read_bytes()).hexdigest() for name in sorted(campaign.files)},
        "estimator": estimator(campaign),
        "calibration_poses": [g.pose for g in calibration],
        "validation_poses": [g.pose for g in groups if g.pose > campaign.calibration],
        "left_out": [{"pose": left_out[0], "target": left_out[1]}] if left_out else [],
    }
    found |= results(model, problem, (values, covariance, before, redundant))
    sets = [("calibration", calibration), ("validation", [g for g in groups if g.pose > campaign.calibration])]
    found["errors"] = [e for name, part in sets for e in error_entries(model, name, part, before, values)]
    return found


def frames_alone(campaign, problem, values):
    """The nominal robot with only base, targets and fixtures fitted; nothing if these have tolerances.

    The weight of such a tolerance beside the large residuals of a nominal robot is not defined by stated uncertainties.
    """
    model = problem.model
    role = {p.name: p.role for p in model.parameters}
    if any(role[name] != "robot" for name in problem.priors):
        return None
    start = {p.name: p.nominal if p.role == "robot" else values[p.name] for p in model.parameters}
    frames = [p.name for p in model.parameters if p.role != "robot" and not campaign.is_held(p)]
    unseen = dependent(Problem(model, problem.groups, frames).jacobian(start), frames)
    assert not unseen, f"{campaign.name}: {unseen} do not follow from the readings with a nominal robot"
    return minimise(Problem(model, problem.groups, frames), start)[0]


def estimator(campaign):
    entry = {"prior": "tolerances" if campaign.tolerances else "none"}
    entry["standard_uncertainty_mm"] = campaign.sigma_mm
    if campaign.sigma_rad:
        entry["standard_uncertainty_deg"] = outward("deg", campaign.sigma_rad)
    entry["covariance"] = "from the stated standard uncertainties"
    return entry


def degrees_of_freedom(problem, covariance, count):
    """Readings minus parameters, where a parameter counts by the share 1 - (u/s)^2 that the readings determine."""
    shares = [covariance[i][i] / problem.priors[n][1] ** 2 for i, n in enumerate(problem.free) if n in problem.priors]
    return count - len(problem.free) + sum(shares)


def check_noise(campaign, problem, values, covariance):
    """Chi-square and the median of the residuals agree with the stated uncertainty, so that it applies as stated."""
    r = [abs(v) for v in problem.residuals(values)]
    dof = degrees_of_freedom(problem, covariance, len(r))
    chi = sum(v * v for v in r) / dof
    assert 0.4 < chi < 1.4, f"{campaign.name}: chi-square over its degrees of freedom is {float(chi)}"
    if campaign.tolerances:
        median = sorted(r)[len(r) // 2] * mpf("1.4826") * sqrt(len(r) / dof)
        assert median < 1, f"{campaign.name}: the residuals exceed the stated uncertainty: {float(median)}"


def results(model, problem, found):
    """Parameters with their covariance, and the residuals."""
    values, covariance, before, redundant = found
    unit = {p.name: p.unit for p in model.parameters}
    place = {name: i for i, name in enumerate(problem.free)}
    entries = []
    for p in model.parameters:
        status = "identified" if p.name in place else "not_identifiable" if p.name in redundant else "fixed"
        value = outward(p.unit, values[p.name])
        entry = {"name": p.name, "unit": p.unit, "role": p.role, "status": status, "nominal": outward(p.unit, p.nominal)}
        if before:
            entry["before"] = outward(p.unit, before[p.name])
        entry["value"] = value
        if p.name in place:
            u = sqrt(covariance[place[p.name]][place[p.name]])
            entry["standard_uncertainty"] = outward(p.unit, u)
        entry["mpe"] = mpf(PERMISSIBLE) * max(abs(value), campaigns.SCALE[p.unit])
        entries.append(entry)
    factor = [outward(unit[name], mpf(1)) for name in problem.free]
    lower = [[covariance[i][j] * factor[i] * factor[j] for j in range(i + 1)] for i in range(len(factor))]
    # chi-square counts everything measured or known, the root mean square only what is measured as a length at a pose
    weighted = problem.residuals(values)
    lengths = []
    for g in problem.groups:
        for r, e in errors(model, values, g, flange_at(model, values, g)):
            if not isinstance(r, (Orientation, KnownDistance)):
                lengths += e
    return {
        "parameters": entries,
        "covariance": {"parameters": problem.free, "lower_triangle": lower, "mpe_relative": mpf(PERMISSIBLE)},
        "residuals": {
            "count": len(weighted),
            "rms_mm": sqrt(sum(v * v for v in lengths) / len(lengths)),
            "chi_square": sum(v * v for v in weighted),
            "degrees_of_freedom": degrees_of_freedom(problem, covariance, len(weighted)),
            "mpe_relative": mpf(PERMISSIBLE),
        },
    }


def error_entries(model, name, groups, before, after):
    """Statistics of the errors of a set: measured minus predicted values."""
    sizes = {}
    for side, p in (("before", before), ("after", after)):
        for g in groups if p else []:
            if hasattr(model, "errors_of"):
                measured = {r.target: r.at for r in g.readings}
                found = model.errors_of(p, g.joints, measured)
            else:
                kinds = {Position: "position", Orientation: "orientation", Distance: "distance", Contact: "contact"}
                found = [(kinds[type(r)], e) for r, e in errors(model, p, g, flange_at(model, p, g))]
            for quantity, e in found:
                sizes.setdefault(quantity, {"before": [], "after": []})[side].append(norm(e))
    for quantity, sides in sizes.items():
        unit = "deg" if quantity == "orientation" else "mm"
        entry = {"set": name, "quantity": quantity, "unit": unit, "count": len(sides["after"])}
        for side, all_sizes in ((side, sizes) for side, sizes in sides.items() if sizes):
            entry[side] = {k: outward(unit, v) for k, v in statistics(all_sizes).items()}
        yield entry | {"mpe": mpf(PERMISSIBLE) * campaigns.SCALE[unit]}


# Files


def text_of(value, indent=0):
    """JSON with all stored digits of every number."""
    if isinstance(value, mpf):
        return mp.nstr(value, STORED, min_fixed=-6, max_fixed=12)
    inner, outer = "  " * (indent + 1), "  " * indent
    plain = lambda v: not isinstance(v, (dict, list))
    if isinstance(value, dict) and value:
        parts = [f"{json.dumps(k)}: {text_of(v, indent + 1)}" for k, v in value.items()]
        if all(plain(v) for v in value.values()) and indent > 1:
            return "{" + ", ".join(parts) + "}"
        return "{\n" + ",\n".join(inner + part for part in parts) + f"\n{outer}}}"
    if isinstance(value, list) and value:
        parts = [text_of(v, indent + 1) for v in value]
        if all(plain(v) for v in value):
            return "[" + ", ".join(parts) + "]"
        return "[\n" + ",\n".join(inner + part for part in parts) + f"\n{outer}]"
    return json.dumps(value, ensure_ascii=False)


def make(name, root):
    """Writes one campaign."""
    campaign = campaigns.CAMPAIGNS[name]
    folder = root / name
    folder.mkdir(parents=True, exist_ok=True)
    for file, text in campaign.write().items():
        (folder / file).write_text(text, newline="\n")
    (folder / "certified.json").write_text(text_of(certify(campaign, folder)) + "\n", newline="\n")
    return name


def check(name, root):
    """Computes the certified values of one campaign again."""
    campaign = campaigns.CAMPAIGNS[name]
    campaign.write()
    found = text_of(certify(campaign, root / name)) + "\n"
    return name, found == (root / name / "certified.json").read_text()


def main(arguments):
    checks = arguments[:1] == ["--check"]
    root, *names = arguments[1:] if checks else arguments
    names = names or list(campaigns.CAMPAIGNS)
    with ProcessPoolExecutor() as pool:
        jobs = [pool.submit(check if checks else make, name, Path(root)) for name in names]
        results = [job.result() for job in jobs]
    for result in results:
        print(result)
    return 0 if not checks or all(same for _, same in results) else 1


if __name__ == "__main__":
    if not sys.argv[1:]:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1:]))

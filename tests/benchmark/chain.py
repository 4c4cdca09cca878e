"""Nominal chain of a robot.toml of etalon, for programs that read no such file.

A chain is a list of joints in order, each with the transform `origin` (4 x 4, mm) from the previous joint to its frame at joint value zero, its
kind, its axis, and the column of its value; a joint with a factor follows that column. `end` is the transform to the frame of the targets.
"""

import math
import pathlib
import tomllib
import xml.etree.ElementTree as xml

import numpy as np


def turn(axis, angle):
    x, y, z = np.asarray(axis, float) / np.linalg.norm(axis)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    t = np.eye(4)
    t[:3, :3] = np.eye(3) + math.sin(angle) * k + (1 - math.cos(angle)) * (k @ k)
    return t


def shift(x, y, z):
    t = np.eye(4)
    t[:3, 3] = x, y, z
    return t


def joint(origin, column, axis=(0, 0, 1), kind="revolute", factor=1.0, offset=0.0):
    return {
        "origin": np.asarray(origin).tolist(),
        "axis": list(map(float, axis)),
        "kind": kind,
        "column": column,
        "factor": factor,
        "offset": offset,
    }


def of_table(robot):
    """Denavit-Hartenberg parameters: standard (`dh`) or modified (the default)."""
    joints, after = [], np.eye(4)
    for number, row in enumerate(robot["joint"], 1):
        angle, a, d = (row.get(k, 0.0) for k in ("alpha_deg", "a_mm", "d_mm"))
        before = turn((1, 0, 0), math.radians(angle)) @ shift(a, 0, 0)
        rest = turn((0, 0, 1), math.radians(row.get("theta_deg", 0.0))) @ shift(0, 0, d)
        if robot.get("convention") == "dh":
            # the constant part of Rz Tz commutes with the turn about z
            joints.append(joint(after, f"q{number}_deg"))
            after = rest @ shift(a, 0, 0) @ turn((1, 0, 0), math.radians(angle))
        else:
            joints.append(joint(after @ before, f"q{number}_deg"))
            after = rest
    return joints, after


def of_axes(robot):
    """Screw axes in the base at joint values zero."""
    joints, last = [], np.eye(4)
    for number, row in enumerate(robot["joint"], 1):
        at = shift(*row["point_mm"])
        joints.append(joint(np.linalg.inv(last) @ at, f"q{number}_deg", row["direction"]))
        last = at
    return joints, np.linalg.inv(last) @ shift(*robot["flange_xyz_mm"])


def of_urdf(robot, folder):
    root = xml.parse(folder / robot["file"]).getroot()
    by_child = {j.find("child").get("link"): j for j in root.iter("joint") if j.find("child") is not None}
    link, chain = robot["tool_link"], []
    while link != robot["base_link"]:
        chain.insert(0, by_child[link])
        link = by_child[link].find("parent").get("link")
    joints, after = [], np.eye(4)
    for found in chain:
        origin = found.find("origin")
        numbers = lambda key: [float(v) for v in ((origin.get(key) if origin is not None else None) or "0 0 0").split()]
        (x, y, z), (r, p, w) = numbers("xyz"), numbers("rpy")
        here = shift(1e3 * x, 1e3 * y, 1e3 * z) @ turn((0, 0, 1), w) @ turn((0, 1, 0), p) @ turn((1, 0, 0), r)
        kind = found.get("type")
        if kind == "fixed":
            after = after @ here
            continue
        axis = found.find("axis")
        axis = [float(v) for v in axis.get("xyz").split()] if axis is not None else [1.0, 0.0, 0.0]
        mimic = found.find("mimic")
        name = mimic.get("joint") if mimic is not None else found.get("name")
        factor = float(mimic.get("multiplier", 1.0)) if mimic is not None else 1.0
        offset = float(mimic.get("offset", 0.0)) if mimic is not None else 0.0
        prismatic = kind == "prismatic"
        column = f"{name}_m" if prismatic else f"{name}_rad"
        offset *= 1e3 if prismatic else 1.0
        joints.append(joint(after @ here, column, axis, "prismatic" if prismatic else "revolute", factor, offset))
        after = np.eye(4)
    return joints, after


def chain(path):
    path = pathlib.Path(path)
    robot = tomllib.loads(path.read_text())
    if robot["model"] == "urdf":
        joints, end = of_urdf(robot, path.parent)
    elif robot.get("convention") == "poe":
        joints, end = of_axes(robot)
    else:
        joints, end = of_table(robot)
    return {"joints": joints, "end": end.tolist()}

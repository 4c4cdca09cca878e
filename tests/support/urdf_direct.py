"""Direct kinematics of a URDF by its specification: python3 urdf_direct.py FILE BASE TOOL < joint values.

A line of input holds joint values (rad, m) by name as JSON; a line of output the tool in the base: x y z (mm), then its rotation row by row.
"""

import json
import math
import sys
import xml.etree.ElementTree as ElementTree

file, base, tool = sys.argv[1:4]
joints = {joint.find("child").get("link"): joint for joint in ElementTree.parse(file).getroot().iter("joint") if joint.find("child") is not None}
AXES = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0])


def numbers(element, key, default):
    text = default if element is None else element.get(key, default)
    return [float(v) for v in text.split()]


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def applied(a, v):
    return [sum(a[i][k] * v[k] for k in range(3)) for i in range(3)]


def turned(axis, angle):
    """Rodrigues' formula."""
    length = math.hypot(*axis)
    x, y, z = (v / length for v in axis)
    s, c = math.sin(angle), 1 - math.cos(angle)
    cross = [[0, -z, y], [z, 0, -x], [-y, x, 0]]
    square = times(cross, cross)
    return [[(i == j) + s * cross[i][j] + c * square[i][j] for j in range(3)] for i in range(3)]


def value(joint, values):
    mimic = joint.find("mimic")
    if mimic is None:
        return values[joint.get("name")]
    return float(mimic.get("multiplier", "1")) * values[mimic.get("joint")] + float(mimic.get("offset", "0"))


for line in sys.stdin:
    values, point, rotation, link = json.loads(line), [0.0] * 3, turned(AXES[0], 0.0), tool
    while link != base:
        joint = joints[link]
        kind, axis = joint.get("type"), numbers(joint.find("axis"), "xyz", "1 0 0")
        if kind == "prismatic":
            length = math.hypot(*axis)
            point = [p + value(joint, values) * a / length for p, a in zip(point, axis)]
        elif kind != "fixed":
            turn = turned(axis, value(joint, values))
            point, rotation = applied(turn, point), times(turn, rotation)
        roll, pitch, yaw = numbers(joint.find("origin"), "rpy", "0 0 0")
        origin = times(times(turned(AXES[2], yaw), turned(AXES[1], pitch)), turned(AXES[0], roll))
        place = numbers(joint.find("origin"), "xyz", "0 0 0")
        point, rotation = [p + o for p, o in zip(applied(origin, point), place)], times(origin, rotation)
        link = joint.find("parent").get("link")
    print(*(repr(1000 * v) for v in point), *(repr(v) for row in rotation for v in row))

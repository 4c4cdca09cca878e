"""Direct kinematics of a URDF by its specification: joint values (rad, m) by name as JSON, one object a line; prints the tool in the base, mm."""

import json
import sys
import xml.etree.ElementTree as ElementTree

import numpy as np

file, base, tool = sys.argv[1:4]
joints = {joint.find("child").get("link"): joint for joint in ElementTree.parse(file).getroot().iter("joint") if joint.find("child") is not None}


def numbers(element, key, default):
    text = default if element is None else element.get(key, default)
    return np.array([float(v) for v in text.split()])


def turned(axis, angle):
    x, y, z = axis / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def value(joint, values):
    mimic = joint.find("mimic")
    if mimic is None:
        return values[joint.get("name")]
    return float(mimic.get("multiplier", "1")) * values[mimic.get("joint")] + float(mimic.get("offset", "0"))


for line in sys.stdin:
    values, point, link = json.loads(line), np.zeros(3), tool
    while link != base:
        joint = joints[link]
        kind, axis = joint.get("type"), numbers(joint.find("axis"), "xyz", "1 0 0")
        if kind == "prismatic":
            point = point + value(joint, values) * axis / np.linalg.norm(axis)
        elif kind != "fixed":
            point = turned(axis, value(joint, values)) @ point
        roll, pitch, yaw = numbers(joint.find("origin"), "rpy", "0 0 0")
        x, y, z = np.eye(3)
        point = turned(z, yaw) @ turned(y, pitch) @ turned(x, roll) @ point + numbers(joint.find("origin"), "xyz", "0 0 0")
        link = joint.find("parent").get("link")
    print(*(repr(float(1000 * v)) for v in point))

"""YAML of waypoints by height and solution space; each line of numbers is read by its key. Column (m), arm (rad), prism (m)."""

import re

NAMES = ["column_prismatic_joint"] + [f"dsr_joint{k}" for k in range(1, 7)]


def read(folder, options):
    rows, kind, joints, text = [], "", [], ""
    for line in (folder / options["file"]).read_text().splitlines():
        text = f"{text} {line.strip()}" if text else line.strip()
        if text.count("[") > text.count("]"):
            continue  # a list goes on in the next line
        text, whole = "", text
        numbers = lambda: [float(v) for v in re.search(r"\[(.*)\]", whole)[1].split(",")]
        if whole.endswith("_measurements:"):
            kind = whole.removesuffix("_measurements:")
        elif whole.startswith("joint_states:"):
            joints = numbers()
        elif whole.startswith("prism_position:"):
            pose = str(len(rows) + 1)
            rows.append({"pose": pose, "series": kind, "target": "prism", "joints": joints, "xyz": [1e3 * v for v in numbers()]})
    return [f"{NAMES[0]}_m"] + [f"{n}_rad" for n in NAMES[1:]], rows

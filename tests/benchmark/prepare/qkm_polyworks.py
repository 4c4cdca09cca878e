"""Text of joints (deg) with the number of the reflector, and text of positions (mm)."""

import re


def read(folder, options):
    lines = lambda name: [re.split(r"[\s,]+", text.strip()) for text in (folder / name).read_text().splitlines() if text.strip()]
    rows = []
    joints, places = lines("data_points_cali__c_angles.txt"), lines("data_points_cali__c_poses.txt")
    for number, (q, xyz) in enumerate(zip(joints, places), 1):
        rows.append(
            {
                "pose": str(number),
                "target": f"SMR_{int(float(q[6]))}",
                "joints": [float(v) for v in q[:6]],
                "xyz": [float(v) for v in xyz[:3]],
            }
        )
    return [f"q{k}_deg" for k in range(1, 7)], rows

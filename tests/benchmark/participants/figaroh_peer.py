"""FIGAROH on a URDF of the chain: base parameters by QR, `full_params`, its own cost function.

    figaroh_peer.py FOLDER PREDICTIONS

Base and target start at those of the nominal chain (least_squares.py), since FIGAROH has no search for them. Every target is a marker of its own,
and rows of one pose belong together; a set whose poses do not all show the same targets is calibrated with its first target.
"""

import csv
import json
import pathlib
import sys
import tempfile


import numpy as np
import yaml
from scipy.spatial.transform import Rotation

import least_squares as own


def urdf(chain):
    """URDF text of a chain; a last fixed link carries the frame of the targets."""

    def origin(matrix):
        matrix = np.array(matrix)
        # fixed axes x, y, z
        rpy = Rotation.from_matrix(matrix[:3, :3]).as_euler("xyz")
        return f'<origin xyz="{" ".join(map(repr, (1e-3 * matrix[:3, 3]).tolist()))}" rpy="{" ".join(map(repr, rpy.tolist()))}"/>'

    text = ['<robot name="chain"><link name="l0"/>']
    inertia = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
    for k, j in enumerate(chain["joints"], 1):
        axis = " ".join(map(repr, j["axis"]))
        limit = '<limit lower="-10" upper="10" effort="1" velocity="1"/>'
        text.append(f'<link name="l{k}">{inertia}</link><joint name="j{k}" type="{j["kind"]}">{origin(j["origin"])}')
        text.append(f'<parent link="l{k - 1}"/><child link="l{k}"/><axis xyz="{axis}"/>{limit}</joint>')
    last = len(chain["joints"])
    text.append(f'<link name="tool"/><joint name="end" type="fixed">{origin(chain["end"])}<parent link="l{last}"/><child link="tool"/></joint></robot>')
    return "".join(text)


def main(folder, answer):
    from figaroh.calibration.base_calibration import BaseCalibration
    from figaroh.calibration.calibration_tools import calc_updated_fkm
    from figaroh.tools.robot import load_robot

    folder = pathlib.Path(folder)
    rows, wanted = own.table(folder / "calibration.csv"), own.table(folder / "test_joints.csv")
    described = json.loads((folder / "chain.json").read_text())
    targets = sorted({r["target"] for r in rows})
    if len(targets) > 1:
        raise SystemExit("left out: several targets; the script gives FIGAROH one")
    if len({j["column"] for j in described["joints"]}) < len(described["joints"]):
        raise SystemExit("left out: coupled joints; the script gives FIGAROH one value a joint")
    oriented = "qw" in rows[0]
    nominal = own.Chain(folder / "chain.json", "nominal")
    some = rows[:: max(1, len(rows) // 40)]
    first = own.start(own.Problem(nominal, some, targets, True))
    base = np.concatenate([1e-3 * first[3:6], first[:3] * 1e-3])
    # figaroh: position (m), then angles about fixed x, y, z
    pose = lambda xyz_m, turn: [*xyz_m, *Rotation.from_rotvec(turn).as_euler("xyz")]
    tip = pose(1e-3 * first[6:9], 1e-3 * first[9:12] if oriented else np.zeros(3))
    motions = nominal.values(rows).T
    scale = np.array([1e-3 if j["kind"] == "prismatic" else 1.0 for j in described["joints"]])
    with tempfile.TemporaryDirectory() as place:
        place = pathlib.Path(place)
        (place / "chain.urdf").write_text(urdf(described))
        names = [f"j{k + 1}" for k in range(len(described["joints"]))]
        with open(place / "data.csv", "w", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(["x1", "y1", "z1"] + (["phix1", "phiy1", "phiz1"] if oriented else []) + names)
            for r, q in zip(rows, motions * scale):
                seen = [1e-3 * float(r[f"{a}_mm"]) for a in "xyz"]
                if oriented:
                    seen += Rotation.from_quat([float(r[f"q{a}"]) for a in "xyzw"]).as_euler("xyz").tolist()
                writer.writerow([*seen, *q])
        measure = [True] * 3 + [oriented] * 3
        config = {
            "tasks": {
                "calibration": {
                    "enabled": True,
                    "type": "kinematic_calibration",
                    "parameters": {"calibration_level": "full_params", "include_non_geometric": False, "outlier_threshold": 1.0},
                    "kinematics": {"base_frame": "universe", "tool_frame": "tool", "free_flying_base": False},
                    "measurements": {
                        "markers": [{"reference_joint": names[-1], "measurable_dof": measure}],
                        "poses": {
                            "base_pose": [float(v) for v in pose(base[:3], base[3:])],
                            "tool_pose": [float(v) for v in tip],
                        },
                    },
                    "data": {"source_file": str(place / "data.csv"), "number_of_samples": len(rows)},
                }
            }
        }
        (place / "config.yaml").write_text(yaml.safe_dump(config))
        robot = load_robot(str(place / "chain.urdf"), load_by_urdf=True)
        peer = type("Peer", (BaseCalibration,), {})(robot, str(place / "config.yaml"))
        peer.calib_config["known_baseframe"] = peer.calib_config["known_tipframe"] = False
        peer.initialize()
        result = peer.solve(enable_logging=False, plotting=False)
        q = own.Chain(folder / "chain.json", "nominal").values(wanted).T * scale
        config = dict(peer.calib_config)
        config["NbSample"] = len(wanted)
        found = calc_updated_fkm(peer.model, peer.data, result.x, q, config)
    found = np.asarray(found).reshape(-1, len(wanted))
    with open(answer, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["pose", "target", "x_mm", "y_mm", "z_mm"] + (["qw", "qx", "qy", "qz"] if oriented else []))
        for k, r in enumerate(wanted):
            line = [r["pose"], r["target"], *(1e3 * found[:3, k])]
            if oriented:
                x, y, z, w = Rotation.from_euler("xyz", found[3:6, k]).as_quat()
                line += [w, x, y, z]
            writer.writerow(line)


if __name__ == "__main__":
    main(*sys.argv[1:])

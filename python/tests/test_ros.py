"""The way from a recording of ROS to a calibrated URDF, as docs/python.md shows it."""

import re
import warnings

import numpy as np
import pytest
from conftest import ROOT

import etalon

_JOINT = (
    '<joint name="{name}" type="revolute"><parent link="{parent}"/><child link="{child}"/><origin xyz="{xyz}"/><axis xyz="{axis}"/>'
    '<limit lower="-3" upper="3" effort="1" velocity="1"/></joint>'
)
AXES = [("0 0 0.3", "0 0 1"), ("0 0 0.1", "0 1 0"), ("0 0 0.4", "0 1 0"), ("0.1 0 0.2", "1 0 0"), ("0.3 0 0", "0 1 0"), ("0.1 0 0", "1 0 0")]


def urdf(axes):
    names = ["shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3"]
    links = ["base", *(f"{name}_link" for name in names)]
    joints = [_JOINT.format(name=name, parent=links[i], child=links[i + 1], xyz=xyz, axis=axis) for i, (name, (xyz, axis)) in enumerate(zip(names, axes))]
    return '<robot name="arm">' + "".join(f'<link name="{link}"/>' for link in links) + "".join(joints) + "</robot>"


def recorded(path, names, joints, measured):
    """A recording of joint states, whose names are in another order than those of the URDF, and of a measured reflector: at each pose the robot stands
    for half a second, and a gripper publishes states of its own."""
    rosbag2, typesys = pytest.importorskip("rosbags.rosbag2"), pytest.importorskip("rosbags.typesys")
    store = typesys.get_typestore(typesys.Stores.ROS2_HUMBLE)
    kinds = ["sensor_msgs/msg/JointState", "std_msgs/msg/Header", "builtin_interfaces/msg/Time", "tf2_msgs/msg/TFMessage"]
    kinds += ["geometry_msgs/msg/TransformStamped", "geometry_msgs/msg/Transform", "geometry_msgs/msg/Vector3", "geometry_msgs/msg/Quaternion"]
    state, header, time, tree, stamped, transform, vector, quaternion = (store.types[kind] for kind in kinds)
    with rosbag2.Writer(path, version=9) as writer:
        topics = {name: writer.add_connection(name, kind.__msgtype__, typestore=store) for name, kind in (("/joint_states", state), ("/tf", tree))}

        def write(topic, seconds, message):
            writer.write(topics[topic], int(seconds * 1e9), store.serialize_cdr(message, message.__msgtype__))

        for i, (row, point) in enumerate(zip(np.radians(joints), measured / 1000)):
            for nanosec in (0, 500_000_000):
                write("/joint_states", i + nanosec / 1e9, state(header(time(i, nanosec), ""), names[::-1], row[::-1].copy(), np.zeros(6), np.zeros(6)))
            write("/joint_states", i + 0.1, state(header(time(i, 100_000_000), ""), ["finger"], np.zeros(1), np.zeros(1), np.zeros(1)))
            turned = transform(vector(*point), quaternion(0.0, 0.0, 0.0, 1.0))
            frames = [stamped(header(time(i, 250_000_000), "tracker"), child, turned) for child in ("other", "reflector")]
            write("/tf", i + 0.25, tree(frames))


def blocks():
    page = (ROOT / "docs/python.md").read_text(encoding="utf-8")
    section = page[page.index("## ROS") : page.index("## MATLAB")]
    return re.findall(r"```python\n(.*?)```", section, re.DOTALL)


def test_a_recording_becomes_a_calibrated_urdf(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    nominal, true = tmp_path / "arm.urdf", tmp_path / "true.urdf"
    nominal.write_text(urdf(AXES))
    # 0.8 mm and 0.5 mm of two links
    true.write_text(urdf([*AXES[:2], ("0 0 0.4008", "0 1 0"), ("0.1 0 0.2005", "1 0 0"), *AXES[4:]]))
    joints = np.random.default_rng(1).uniform(-120, 120, (60, 6))
    robot = etalon.Robot(nominal)
    place = np.array([30.0, 10.0, 60.0, 1.0])
    measured = (etalon.kinematics.direct(true, joints).matrix @ place)[:, :3] + np.random.default_rng(2).normal(0, 0.01, (60, 3))
    recorded(tmp_path / "bag", [joint.rsplit("_", 1)[0] for joint in robot.joints], joints, measured)
    names = {"path": tmp_path / "bag"}
    read, back = blocks()
    exec(read, names)
    table = names["table"]
    assert np.column_stack([table[joint] for joint in robot.joints]) == pytest.approx(joints, abs=1e-9)
    assert np.column_stack([table[f"{axis}_mm"] for axis in "xyz"]) == pytest.approx(measured, abs=1e-9)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", etalon.MessageWarning)
        exec(back, names)
    calibrated = etalon.Robot(next((tmp_path / "calibrated").glob("*.urdf")))
    # the calibrated URDF is the true arm but for base and target, which rigid motions absorb
    off = [
        etalon.frames.rigid((etalon.kinematics.direct(arm, joints).matrix @ place)[:, :3], onto=measured).rms_mm for arm in (robot, calibrated)
    ]
    assert off[1] < 0.05 < 0.2 < off[0], off

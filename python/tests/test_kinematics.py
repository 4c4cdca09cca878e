"""Kinematics against NumPy and drawings."""

import numpy as np
import pytest
from conftest import IRB120, ROOT, dh, toml

import etalon


def test_an_arm_is_where_numpy_puts_it():
    joints = np.random.default_rng(3).uniform(-90, 90, (20, 6))
    found = etalon.kinematics.direct(etalon.Robot.from_toml(toml(IRB120)), joints)
    assert found.matrix == pytest.approx(dh(joints, *IRB120), abs=1e-9)


def test_robots_come_by_name_and_by_urdf():
    # a2 + a3, d4 + d6 and d1 - d5 of the data sheet
    assert etalon.kinematics.direct("ur5e", [0] * 6).xyz_mm[0] == pytest.approx([-817.2, -232.9, 62.8], abs=1e-9)
    urdf = etalon.Robot(ROOT / "samples/column-arm/arm.urdf")
    # a lift, whose second stage mimics the first, and six axes
    assert urdf.model == "urdf" and urdf.joints[0] == "lift_mm" and len(urdf.joints) == 7
    with pytest.raises(etalon.Error) as raised:
        etalon.Robot("ur6")
    assert "ur5e" in str(raised.value)


def test_joint_values_lead_back_to_their_pose():
    robot = etalon.Robot("irb120")
    joints = np.array([[20, -30, 15, 40, -50, 60], [-70, 10, -20, 80, 30, -100.0]])
    poses = etalon.kinematics.direct(robot, joints)
    near = etalon.kinematics.inverse(robot, poses, near=joints)
    assert near.joints == pytest.approx(joints, abs=1e-6) and list(near.pose) == [0, 1]
    every = etalon.kinematics.inverse(robot, poses, all_solutions=True)
    assert len(every.joints) > 2
    again = etalon.kinematics.direct(robot, every.joints)
    assert again.matrix == pytest.approx(poses.matrix[every.pose], abs=1e-6)


def test_what_is_out_of_reach_is_named():
    found = etalon.kinematics.inverse("irb120", [[5000, 0, 0, 1, 0, 0, 0]])
    assert len(found.joints) == 0 and list(found.unreachable) == [0]
    with pytest.raises(etalon.Error, match="shape"):
        etalon.kinematics.direct("irb120", np.zeros((3, 5)))

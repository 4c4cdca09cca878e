"""Kinematics against NumPy and drawings."""

import copy
import pickle

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
    assert etalon.kinematics.direct("ur5e", [0] * 6).xyz_mm == pytest.approx([-817.2, -232.9, 62.8], abs=1e-9)
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
    assert np.isnan(found.joints).all() and list(found.unreachable) == [0]
    assert found.reason.id == "out-of-reach-by"
    with pytest.raises(etalon.Error, match="shape"):
        etalon.kinematics.direct("irb120", np.zeros((3, 5)))


def drawn_within(robot, count, seed, share=1.0):
    """Joint values inside the limits, or within half a turn without limits."""
    limits = np.clip(robot.limits, -180, 180)
    return np.random.default_rng(seed).uniform(share * limits[:, 0], share * limits[:, 1], (count, len(limits)))


@pytest.mark.parametrize("name", ["panda", "ur5e", "irb120", "m1013", "tx60"])
def test_every_pose_that_joint_values_reach_has_a_solution_within_the_limits(name):
    robot = etalon.Robot(name)
    poses = etalon.kinematics.direct(robot, drawn_within(robot, 100, 0))
    found = etalon.kinematics.inverse(robot, poses)
    assert not found.unreachable, found.reason
    assert np.abs(etalon.kinematics.direct(robot, found.joints).matrix - poses.matrix).max() < 1e-6
    lower, upper = robot.limits.T
    assert (found.joints >= lower - 1e-9).all() and (found.joints <= upper + 1e-9).all()


@pytest.mark.parametrize("name", ["kr6-r900-sixx", "irb120", "tx60"])
def test_joints_at_their_limits_are_solutions(name):
    robot = etalon.Robot(name)
    assert (robot.limits == np.round(robot.limits, 6)).all()
    noise = np.random.default_rng(11)
    ends = robot.limits[np.arange(6), noise.integers(0, 2, (60, 6))]
    joints = np.where(noise.random((60, 6)) < 0.3, ends, noise.uniform(*robot.limits.T, (60, 6)))
    found = etalon.kinematics.inverse(robot, etalon.kinematics.direct(robot, joints))
    assert not found.unreachable, found.reason


def test_a_pose_without_numbers_has_its_reason():
    pose = etalon.kinematics.direct("ur5e", [[0.0, -80, 70, 0, 50, 0], [np.nan] * 6])
    found = etalon.kinematics.inverse("ur5e", pose)
    assert list(found.unreachable) == [1] and found.reason.id == "pose-not-finite"


def test_joints_without_limits_do_not_wind_up():
    arm = etalon.Robot.from_toml(toml(IRB120))
    poses = etalon.kinematics.direct(arm, np.random.default_rng(1).uniform(-150, 150, (200, 6)))
    found = etalon.kinematics.inverse(arm, poses)
    assert not found.unreachable and np.abs(found.joints).max() <= 180 + 1e-9


MOBILE = """
<robot name="mobile">
  <link name="world"/><link name="x"/><link name="y"/><link name="turn"/>
  <link name="l1"/><link name="l2"/><link name="l3"/><link name="l4"/><link name="l5"/><link name="l6"/>
  <joint name="base_x" type="prismatic"><parent link="world"/><child link="x"/><axis xyz="1 0 0"/><limit lower="-5" upper="5" effort="1" velocity="1"/></joint>
  <joint name="base_y" type="prismatic"><parent link="x"/><child link="y"/><axis xyz="0 1 0"/><limit lower="-5" upper="5" effort="1" velocity="1"/></joint>
  <joint name="base_turn" type="continuous"><parent link="y"/><child link="turn"/><axis xyz="0 0 1"/></joint>
  {joints}
</robot>
"""
_ARM = [("0.2 0 0.6", "0 0 1"), ("0 0 0.2", "0 1 0"), ("0 0 0.4", "0 1 0"), ("0 0 0.2", "0 0 1"), ("0 0 0.2", "0 1 0"), ("0 0 0.1", "0 0 1")]
_JOINT = '<joint name="q{i}" type="revolute"><parent link="{p}"/><child link="l{i}"/><origin xyz="{xyz}"/><axis xyz="{axis}"/><limit lower="-2.9" upper="2.9" effort="1" velocity="1"/></joint>'


def test_a_mobile_arm_reaches_what_it_reaches(tmp_path):
    """Three joints of the base before six of the arm: the poses lie up to 5 m away."""
    joints = "\n".join(_JOINT.format(i=i + 1, p="turn" if i == 0 else f"l{i}", xyz=xyz, axis=axis) for i, (xyz, axis) in enumerate(_ARM))
    (tmp_path / "mobile.urdf").write_text(MOBILE.format(joints=joints))
    robot = etalon.Robot(tmp_path / "mobile.urdf")
    noise = np.random.default_rng(4)
    values = np.column_stack([noise.uniform(-5000, 5000, (60, 2)), noise.uniform(-180, 180, 60), noise.uniform(-160, 160, (60, 6))])
    poses = etalon.kinematics.direct(robot, values)
    found = etalon.kinematics.inverse(robot, poses)
    assert not found.unreachable, found.unreachable
    assert np.abs(etalon.kinematics.direct(robot, found.joints).matrix - poses.matrix).max() < 1e-6


def test_the_reason_is_that_of_the_pose():
    arm = etalon.Robot("irb120")
    beyond = etalon.kinematics.direct(etalon.Robot.from_toml(toml(IRB120)), [170.0, 0, 0, 0, 30, 0])
    found = etalon.kinematics.inverse(arm, beyond)
    assert found.joints.shape == (6,) and np.isnan(found.joints).all()
    assert found.reason.id == "joint-beyond-limits", found.reason
    far = etalon.kinematics.inverse(arm, [5000.0, 0, 0, 1, 0, 0, 0])
    assert far.reason.id == "out-of-reach-by"
    assert pickle.loads(pickle.dumps(far.reason)).id == far.reason.id


def test_poses_are_given_as_one_has_them_and_one_pose_has_one_answer():
    robot = etalon.Robot("ur5e")
    joints = np.array([[10, -80, 70, -30, 40, 5], [-60, -100, 90, -20, -50, 80.0], [100, -50, 40, 20, 60, -90]])
    poses = etalon.kinematics.direct(robot, joints)
    rows = np.column_stack([poses.xyz_mm, poses.quaternion])
    for stated in (poses, poses.matrix, rows):
        # each pose has its own start
        assert etalon.kinematics.inverse(robot, stated, near=joints + 1).joints == pytest.approx(joints, abs=1e-6)
    for stated in (poses[1], poses.matrix[1], rows[1]):
        found = etalon.kinematics.inverse(robot, stated, near=joints[1])
        assert found.joints.shape == (6,) and found.joints == pytest.approx(joints[1], abs=1e-6) and found.reason is None
    assert etalon.kinematics.direct(robot, joints[1]).matrix == pytest.approx(poses.matrix[1], abs=0)
    with pytest.raises(etalon.Error, match="`near` has 2 rows"):
        etalon.kinematics.inverse(robot, poses, near=joints[:2])
    with pytest.raises(etalon.Error, match="norm 1"):
        etalon.kinematics.inverse(robot, [0, 0, 0, 1, 1, 0, 0.0])


def test_poses_are_indexed_and_made_of_matrices():
    poses = etalon.kinematics.direct("ur5e", np.random.default_rng(2).uniform(-180, 180, (50, 6)))
    again = etalon.kinematics.Poses.from_matrix(poses.matrix)
    assert again.matrix == pytest.approx(poses.matrix, abs=1e-12)
    assert len(poses[3:7]) == 4 and poses[3].single and poses[3].matrix.shape == (4, 4)
    assert [pose.xyz_mm[0] for pose in poses] == list(poses.xyz_mm[:, 0])
    assert poses[poses.xyz_mm[:, 0] > 0].xyz_mm.min(axis=0)[0] > 0
    assert poses == copy.deepcopy(poses) and poses != again[::-1]
    rotation = pytest.importorskip("scipy.spatial.transform").Rotation
    assert rotation.from_quat(poses.quaternion_xyzw).as_matrix() == pytest.approx(poses.matrix[:, :3, :3], abs=1e-12)
    mirrored = poses.matrix[0] @ np.diag([1, 1, -1, 1])
    with pytest.raises(etalon.Error, match="no rigid motion"):
        etalon.kinematics.Poses.from_matrix(mirrored)


def test_the_jacobian_is_the_derivative():
    robot = etalon.Robot("ur5e")
    q = np.array([10.0, -80, 70, -30, 40, 5])
    found = etalon.kinematics.jacobian(robot, q)
    step = 1e-4
    for joint in range(6):
        ends = [etalon.kinematics.direct(robot, q + sign * step * np.eye(6)[joint]).matrix for sign in (-1, 1)]
        speed = (ends[1][:3, 3] - ends[0][:3, 3]) / (2 * step)
        turn = (ends[1][:3, :3] - ends[0][:3, :3]) / (2 * np.radians(step)) @ ((ends[0][:3, :3] + ends[1][:3, :3]) / 2).T
        assert found[:3, joint] == pytest.approx(speed, abs=1e-6)
        assert found[3:, joint] == pytest.approx([turn[2, 1], turn[0, 2], turn[1, 0]], abs=1e-6)
    assert etalon.kinematics.jacobian(robot, [q, q]).shape == (2, 6, 6)


def test_kinematics_and_jacobian_are_those_of_the_robotics_toolbox():
    rtb = pytest.importorskip("roboticstoolbox")
    alpha, a, theta, d = IRB120
    links = [rtb.RevoluteMDH(alpha=np.radians(al), a=length, d=offset, offset=np.radians(th)) for al, length, th, offset in zip(alpha, a, theta, d)]
    other, own = rtb.DHRobot(links), etalon.Robot.from_toml(toml(IRB120))
    joints = np.random.default_rng(5).uniform(-150, 150, (20, 6))
    for q, pose, jacobian in zip(joints, etalon.kinematics.direct(own, joints), etalon.kinematics.jacobian(own, joints)):
        assert pose.matrix == pytest.approx(np.asarray(other.fkine(np.radians(q))), abs=1e-9)
        expected = other.jacob0(np.radians(q))
        assert jacobian == pytest.approx(np.vstack([expected[:3] * np.pi / 180, expected[3:]]), abs=1e-9)


def test_kinematics_of_a_urdf_are_those_of_pinocchio(tmp_path):
    pinocchio = pytest.importorskip("pinocchio")
    path = tmp_path / "arm.urdf"
    joints = "\n".join(_JOINT.format(i=i + 1, p="turn" if i == 0 else f"l{i}", xyz=xyz, axis=axis) for i, (xyz, axis) in enumerate(_ARM))
    path.write_text(MOBILE.format(joints=joints).replace('type="continuous"', 'type="revolute"').replace('0 0 1"/></joint>\n  <joint name="q1"', '0 0 1"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>\n  <joint name="q1"'))
    model = pinocchio.buildModelFromUrdf(str(path))
    robot, data = etalon.Robot(path), model.createData()
    noise = np.random.default_rng(6)
    values = np.column_stack([noise.uniform(-5000, 5000, (10, 2)), noise.uniform(-150, 150, (10, 7))])
    frame = model.getFrameId(robot.chain.tool_link)
    for q, pose, jacobian in zip(values, etalon.kinematics.direct(robot, values), etalon.kinematics.jacobian(robot, values)):
        inward = np.concatenate([q[:2] / 1000, np.radians(q[2:])])
        pinocchio.computeJointJacobians(model, data, inward)
        pinocchio.framesForwardKinematics(model, data, inward)
        place = data.oMf[frame]
        assert pose.xyz_mm == pytest.approx(1000 * place.translation, abs=1e-8)
        assert pose.matrix[:3, :3] == pytest.approx(place.rotation, abs=1e-12)
        expected = pinocchio.getFrameJacobian(model, data, frame, pinocchio.LOCAL_WORLD_ALIGNED)
        # m and rad, to mm and deg
        scale = np.where(np.arange(9) < 2, 1 / 1000, np.pi / 180)
        assert jacobian[:3] == pytest.approx(1000 * expected[:3] * scale, abs=1e-9)
        assert jacobian[3:] == pytest.approx(np.degrees(expected[3:]) * scale, abs=1e-9)


def test_solutions_are_solutions_of_the_robotics_toolbox():
    rtb = pytest.importorskip("roboticstoolbox")
    alpha, a, theta, d = IRB120
    links = [rtb.RevoluteMDH(alpha=np.radians(al), a=length, d=offset, offset=np.radians(th)) for al, length, th, offset in zip(alpha, a, theta, d)]
    other, own = rtb.DHRobot(links), etalon.Robot.from_toml(toml(IRB120))
    poses = etalon.kinematics.direct(own, np.random.default_rng(7).uniform(-150, 150, (20, 6)))
    for q, pose in zip(etalon.kinematics.inverse(own, poses).joints, poses):
        assert np.asarray(other.fkine(np.radians(q))) == pytest.approx(pose.matrix, abs=1e-6)


def test_robots_are_copied_pickled_compared_and_named_as_makers_write_them(tmp_path):
    robot = etalon.Robot("UR5e")
    assert robot == etalon.Robot("ur5e") != etalon.Robot("ur5")
    for again in (copy.deepcopy(robot), pickle.loads(pickle.dumps(robot))):
        assert again == robot and hash(again) == hash(robot) and again.parameters == robot.parameters
    urdf = etalon.Robot(ROOT / "samples/column-arm/arm.urdf")
    again = pickle.loads(pickle.dumps(urdf))
    assert again == urdf and again.chain == urdf.chain
    with pytest.raises(etalon.Error) as raised:
        etalon.Robot("ur5f")
    assert "did you mean" in raised.value.hint
    assert robot.limits[0] == pytest.approx([-360, 360])


FORK = """<robot name="fork"><link name="base"/><link name="arm"/><link name="left"/><link name="right"/>
<joint name="q1" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
<joint name="l" type="prismatic"><parent link="arm"/><child link="left"/><axis xyz="0 1 0"/><limit lower="0" upper="0.1" effort="1" velocity="1"/></joint>
<joint name="r" type="prismatic"><parent link="arm"/><child link="right"/><axis xyz="0 1 0"/><limit lower="0" upper="0.1" effort="1" velocity="1"/></joint></robot>"""


def test_the_chain_of_a_urdf_is_stated_and_a_finger_is_no_silent_choice(tmp_path):
    path = tmp_path / "fork.urdf"
    path.write_text(FORK)
    with pytest.warns(etalon.warning_class("urdf-chain-chosen"), match='tool_link="arm"'):
        robot = etalon.Robot(path)
    assert robot.chain.base_link == "base" and robot.chain.tool_link == "left"
    stated = etalon.Robot.from_urdf(path, tool_link="arm")
    assert stated.chain.tool_link == "arm" and stated.joints == ["q1_deg"]
    assert etalon.Robot("ur5e").chain is None


def test_parameters_of_another_robot_are_refused():
    joints = np.random.default_rng(8).uniform(-90, 90, (40, 6))
    xyz = etalon.kinematics.direct("ur5", joints).xyz_mm + np.random.default_rng(9).normal(0, 0.01, (40, 3))
    table = {"pose": np.arange(40), "target": ["SMR"] * 40} | {f"q{i + 1}_deg": joints[:, i] for i in range(6)}
    found = etalon.identify("ur5", table | {f"{axis}_mm": xyz[:, k] for k, axis in enumerate("xyz")}, standard_uncertainty_um=10)
    assert np.abs(etalon.kinematics.predict("ur5", found, joints, "SMR").xyz_mm - xyz).max() < 0.1
    for refused in (
        lambda: etalon.kinematics.predict("ur10", found, joints, "SMR"),
        lambda: etalon.kinematics.direct("ur10", joints, parameters=found),
    ):
        with pytest.raises(etalon.Error):
            refused()
    # the derivatives by the parameters are differences of predictions
    by = etalon.kinematics.sensitivity("ur5", found, joints[0], "SMR")
    assert by.matrix.shape == (3, len(by.parameters))
    name = next(p.name for p in found.parameters if p.status == "identified" and p.unit == "mm" and p.role == "robot")
    moved = found.to_dict()
    for entry in moved["parameters"]:
        entry["value"] += 0.01 if entry["name"] == name else 0.0
    shifted = [etalon.kinematics.predict("ur5", p, joints[0], "SMR").xyz_mm for p in (found, etalon.documents.ParametersDocument(moved))]
    assert by.matrix[:, by.parameters.index(name)] == pytest.approx((shifted[1] - shifted[0]) / 0.01, abs=1e-6)


#: Limits of joints (deg) by the makers' data sheets.
SHEETS = {
    "irb120": [[-165, 165], [-110, 110], [-110, 70], [-160, 160], [-120, 120], [-400, 400]],
    "kr6-r900-sixx": [[-170, 170], [-190, 45], [-120, 156], [-185, 185], [-120, 120], [-350, 350]],
    "tx60": [[-180, 180], [-127.5, 127.5], [-142.5, 142.5], [-270, 270], [-122.5, 132.5], [-270, 270]],
    "panda": np.degrees([[-2.8973, 2.8973], [-1.7628, 1.7628], [-2.8973, 2.8973], [-3.0718, -0.0698], [-2.8973, 2.8973], [-0.0175, 3.7525], [-2.8973, 2.8973]]),
}


def test_named_robots_have_the_limits_of_their_makers():
    for name, limits in SHEETS.items():
        assert etalon.Robot(name).limits == pytest.approx(np.array(limits, dtype=float), abs=1e-4), name
    serial = [etalon.Robot(name) for name in etalon.robots() if etalon.Robot(name).model == "serial"]
    assert len(serial) >= 14
    for robot in serial:
        lower, upper = robot.limits.T
        # joints without an end, or without a published limit, are infinite
        assert (lower < upper).all() and (np.isfinite(lower) == np.isfinite(upper)).all() and np.isfinite(lower).sum() >= 5, robot


def test_poses_are_multiplied_and_inverted():
    robot = etalon.Robot("ur5e")
    flange = etalon.kinematics.direct(robot, np.random.default_rng(4).uniform(-120, 120, (20, 6)))
    turned = np.array([[0.0, -1, 0, 30], [1, 0, 0, -20], [0, 0, 1, 150], [0, 0, 0, 1]])
    tool = etalon.kinematics.Poses.from_matrix(turned)
    assert (flange @ tool).matrix == pytest.approx(flange.matrix @ turned, abs=1e-9)
    assert flange.inverse().matrix == pytest.approx(np.linalg.inv(flange.matrix), abs=1e-9)
    assert (flange @ flange.inverse()).matrix == pytest.approx(np.tile(np.eye(4), (20, 1, 1)), abs=1e-9)
    assert (tool @ tool.inverse()).single and tool.inverse().xyz_mm == pytest.approx([20, 30, -150])
    with pytest.raises(TypeError):
        flange @ turned

"""Answers that were wrong in silence, and what makes answers easy to use."""

import json
import os
import pickle
import warnings

import numpy as np
import pytest
from conftest import IRB120, dh, toml
from test_ros import AXES, urdf

import etalon


def simulated(count, seed):
    """Few poses of an arm with errors of 0.3 mm and 0.05 deg, and 200 other poses with their true positions (synthetic, noise 30 um)."""
    noise = np.random.default_rng(seed)
    alpha, a, theta, d = (values.copy() for values in IRB120)
    a, d = a + noise.normal(0, 0.3, 6), d + noise.normal(0, 0.3, 6)
    theta, alpha = theta + noise.normal(0, 0.05, 6), alpha + noise.normal(0, 0.05, 6)
    limits = np.array([150, 80, 70, 150, 100, 170])
    target = np.array([30.0, 10.0, 60.0, 1.0])
    joints, others = noise.uniform(-limits, limits, (count, 6)), noise.uniform(-limits, limits, (200, 6))
    measured = (dh(joints, alpha, a, theta, d) @ target)[:, :3] + noise.normal(0, 0.03, (count, 3))
    table = {"pose": np.arange(1, count + 1), "target": ["SMR"] * count} | {f"q{i + 1}_deg": joints[:, i] for i in range(6)}
    return table | {f"{axis}_mm": measured[:, k] for k, axis in enumerate("xyz")}, others, (dh(others, alpha, a, theta, d) @ target)[:, :3]


@pytest.mark.parametrize("count", [7, 8])
def test_uncertainties_of_few_poses_cover_the_errors_elsewhere(count):
    """Of 95 % intervals at other poses, far more than half contain the true position: parameters that seven poses do not separate are not known."""
    robot, covered = etalon.Robot.from_toml(toml(IRB120)), []
    for seed in range(4):
        table, others, true = simulated(count, seed)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found = etalon.identify(robot, table, standard_uncertainty_um=30)
        predicted = etalon.kinematics.predict(robot, found, others, "SMR")
        covered.append(np.mean(np.abs(predicted.xyz_mm - true) < 2 * predicted.standard_uncertainty_mm))
    assert np.mean(covered) > 0.9 and min(covered) > 0.75, covered


def test_a_target_far_from_its_given_position_is_named(arm):
    robot, table, _ = arm
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        near = etalon.identify(robot, table, standard_uncertainty_um=10, targets={"SMR": (33, 8, 62)})
        far = etalon.identify(robot, table, standard_uncertainty_um=10, targets={"SMR": (30, 10, -60)})
    assert "target-far-from-given" not in {message.id for message in near.messages}
    message = next(message for message in far.messages if message.id == "target-far-from-given")
    assert message.arguments["target"] == "SMR" and message.arguments["distance_mm"] == pytest.approx(120, abs=2)


def test_a_pickled_robot_has_its_urdf_and_no_path(tmp_path):
    path = tmp_path / "arm.urdf"
    path.write_text(urdf(AXES))
    robot = etalon.Robot(path).with_targets({"SMR": (10, 20, 30)})
    text = pickle.dumps(robot)
    path.unlink()
    assert os.fsencode(tmp_path) not in text
    again = pickle.loads(text)
    assert again == robot and again.chain == robot.chain
    joints = [10.0, -20, 30, -40, 50, -60]
    assert etalon.kinematics.direct(again, joints) == etalon.kinematics.direct(robot, joints)
    # targets need no file either
    assert again.with_targets({"other": (1, 2, 3)}) == robot.with_targets({"other": (1, 2, 3)})


def test_masked_numbers_are_refused():
    noise = np.random.default_rng(0)
    points = noise.normal(size=(9, 3))
    weights = np.ma.array(np.ones(9), mask=np.arange(9) == 2)
    wrong = [
        lambda: etalon.fit.plane(points, weights=weights),
        lambda: etalon.fit.plane(list(np.ma.array(points, mask=np.eye(9, 3)))),
        lambda: etalon.fit.cylinder(points, axis=np.ma.array([0.0, 0, 1], mask=[0, 0, 1])),
        lambda: etalon.kinematics.direct("ur5e", [np.ma.array(np.zeros(6), mask=np.arange(6) == 1)]),
        lambda: etalon.Robot("ur5e", targets={"SMR": np.ma.array([1.0, 2, 3], mask=[0, 1, 0])}),
        lambda: etalon.frames.rigid(np.ma.array(points, mask=np.eye(9, 3)), points),
    ]
    for call in wrong:
        with pytest.raises(etalon.Error, match="masked"):
            call()


def test_documents_and_robots_take_the_place_of_files(arm, tmp_path):
    _, table, _ = arm
    path = tmp_path / "arm.urdf"
    path.write_text(urdf(AXES))
    robot = etalon.Robot(path)
    true = etalon.kinematics.direct(robot, np.column_stack([table[f"q{i}_deg"] for i in range(1, 7)])).xyz_mm
    observed = {name: table[name] for name in ("pose", "target")} | {joint: table[f"q{i}_deg"] for i, joint in enumerate(robot.joints, 1)}
    observed |= {f"{axis}_mm": true[:, k] + 0.01 * np.sin(7 * np.arange(60) + k) for k, axis in enumerate("xyz")}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = etalon.identify(robot, observed, standard_uncertainty_um=10)
    by_path = etalon.command("export", found, robot=path, format="urdf", to=tmp_path / "of_path")
    assert by_path.met and (tmp_path / "of_path" / "calibrated.urdf").is_file()
    path.unlink()
    answer = etalon.command("export", found, robot=robot, format=["csv", "urdf"], to=tmp_path / "cell")
    assert answer.met and {"controller.csv", "calibrated.urdf"} <= set(os.listdir(tmp_path / "cell"))


def test_a_frame_of_three_balls():
    rotation = etalon.frames.rigid(np.eye(3), np.array([[0.0, 1, 0], [-1, 0, 0], [0, 0, 1]])).matrix[:3, :3]
    inside = np.array([[0.0, 0, 0], [300, 0, 0], [40, 200, 0]])
    centres = inside @ rotation.T + [100, 50, 20]
    frame = etalon.frames.three_points(*centres, standard_uncertainty_um=2)
    assert frame(centres) == pytest.approx(inside, abs=1e-9) and frame.matrix[:3, 3] == pytest.approx([100, 50, 20], abs=1e-9)
    assert frame.standard_uncertainty_mm == pytest.approx([0.002] * 3, rel=1e-6)
    noise = np.random.default_rng(2)
    touched = [centre + 12.7 * (v / np.linalg.norm(v, axis=1, keepdims=True)) for centre, v in zip(centres, noise.normal(size=(3, 20, 3)))]
    balls = [etalon.fit.sphere(points) for points in touched]
    assert etalon.frames.three_points(*balls, standard_uncertainty_um=2).matrix == pytest.approx(frame.matrix, abs=1e-6)
    with pytest.raises(etalon.Error, match="no centre"):
        etalon.frames.three_points(etalon.fit.plane(touched[0]), *centres[1:])


def test_a_text_shows_every_value_or_counts_the_rest(arm):
    robot, table, _ = arm
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = etalon.identify(robot, table, standard_uncertainty_um=10)
    text = repr(found)
    known = [entry.name for entry in found.parameters if entry.standard_uncertainty is not None]
    assert all(any(line.split()[:1] == [name] for line in text.splitlines()) for name in known)
    held = len(found.parameters) - len(known)
    assert f"and {held} without" in text and ".parameters.to_pandas()" in text
    many = {"parameters": [{"name": f"p_{i}", "value": 1.0, "standard_uncertainty": 0.1, "unit": "mm"} for i in range(130)]}
    assert "and 30 more with uncertainties" in repr(etalon.documents.Record(many))
    # no member is left out without its name
    others = [name for name in found if name not in ("messages", "schema") and not name.endswith(("_phrase", "_phrases"))]
    assert all(name in text for name in others)


def test_tables_are_shown_and_missing_numbers_are_numbers(arm):
    pandas = pytest.importorskip("pandas")
    robot, table, _ = arm
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = etalon.identify(robot, table, standard_uncertainty_um=10)
    errors = found.residuals_table()
    lines = repr(errors).splitlines()
    # headings, six of sixty rows, and the names of the columns that do not fit
    assert lines[0] == "Records(60)" and len(lines) == 10 and "q6_deg" in lines[-1] and all(len(line) < 180 for line in lines)
    assert len(repr(errors[:3]).splitlines()) == 6 and errors[:3].column("pose") == [1, 2, 3]
    frame = errors.to_pandas()
    assert all(pandas.api.types.is_numeric_dtype(frame[name]) for name in frame if name not in ("set", "target", "quantity"))
    assert frame["before_deg"].isna().all()


def test_parameters_are_taken_as_a_dictionary(arm):
    robot, table, _ = arm
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = etalon.identify(robot, table, standard_uncertainty_um=10)
    joints = [10.0, -20, 30, -40, 50, -60]
    stored = json.loads(found.to_json())
    assert etalon.kinematics.predict(robot, stored, joints, "SMR").xyz_mm.tolist() == etalon.kinematics.predict(robot, found, joints, "SMR").xyz_mm.tolist()


def test_members_are_explained(arm):
    found = etalon.fit.sphere(np.random.default_rng(1).normal(size=(20, 3)))
    meanings = {entry.name: entry for entry in found.describe()}
    assert meanings["radius_mm"].meaning and meanings["radius_mm"].type == "number | absent"
    assert {entry.name for entry in found.solver.describe()} >= set(found.solver)
    assert set(meanings) >= set(found)


def test_records_are_found_by_their_names(arm):
    robot, table, _ = arm
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = etalon.identify(robot, table, standard_uncertainty_um=10)
    assert found.parameters["a_3"].nominal == 270.0
    with pytest.raises(KeyError, match="a_33"):
        found.parameters["a_33"]
    poses = etalon.kinematics.direct(robot, [[10.0, -20, 30, -40, 50, -60]])
    for answer in (etalon.kinematics.predict(robot, found, [[0.0] * 6], "SMR"), etalon.kinematics.inverse(robot, poses)):
        assert pickle.loads(pickle.dumps(answer)) == answer
    assert "1 poses solved, 0 unreachable" in repr(etalon.kinematics.inverse(robot, poses))


def test_columns_of_a_frame_are_joints_by_their_names(arm):
    pandas = pytest.importorskip("pandas")
    robot, table, _ = arm
    frame = pandas.DataFrame(table)
    right = etalon.kinematics.direct(robot, frame[robot.joints].to_numpy())
    assert etalon.kinematics.direct(robot, frame) == etalon.kinematics.direct(robot, frame[robot.joints[::-1]]) == right
    # other headings are taken in their order
    assert etalon.kinematics.direct(robot, frame[robot.joints].rename(columns=str.upper)) == right
    with pytest.raises(etalon.Error, match="q2_deg"):
        etalon.kinematics.direct(robot, frame.drop(columns="q2_deg"))


def test_an_arm_is_made_of_arrays():
    alpha, a, theta, d = IRB120
    limits = np.array([[-165, 165], [-110, 110], [-110, 70], [-160, 160], [-120, 120], [-400, 400]])
    robot = etalon.Robot.from_dh(alpha, a, theta, d, modified=True, limits=limits)
    joints = np.random.default_rng(3).uniform(-60, 60, (10, 6))
    assert etalon.kinematics.direct(robot, joints).matrix == pytest.approx(dh(joints, *IRB120), abs=1e-9)
    assert robot.limits == pytest.approx(limits)
    slide = etalon.Robot.from_dh([0, 90], [0, 0], [0, 0], [100, 0], prismatic=[True, False])
    assert slide.joints == ["q1_mm", "q2_deg"] and etalon.kinematics.direct(slide, [20.0, 0]).xyz_mm == pytest.approx([0, 0, 120], abs=1e-9)
    with pytest.raises(etalon.Error, match="for each joint"):
        etalon.Robot.from_dh(alpha, a[:5], theta, d)


@pytest.mark.parametrize("text", ["1.000", "1.500,0"])
def test_thousands_marks_in_texts_are_refused(text):
    """In German texts 1.000 is one thousand."""
    table = {"position_mm": [text] * 4, "measured_mm": ["0,1", "0,2", "0,1", "0,2"], "direction": [1, 1, -1, -1]}
    with pytest.raises(etalon.Error, match="row 1: .* has a point"):
        etalon.iso230(table, decimal=",")
    polars = pytest.importorskip("polars")
    with pytest.raises(etalon.Error, match="row 2: .* has a point"):
        etalon.iso230(polars.DataFrame(dict(table, position_mm=["0,0", text, "0,0", text])), decimal=",")


def test_a_frame_of_fitted_balls_has_their_uncertainty():
    noise = np.random.default_rng(5)
    centres = np.array([[0.0, 0, 0], [400, 0, 0], [0, 300, 0]])
    directions = noise.normal(size=(3, 40, 3))
    touched = centres[:, None] + 12.7 * directions / np.linalg.norm(directions, axis=2, keepdims=True) + noise.normal(0, 0.003, (3, 40, 3))
    balls = [etalon.fit.sphere(points) for points in touched]
    worst = max(ball.standard_uncertainty.point_mm for ball in balls)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        frame = etalon.frames.three_points(*balls)
    assert frame.standard_uncertainty_mm == pytest.approx([worst] * 3, rel=1e-9)


def test_an_unknown_id_has_no_class_of_warnings():
    with pytest.raises(etalon.Error, match="columns-not-red"):
        etalon.warning_class("columns-not-red")


def test_angles_in_radians_are_no_twists():
    alpha, a, theta, d = IRB120
    for stated in ({"alpha_deg": np.radians(alpha)}, {"theta_deg": np.radians(theta)}):
        with pytest.raises(etalon.Error) as raised:
            etalon.Robot.from_dh(**({"alpha_deg": alpha, "a_mm": a, "theta_deg": theta, "d_mm": d} | stated), modified=True)
        assert raised.value.id == "joint-angle-unit" and "np.degrees" in raised.value.hint
    text = toml(IRB120)
    # the unit of a key is never chosen for the reader, and degrees under `alpha_rad` are no robot
    with pytest.raises(etalon.Error) as raised:
        etalon.Robot.from_toml(text.replace("alpha_deg", "alpha"))
    assert "`alpha_deg`" in raised.value.hint and "`alpha_rad`" in raised.value.hint
    with pytest.raises(etalon.Error) as raised:
        etalon.Robot.from_toml(text.replace("alpha_deg", "alpha_rad"))
    assert raised.value.id == "joint-angle-unit" and "`alpha_deg`" in raised.value.hint


def test_inverse_poses_are_named(arm):
    """The pose of the camera in the marker instead of the marker in the camera, as `lookup_transform` gives it with exchanged arguments."""
    robot, table, _ = arm
    joints = np.column_stack([table[f"q{i}_deg"] for i in range(1, 7)])
    tool = np.eye(4)
    tool[:3, 3] = [20.0, -10, 80]
    world = np.array([[0.0, -1, 0, 900], [0, 0, -1, 200], [1, 0, 0, 300], [0, 0, 0, 1]])
    noise = np.random.default_rng(3)
    measured = world @ etalon.kinematics.direct(robot, joints).matrix @ tool
    measured[:, :3, 3] += noise.normal(0, 0.02, (60, 3))

    def observed(matrices):
        poses = etalon.kinematics.Poses.from_matrix(matrices)
        columns = {name: table[name] for name in ("pose", *robot.joints)} | {"kind": ["pose"] * 60, "target": ["marker"] * 60}
        columns |= {f"{axis}_mm": poses.xyz_mm[:, k] for k, axis in enumerate("xyz")}
        return columns | {f"q{axis}": poses.quaternion[:, k] for k, axis in enumerate("wxyz")}

    options = {"standard_uncertainty_um": 30, "rotation_uncertainty_deg": 0.02}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", etalon.MessageWarning)
        found = etalon.identify(robot, observed(measured), **options)
    assert found.residuals.position_rms_mm < 0.06
    with pytest.raises(etalon.Error) as raised:
        etalon.identify(robot, observed(np.linalg.inv(measured)), **options)
    assert "inverse of the measured poses" in raised.value.hint, str(raised.value)


def test_exact_data_are_no_implausible_robot(arm):
    """Distances of rounding are within any tolerance."""
    robot, table, _ = arm
    joints = np.column_stack([table[f"q{i}_deg"] for i in range(1, 7)])
    exact = (etalon.kinematics.direct(robot, joints).matrix @ [30.0, 10, 60, 1])[:, :3]
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        etalon.identify(robot, table | {f"{axis}_mm": exact[:, k] for k, axis in enumerate("xyz")})
    assert not [entry.message for entry in caught if isinstance(entry.message, etalon.ImplausibleWarning)]

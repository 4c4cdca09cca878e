"""The law of hints: the remedy of every hint is accepted by the function that gave it, and leads to the right answer."""

import ast
import re
import warnings

import numpy as np
import pytest

import etalon

#: Keyword arguments in a hint.
REMEDY = re.compile(r"`(\w+)=(\{[^`]*\}|\"[^\"`]*\"|[\d.]+)`")
#: Words of a hint for what only the reader knows.
UNKNOWN = {"HEADING", "SHEET", "FILE"}


def remedies(error):
    """Keyword arguments of all hints of an error; of alternatives the first that leaves nothing to be filled in."""
    found = {}
    together = re.search(r"hint: together: columns=(\{.*\})", str(error))
    if together:
        found["columns"] = ast.literal_eval(together[1])
    for message in error.messages:
        for alternative in re.split(r", or |; ", message.hint or ""):
            stated = {name: ast.literal_eval(text) for name, text in REMEDY.findall(alternative)}
            values = {item for value in stated.values() for item in (value.values() if isinstance(value, dict) else [value])}
            if stated and not values & UNKNOWN:
                for name, value in stated.items():
                    found[name] = {**value, **found.get(name, {})} if isinstance(value, dict) else found.get(name, value)
                break
    return found


def followed(function, arguments, keywords, steps=6):
    """Answer of a call after the remedies of its hints, with the steps that were taken."""
    keywords, taken = dict(keywords), []
    for _ in range(steps):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            try:
                return function(*arguments, **keywords), taken
            except etalon.Error as error:
                more = remedies(error)
                assert more, f"no remedy after {taken}: {error}"
                assert more not in taken, f"the same remedy again: {more}: {error}"
                taken.append(more)
                if error.id == "columns-inverted":
                    keywords.pop("columns")
        for name, value in more.items():
            stated = keywords.get(name)
            keywords[name] = {**stated, **value} if isinstance(value, dict) and isinstance(stated, dict) else value
    raise AssertionError(f"no answer after {taken}")


@pytest.fixture
def recorded(arm):
    """A table as a student records it: radians, metres, headings of its own."""
    robot, table, _ = arm
    columns = {f"j{i}": np.radians(table[f"q{i}_deg"]) for i in range(1, 7)}
    return robot, columns | {axis.upper(): np.asarray(table[f"{axis}_mm"]) / 1000 for axis in "xyz"}


def test_headings_in_other_units_lead_to_the_right_answer(arm, recorded):
    robot, table = recorded
    found, taken = followed(etalon.identify, (robot, table), {"standard_uncertainty_um": 10})
    stated = {name: value for step in taken for name, value in step.get("columns", {}).items()}
    assert stated == {f"q{i}_rad": f"j{i}" for i in range(1, 7)} | {"x_m": "X", "y_m": "Y", "z_m": "Z"}
    assert found.residuals.position_rms_mm < 0.03


def test_inverted_headings_are_turned(recorded):
    robot, table = recorded
    right = {f"q{i}_rad": f"j{i}" for i in range(1, 7)} | {"x_m": "X", "y_m": "Y", "z_m": "Z"}
    inverted = {heading: name for name, heading in right.items()}
    found, taken = followed(etalon.identify, (robot, table), {"columns": inverted, "pose": "row", "target": "SMR", "standard_uncertainty_um": 10})
    assert taken[0]["columns"] == right and found.residuals.position_rms_mm < 0.03


@pytest.mark.parametrize("unit", ["rad", "m", "inch"])
def test_numbers_in_another_unit_get_their_columns(arm, unit):
    robot, table, _ = arm
    joints = [f"q{i}_deg" for i in range(1, 7)] if unit == "rad" else ["x_mm", "y_mm", "z_mm"]
    size = {"rad": np.pi / 180, "m": 1e-3, "inch": 1 / 25.4}[unit]
    others = {"target": "Reflector"}
    changed = {others.get(name, name): np.asarray(column) * size if name in joints else column for name, column in table.items()}
    found, taken = followed(etalon.identify, (robot, changed), {"columns": dict(others), "standard_uncertainty_um": 10})
    right = {f"{name.rsplit('_', 1)[0]}_{unit}": name for name in joints}
    assert taken == [{"columns": others | right}] and found.residuals.position_rms_mm < 0.03


def test_a_pose_of_seven_joints_has_infinitely_many_solutions():
    joints = [0.0, -30, 0, -100, 0, 70, 40]
    pose = etalon.kinematics.direct("panda", joints)
    with pytest.raises(etalon.Error) as raised:
        etalon.kinematics.inverse("panda", pose, near=joints, all_solutions=True)
    assert raised.value.id == "infinite-solutions" and "`all_solutions`" in raised.value.hint
    assert etalon.kinematics.inverse("panda", pose, near=joints).joints == pytest.approx(joints, abs=1e-6)


POSES = {
    "P1": (500.0, 0.0, 500.0, 10.0, 20.0, 30.0),
    "P2": (650.0, -150.0, 650.0, 5.0, 10.0, -20.0),
    "P3": (350.0, 150.0, 350.0, -10.0, 25.0, 15.0),
    "P4": (350.0, -150.0, 500.0, 0.0, -15.0, 40.0),
}


@pytest.fixture
def test_of_poses():
    """Attained poses of 30 cycles, 0.1 mm off, and the commanded ones."""
    pandas = pytest.importorskip("pandas")
    noise = np.random.default_rng(4)
    names = ["x_mm", "y_mm", "z_mm", "a_deg", "b_deg", "c_deg"]
    commanded = pandas.DataFrame([(pose, *values) for pose, values in POSES.items()], columns=["pose", *names])
    rows = [
        (pose, cycle, *(np.array(values) + [0.1, 0, 0, 0, 0, 0.01] + noise.normal(0, [0.01] * 3 + [0.002] * 3)))
        for cycle in range(1, 31)
        for pose, values in POSES.items()
    ]
    return pandas.DataFrame(rows, columns=["pose", "cycle", *names]), commanded


def accuracy(found):
    return [pose.ap_mm for pose in found.poses]


def test_headings_of_an_export_are_found(test_of_poses):
    attained, commanded = test_of_poses
    right = accuracy(etalon.iso9283(attained, commanded))
    other = {"pose": "Pose", "cycle": "Zyklus", "x_mm": "X [mm]", "y_mm": "Y [mm]", "z_mm": "Z [mm]"}
    found, _ = followed(etalon.iso9283, (attained.rename(columns=other), commanded.rename(columns=other)), {})
    assert accuracy(found) == right
    # the angles are not needed, but their headings are named
    angles = {"a_deg": "A", "b_deg": "B", "c_deg": "C"}
    with pytest.warns(etalon.warning_class("columns-not-read")) as caught:
        etalon.iso9283(attained.rename(columns=angles), commanded.rename(columns=angles))
    hint = ast.literal_eval(REMEDY.search(caught[0].message.message.hint)[2])
    assert hint == angles
    found = etalon.iso9283(attained.rename(columns=angles), commanded.rename(columns=angles), columns=hint)
    assert found.poses[0].ap_c_deg == pytest.approx(0.01, abs=0.002)


def test_metres_of_an_export_are_found(test_of_poses):
    attained, commanded = test_of_poses
    right = accuracy(etalon.iso9283(attained, commanded))
    metres = attained.assign(**{f"{axis}_mm": attained[f"{axis}_mm"] / 1000 for axis in "xyz"})
    metres = metres.rename(columns={f"{axis}_mm": f"{axis.upper()} [m]" for axis in "xyz"})
    found, _ = followed(etalon.iso9283, (metres, commanded), {})
    assert accuracy(found) == pytest.approx(right, abs=1e-9)


def test_missing_cycles_are_counted(test_of_poses):
    attained, commanded = test_of_poses
    right = accuracy(etalon.iso9283(attained, commanded))
    found, taken = followed(etalon.iso9283, (attained.drop(columns="cycle"), commanded), {})
    assert taken == [{"cycle": "visit"}] and accuracy(found) == right
    found, taken = followed(etalon.iso9283, (attained.rename(columns={"cycle": "Run"}), commanded), {})
    assert taken == [{"columns": {"cycle": "Run"}}] and accuracy(found) == right


@pytest.mark.parametrize("order", ["zyx", "ZYX", "fixed xyz", "abc", "rpy"])
def test_an_order_of_rotations_is_a_product(test_of_poses, order):
    with pytest.raises(etalon.Error) as raised:
        etalon.iso9283(*test_of_poses, rotation_order=order)
    assert raised.value.id == "rotation-order-unknown"
    orders = [ast.literal_eval(text) for name, text in REMEDY.findall(raised.value.hint) if name == "rotation_order"]
    assert len(orders) == 2
    for stated in orders:
        assert stated in etalon._tasks.RotationOrder.__args__
        assert etalon.iso9283(*test_of_poses, rotation_order=stated).poses[0].ap_mm


def test_workbooks_say_their_sheets(test_of_poses, tmp_path):
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("openpyxl")
    attained, commanded = test_of_poses
    right = accuracy(etalon.iso9283(attained, commanded))
    one, two = tmp_path / "one.xlsx", tmp_path / "two.xlsx"
    attained.to_excel(one, index=False)
    # a single sheet is meant
    assert accuracy(etalon.iso9283(one, commanded)) == pytest.approx(right, abs=1e-9)
    for names in (["Attained", "Commanded"], ["Commanded poses", "Attained poses"], ["M1", "M2"]):
        with pandas.ExcelWriter(two) as writer:
            for name in names:
                (commanded if name.startswith("Com") or name == "M2" else attained).to_excel(writer, sheet_name=name, index=False)
        found, taken = followed(etalon.iso9283, (two, two), {})
        assert len(taken) == 1 and accuracy(found) == pytest.approx(right, abs=1e-9)
    # one workbook beside a table in memory
    found, _ = followed(etalon.iso9283, (two, commanded), {})
    assert accuracy(found) == pytest.approx(right, abs=1e-9)


def test_marks_apply_to_files_alone(test_of_poses, tmp_path):
    attained, commanded = test_of_poses
    right = accuracy(etalon.iso9283(attained, commanded))
    attained.to_csv(tmp_path / "attained.csv", sep=";", decimal=",", index=False)
    found, taken = followed(etalon.iso9283, (tmp_path / "attained.csv", commanded), {})
    assert taken == [{"delimiter": ";", "decimal": ","}]
    assert accuracy(found) == pytest.approx(right, abs=1e-9)
    texts = attained.assign(x_mm=attained.x_mm.map(lambda value: str(value).replace(".", ",")))
    found, taken = followed(etalon.iso9283, (texts, commanded), {})
    assert taken == [{"decimal": ","}] and accuracy(found) == right
    with pytest.raises(etalon.Error, match="mark of a file"):
        etalon.iso9283(attained, commanded, delimiter=";")


def test_directions_of_an_axis_are_no_counts():
    positions = np.repeat(np.arange(5) * 100.0 + 3.1, 4)
    table = {"position_mm": positions, "direction": [1, -1] * 10, "measured_mm": positions + 0.001 * np.arange(20), "run": [1, 1, 2, 2] * 5}
    right = etalon.iso230({name: column for name, column in table.items() if name != "run"})
    for missing, heading in (("direction", "Dir"), ("measured_mm", "Ist")):
        renamed = {heading if name == missing else name: column for name, column in table.items()}
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            with pytest.raises(etalon.Error) as raised:
                etalon.iso230({name: column for name, column in table.items() if name != missing})
            assert '"run"' not in (raised.value.hint or ""), raised.value
            if missing == "direction":
                found, _ = followed(etalon.iso230, (renamed,), {})
                assert found.axis == right.axis


def test_rows_of_a_table_in_memory_are_counted_from_one(arm):
    robot, table, _ = arm
    broken = dict(table, x_mm=np.where(np.isin(np.arange(60), [4, 10, 20]), np.nan, table["x_mm"]))
    with pytest.raises(etalon.Error) as raised:
        etalon.identify(robot, broken)
    assert "row 5, 11, 21" in str(raised.value), str(raised.value)
    assert "line" not in str(raised.value) and raised.value.messages[-1].place == {"file": "observations", "row": 5}
    # a message of the answer counts in the same way
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        found = etalon.identify(robot, dict(table, q3_deg=np.where(np.arange(60) == 4, np.nan, table["q3_deg"])), standard_uncertainty_um=10)
    left = next(entry.message.message for entry in caught if entry.message.message.id == "rows-not-measured")
    assert left.what.endswith("(row 5)") and left.what in repr(found) and left.what in found._repr_html_()
    # the same number leaves the row out
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = etalon.identify(robot, broken, exclude_rows="5, 11, 21: not measured", standard_uncertainty_um=10)
    assert len(found.residuals_table()) == 57


def test_a_misspelt_target_is_corrected(arm):
    robot, table, _ = arm
    found = etalon.identify(robot, table, standard_uncertainty_um=10)
    with pytest.raises(etalon.Error) as raised:
        etalon.kinematics.predict(robot, found, [0.0] * 6, "SMRR")
    assert "did you mean `SMR`" in raised.value.hint


def test_cells_and_verifications_take_the_headings_of_their_hints(arm):
    points = {"point": ["origin", "x", "xy"], "X": [100.0, 400, 120], "Y": [50.0, 60, 300], "Z": [20.0, 25, 22]}
    found, taken = followed(etalon.cell, (points, "three-points"), {"standard_uncertainty_um": 2})
    # all missing columns are named at once
    assert taken == [{"columns": {f"{axis}_mm": axis.upper() for axis in "xyz"}}] and found.frames[0].xyz_mm == pytest.approx([100, 50, 20])
    robot, table, _ = arm
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        calibrated = etalon.identify(robot, table, standard_uncertainty_um=10)
    few = {{"q3_deg": "A3", "z_mm": "Z"}.get(name, name): np.asarray(column)[:8] for name, column in table.items()}
    verified, taken = followed(etalon.verify, (robot, calibrated, few), {})
    assert taken == [{"columns": {"q3_deg": "A3", "z_mm": "Z"}}] and verified.verdict == "valid"


def test_columns_of_an_array_have_their_places_from_one():
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(np.array([[3.1, 3.101, 1], [3.1, 3.102, 1], [3.1, 3.1, -1], [3.1, 3.099, -1], [9.1, 9.101, 1], [9.1, 9.1, 1], [9.1, 9.1, -1], [9.1, 9.098, -1]]))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = etalon.iso230(frame, columns={"position_mm": 1, "measured_mm": 2, "direction": 3})
    assert len(found.positions) == 2
    with pytest.raises(etalon.Error, match="no rows"):
        etalon.iso230(frame[:0])

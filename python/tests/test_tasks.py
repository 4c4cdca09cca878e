"""Commands on tables: against known errors, formulas of the standards, and between libraries of tables."""

import warnings

import numpy as np
import pytest
from conftest import IRB120, dh

import etalon


def test_known_errors_of_an_arm_are_found(arm):
    robot, table, errors = arm
    found = etalon.identify(robot, table, standard_uncertainty_um=10)
    by_name = {parameter.name: parameter for parameter in found.parameters}
    for name, error in errors.items():
        p = by_name[name]
        assert abs(p.value - p.nominal - error) < 5 * p.standard_uncertainty, name
        assert p.standard_uncertainty < abs(error) / 4, name
    assert isinstance(found, etalon.documents.ParametersDocument)
    assert found.to_dict()["schema"].startswith("etalon/parameters/")


@pytest.mark.parametrize("library", ["polars", "pandas", "pyarrow"])
def test_tables_of_libraries_give_the_same_numbers(arm, library):
    robot, table, _ = arm
    module = pytest.importorskip(library)
    frame = module.table(table) if library == "pyarrow" else module.DataFrame(table)
    if not hasattr(frame, "__arrow_c_stream__"):
        pytest.skip(f"this {library} has no Arrow PyCapsule interface")
    if library == "pandas":
        pytest.importorskip("pyarrow")
    values = [[p.value for p in etalon.identify(robot, of).parameters] for of in (table, frame)]
    assert values[0] == values[1]


def test_a_csv_file_gives_the_same_numbers(arm, tmp_path):
    robot, table, _ = arm
    rows = zip(*(list(column) for column in table.values()))
    text = ",".join(table) + "\n" + "\n".join(",".join(map(str, row)) for row in rows) + "\n"
    (tmp_path / "table.csv").write_text(text)
    values = [[p.value for p in etalon.identify(robot, of).parameters] for of in (table, tmp_path / "table.csv")]
    assert values[0] == values[1]


def test_messages_and_inputs_have_the_name_of_the_file(arm, tmp_path):
    robot, table, _ = arm
    path = tmp_path / "measured.csv"
    rows = list(zip(*(list(column) for column in table.values())))
    text = ",".join(table) + "\n" + "\n".join(",".join(map(str, row)) for row in rows) + "\n"
    path.write_text(text)
    assert str(path) in etalon.identify(robot, path).provenance.inputs
    path.write_text(text.replace(str(rows[4][0]), "?", 1).replace("x_mm", "x_foot", 1))
    with pytest.raises(etalon.Error) as raised:
        etalon.identify(robot, path)
    files = {message.place["file"] for message in raised.value.messages if message.place}
    assert files == {str(path)}, str(raised.value)
    # a table without a file has the name of the argument
    with pytest.raises(etalon.Error) as raised:
        etalon.identify(robot, dict(table, x_mm=np.full(60, np.nan)))
    assert {message.place["file"] for message in raised.value.messages if message.place} == {"observations"}


def test_the_error_before_identification_is_beside_the_one_after(arm):
    robot, table, _ = arm
    residuals = etalon.identify(robot, table, standard_uncertainty_um=10).residuals
    assert residuals.position_rms_before_mm > 5 * residuals.position_rms_mm
    # a robot whose parameters all keep their nominal values has one error
    held = etalon.identify(robot, table, hold=["a_*", "alpha_*", "beta_*", "d_*", "theta_*"]).residuals
    assert held.position_rms_before_mm == pytest.approx(held.position_rms_mm, rel=1e-6)
    assert held.position_rms_before_mm == pytest.approx(residuals.position_rms_before_mm, rel=1e-6)


def test_options_reach_the_identification(arm):
    robot, table, _ = arm
    renamed = {{"q1_deg": "J1"}.get(name, name): column for name, column in table.items() if name != "target"}
    found = etalon.identify(robot, renamed, hold=["a_3"], target="SMR", columns={"q1_deg": "J1"})
    held = next(p for p in found.parameters if p.name == "a_3")
    assert held.value == held.nominal
    with pytest.raises(etalon.Error, match="effects|nonsense"):
        etalon.identify(robot, table, effects=["nonsense"])


def test_a_wrong_value_is_named_with_the_valid_ones(arm):
    robot, table, _ = arm
    with pytest.raises(etalon.Error, match="`prior`: .*`tolerances`"):
        etalon.identify(robot, table, prior="no")
    with pytest.raises(etalon.Error, match="`positions`"):
        etalon.plan(robot, table, "many")
    with pytest.raises(etalon.Error, match="`solve`: .*`hand-eye`"):
        etalon.cell(table, "nonsense")
    # numbers of NumPy are numbers
    found = etalon.plan(robot, table, np.int64(20), nodes=10, starts=1, standard_uncertainty_um=np.float64(15))
    assert len(found.chosen) == 20


def test_what_is_wrong_with_a_table_is_raised_with_its_place(arm):
    robot, table, _ = arm
    without = {name: column for name, column in table.items() if name != "q3_deg"}
    with pytest.raises(etalon.Error, match="q3_deg"):
        etalon.identify(robot, without)
    broken = dict(table, x_mm=np.where(np.arange(60) == 4, np.nan, table["x_mm"]))
    with pytest.raises(etalon.Error) as raised:
        etalon.identify(robot, broken)
    assert any(message.place and message.place.get("row") == 5 for message in raised.value.messages), str(raised.value)
    with pytest.raises(etalon.Error, match="length"):
        etalon.identify(robot, dict(table, x_mm=[1.0]))
    with pytest.raises(etalon.Error, match="not a table"):
        etalon.identify(robot, 5)


def test_a_reversed_joint_is_named(arm):
    robot, table, _ = arm
    with pytest.raises(etalon.Error) as raised:
        etalon.identify(robot, dict(table, q6_deg=-np.asarray(table["q6_deg"])), standard_uncertainty_um=10)
    assert "`q6` reversed" in raised.value.hint


def test_names_and_headings_the_wrong_way_round_are_named(arm):
    robot, table, _ = arm
    renamed = {{"q1_deg": "A1"}.get(name, name): column for name, column in table.items()}
    with pytest.raises(etalon.Error) as raised:
        etalon.identify(robot, renamed, columns={"A1": "q1_deg"})
    assert raised.value.id == "columns-inverted" and '`columns={"q1_deg": "A1"}`' in raised.value.hint
    # etalon's `target` under the heading `pose`
    renamed = {{"pose": "no", "target": "pose"}.get(name, name): column for name, column in table.items()}
    found = etalon.identify(robot, renamed, columns={"pose": "no", "target": "pose"}, standard_uncertainty_um=10)
    assert any(parameter.name.startswith("SMR") for parameter in found.parameters)


def test_parameters_are_verified(arm):
    robot, table, _ = arm
    found = etalon.identify(robot, table, standard_uncertainty_um=10)
    some = {name: np.asarray(column)[:12] for name, column in table.items()}
    assert etalon.verify(robot, found, some).verdict == "valid"
    moved = dict(some, q3_deg=np.asarray(some["q3_deg"]) + 0.1)
    changed = etalon.verify(robot, found, moved)
    assert changed.verdict == "joint", changed.to_dict()


def test_identified_parameters_move_the_kinematics(arm):
    robot, table, _ = arm
    found = etalon.identify(robot, table, standard_uncertainty_um=10)
    joints = np.column_stack([table[f"q{i}_deg"] for i in range(1, 7)])
    nominal = etalon.kinematics.direct(robot, joints).xyz_mm
    identified = etalon.kinematics.direct(robot, joints, parameters=found).xyz_mm
    assert np.linalg.norm(identified - nominal, axis=1).max() > 0.2


def test_poses_are_planned(arm):
    robot, table, _ = arm
    candidates = {name: column for name, column in table.items() if name in ("pose", "target") or name.endswith("_deg")}
    found = etalon.plan(robot, candidates, 20, nodes=10, starts=1)
    assert len(found.chosen) == 20 and found.bound >= found.value


def test_axes_of_sweeps_are_those_of_the_arm():
    """Sweeps of an exact arm: its own directions of axes."""
    nominal = np.array([20.0, -30.0, 25.0, 40.0, 35.0, 10.0])
    rows, poses = [], 0
    for joint in range(6):
        for angle in np.linspace(-60.0, 60.0, 15):
            values = nominal.copy()
            values[joint] += angle
            rows.append((f"q{joint + 1}", values))
    joints = np.array([values for _, values in rows])
    xyz = (dh(joints, *IRB120) @ np.array([80.0, 40.0, 60.0, 1.0]))[:, :3]
    table = {"joint": [name for name, _ in rows], "target": ["SMR"] * len(rows)}
    table |= {f"q{i + 1}_deg": joints[:, i] for i in range(6)} | {name: xyz[:, k] for k, name in enumerate(["x_mm", "y_mm", "z_mm"])}
    found = etalon.axes(table, standard_uncertainty_um=10)
    alpha, a, theta, d = IRB120
    for axis in found.axes:
        count = int(axis.joint[1:])
        start = dh(nominal[None, :count], alpha[:count], a[:count], theta[:count], d[:count])[0]
        assert np.abs(np.cross(axis.direction, start[:3, 2])).max() < 1e-6, axis.joint
    with pytest.raises(etalon.Error):
        etalon.axes({name: column[:2] for name, column in table.items()})


def test_the_tool_point_is_found():
    """Orientations about one point: an exact tool of (10, -20, 150) mm."""
    noise = np.random.default_rng(3)
    flange = dh(noise.uniform(-80, 80, (8, 6)), *IRB120)[:, :3, :3]
    position = np.array([400.0, 100.0, 300.0]) - flange @ np.array([10.0, -20.0, 150.0])
    # Rz(a) Ry(b) Rx(c)
    a = np.degrees(np.arctan2(flange[:, 1, 0], flange[:, 0, 0]))
    b = np.degrees(np.arctan2(-flange[:, 2, 0], np.hypot(flange[:, 2, 1], flange[:, 2, 2])))
    c = np.degrees(np.arctan2(flange[:, 2, 1], flange[:, 2, 2]))
    table = {f"flange_{name}_mm": position[:, k] for k, name in enumerate("xyz")}
    table |= {"flange_a_deg": a, "flange_b_deg": b, "flange_c_deg": c}
    found = etalon.cell(table, "tool-point", orientation="zyx", standard_uncertainty_um=20)
    point = next(p for p in found.points if p.reference == "flange")
    assert np.abs(np.array(point.xyz_mm) - [10.0, -20.0, 150.0]).max() < 1e-6
    with pytest.raises(etalon.Error) as raised:
        etalon.cell(table, "tool-point", standard_uncertainty_um=20)
    assert raised.value.messages


def test_any_command_runs_in_this_process(arm, tmp_path):
    robot, table, _ = arm
    found = etalon.identify(robot, table, standard_uncertainty_um=10)
    (tmp_path / "parameters.json").write_text(found.to_json())
    written = etalon.command("export", tmp_path / "parameters.json", format=["csv", "json"], to=tmp_path / "files")
    assert written.met and isinstance(written.document, etalon.documents.WrittenDocument)
    assert (tmp_path / "files" / "controller.csv").is_file(), written.document.files
    explained = etalon.command("explain", "unit-unknown").document
    assert explained.messages
    with pytest.raises(etalon.Error, match="nonsense"):
        etalon.command("export", tmp_path / "parameters.json", nonsense=True)
    with pytest.raises(etalon.Error) as raised:
        etalon.command("run", tmp_path / "missing")
    assert raised.value.id and raised.value.message


def test_accuracy_and_repeatability_are_those_of_the_formulas():
    """ISO 9283:1998, 7.2.1 and 7.2.2."""
    noise = np.random.default_rng(5)
    commanded = {"pose": [1, 2], "x_mm": [0.0, 100.0], "y_mm": [0.0, 50.0], "z_mm": [0.0, 20.0]}
    points = np.array([[0.1, 0.0, 0.0], [100.0, 50.2, 20.0]])[:, None] + noise.normal(0, 0.02, (2, 30, 3))
    attained = {"pose": np.tile([1, 2], 30), "cycle": np.repeat(np.arange(1, 31), 2)}
    attained |= {name: points[:, :, k].T.ravel() for k, name in enumerate(["x_mm", "y_mm", "z_mm"])}
    found = etalon.iso9283(attained, commanded)
    for k, pose in enumerate(found.poses):
        mean = points[k].mean(axis=0)
        target = np.array([commanded[name][k] for name in ("x_mm", "y_mm", "z_mm")])
        distances = np.linalg.norm(points[k] - mean, axis=1)
        text = pose.to_json()
        expected = (np.linalg.norm(mean - target), distances.mean() + 3 * distances.std(ddof=1))
        for value in expected:
            assert any(abs(number - value) < 1e-9 for number in numbers(pose.to_dict())), (value, text)


def numbers(value):
    """All numbers in a document."""
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, list):
        return [number for item in value for number in numbers(item)]
    return [value] if isinstance(value, float) else []


def test_positioning_is_that_of_the_formulas():
    """ISO 230-2:2014: repeatability of a direction 4 s, reversal |mean up - mean down|."""
    up, down = np.array([0.001, 0.003, 0.002]), np.array([-0.002, -0.001, -0.003])
    table = {
        "position_mm": np.repeat([0.0, 100.0], 6),
        "measured_mm": np.concatenate([up, down, 100 + up, 100 + down]),
        "direction": np.tile([1, 1, 1, -1, -1, -1], 2),
    }
    axis = etalon.iso230(table).axis
    assert axis.reversal_mm == pytest.approx(0.004, abs=1e-12)
    assert axis.repeatability.forward_mm == pytest.approx(4 * up.std(ddof=1), abs=1e-12)


def test_positions_of_targets_are_stated_in_the_file_or_as_an_argument(arm):
    robot, table, _ = arm
    text = robot.toml + "[nominal]\nSMR_x = 30\nSMR_y = 10\nSMR_z = 60\n"
    stated = etalon.Robot.from_toml(text)
    names = {p.name: p.nominal for p in stated.parameters}
    assert (names["SMR_x"], names["SMR_y"], names["SMR_z"]) == (30, 10, 60) and "tool_x" not in names
    place = {"SMR": (30, 10, 60)}
    assert stated.parameters == robot.with_targets(place).parameters
    with pytest.raises(etalon.Error, match="coordinates"):
        robot.with_targets({"SMR": (30, 10)})
    # the zero of the last joint moves a target beside its axis alone
    plans = [etalon.plan(of, table, 30, starts=1, targets=at) for of, at in ((robot, None), (robot, place), (stated, None))]
    free = [{p.name: p.identifiable for p in plan.parameters} for plan in plans]
    assert free[1] == free[2] and sum(free[1].values()) > sum(free[0].values())
    assert plans[1].value == pytest.approx(plans[2].value, rel=1e-9)
    found = etalon.identify(robot, table, standard_uncertainty_um=10, targets=place)
    assert etalon.verify(robot, found, table, targets=place).verdict == "valid"


def test_a_file_with_other_marks_is_read_as_stated(arm, tmp_path):
    robot, table, _ = arm
    rows = zip(*(list(column) for column in table.values()))
    lines = [list(table)] + [[str(value).replace(".", ",") for value in row] for row in rows]
    path = tmp_path / "german.csv"
    path.write_text("\n".join(";".join(line) for line in lines) + "\n")
    marks = {"delimiter": ";", "decimal": ","}
    values = [[p.value for p in found.parameters] for found in (etalon.identify(robot, table), etalon.identify(robot, path, **marks))]
    assert values[0] == values[1]
    assert etalon.plan(robot, path, 30, starts=1, delimiter=";", decimal=",").chosen
    with pytest.raises(etalon.Error, match="delimiter"):
        etalon.identify(robot, path)
    for mark in ({"delimiter": ";"}, {"sheet": "A"}):
        with pytest.raises(etalon.Error, match="mark of a file"):
            etalon.identify(robot, table, **mark)


def test_a_sheet_of_a_workbook_is_a_table(arm, tmp_path):
    openpyxl = pytest.importorskip("openpyxl")
    robot, table, _ = arm
    book = openpyxl.Workbook()
    book.active.append(["a", "note"])
    sheet = book.create_sheet("poses")
    sheet.append(list(table))
    for row in zip(*(np.asarray(column).tolist() for column in table.values())):
        sheet.append(row)
    book.save(tmp_path / "arm.xlsx")
    values = [[p.value for p in found.parameters] for found in (etalon.identify(robot, table), etalon.identify(robot, tmp_path / "arm.xlsx", sheet="poses"))]
    assert values[0] == pytest.approx(values[1], abs=1e-9)
    with pytest.raises(etalon.Error, match="missing.xlsx"):
        etalon.identify(robot, tmp_path / "missing.xlsx")


def attained_poses():
    """Thirty cycles of two poses, in tables of another program."""
    noise = np.random.default_rng(5)
    rows = [(f"P{k + 1}", cycle, *(np.array([100.0 * k, 50 * k, 20 * k]) + noise.normal(0, 0.02, 3))) for cycle in range(1, 31) for k in range(2)]
    return dict(zip(["Punkt", "Zyklus", "X", "Y", "Z"], map(list, zip(*rows)))), {"Punkt": ["P1", "P2"], "X": [0.0, 100], "Y": [0.0, 50], "Z": [0.0, 20]}


def test_files_with_other_marks_and_headings_are_tests_of_the_standard(tmp_path):
    attained, commanded = attained_poses()
    columns = {"pose": "Punkt", "cycle": "Zyklus", "x_mm": "X", "y_mm": "Y", "z_mm": "Z"}
    with pytest.raises(etalon.Error) as raised:
        etalon.iso9283(attained, commanded)
    assert 'columns={"pose": ' in str(raised.value)
    paths = []
    for name, table in (("attained", attained), ("commanded", commanded)):
        lines = [";".join(table)] + [";".join(str(value).replace(".", ",") for value in row) for row in zip(*table.values())]
        paths.append(tmp_path / f"{name}.csv")
        paths[-1].write_text("\n".join(lines) + "\n")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", etalon.MessageWarning)
        found = etalon.iso9283(attained, commanded, columns=columns)
        of_files = etalon.iso9283(*paths, columns=columns, delimiter=";", decimal=",")
    assert [pose.ap_mm for pose in of_files.poses] == [pose.ap_mm for pose in found.poses]
    # the terminal shows numbers of each pose
    assert f"{found.poses[1].ap_mm:.6g}" in repr(found)
    # marks are those of the file alone
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", etalon.MessageWarning)
        beside = etalon.iso9283(paths[0], commanded, columns=columns, delimiter=";", decimal=",")
    assert [pose.ap_mm for pose in beside.poses] == [pose.ap_mm for pose in found.poses]


@pytest.mark.parametrize("remedy", [{"pose": "row"}, {"target": "SMR"}], ids=str)
def test_replaced_columns_are_keywords_where_hints_name_them(arm, remedy):
    robot, table, _ = arm
    without = {name: column for name, column in table.items() if name not in remedy}
    calls = {"identify": (etalon.identify, (robot, without)), "plan": (etalon.plan, (robot, without, 20))}
    if "pose" in remedy:
        calls["iso9283"] = (etalon.iso9283, ({name: without[name] for name in ("cycle", "x_mm", "y_mm", "z_mm")},))
    stated = next(f'{name}="' for name in remedy)
    for name, (function, arguments) in calls.items():
        with pytest.raises(etalon.Error) as raised:
            function(*arguments)
        assert stated in str(raised.value), (name, str(raised.value))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            try:
                function(*arguments, **remedy)
            except etalon.Error as error:
                # the column is no longer missing
                assert stated not in str(error), (name, str(error))


def test_options_of_a_command_take_dictionaries():
    assert etalon._options.options_of(column={"q1_deg": "J1", "x_mm": "X"}) == ["--column=q1_deg=J1", "--column=x_mm=X"]


def test_a_predicted_position_has_an_uncertainty(arm):
    robot, table, _ = arm
    found = etalon.identify(robot, table, standard_uncertainty_um=10)
    joints = np.column_stack([table[f"q{i}_deg"] for i in range(1, 7)])
    predicted = etalon.kinematics.predict(robot, found, joints, "SMR")
    measured = np.column_stack([table[name] for name in ("x_mm", "y_mm", "z_mm")])
    free = [p for p in found.parameters if p.status == "identified" and p.name not in (found.get("covariance_without") or [])]
    assert len(free) == len(found.covariance)
    assert found.covariance[0][0] ** 0.5 == pytest.approx(free[0].standard_uncertainty, rel=1e-6)
    assert np.sqrt(np.mean((predicted.xyz_mm - measured) ** 2)) < 0.012
    assert (predicted.standard_uncertainty_mm < 0.012).all() and (predicted.standard_uncertainty_mm > 0.0005).all()
    with pytest.raises(etalon.Error):
        etalon.kinematics.predict(robot, found, joints, "other")


def test_a_bound_of_the_uncertainty_is_stated_in_the_call():
    with pytest.raises(etalon.Error, match="uncertainty_bound|bound"):
        etalon.axes({"joint": ["q1"], "target": ["a"], "x_mm": [0.0], "y_mm": [0.0], "z_mm": [0.0]}, uncertainty_bound="nonsense")


def test_residuals_are_a_table_of_the_readings_of_the_call(arm):
    robot, table, _ = arm
    measured = {name: np.array(column) for name, column in table.items()}
    found = etalon.identify(robot, measured, standard_uncertainty_um=10)
    measured["x_mm"][:] = 0.0
    errors = found.residuals_table().to_dict()
    assert errors["pose"] == list(range(1, 61)) and set(errors["target"]) == {"SMR"}
    after = np.array([errors[f"after_{axis}_mm"] for axis in "xyz"])
    before = np.array([errors[f"before_{axis}_mm"] for axis in "xyz"])
    assert np.sqrt((after**2).sum(axis=0).mean()) == pytest.approx(found.residuals.position_rms_mm, rel=1e-9)
    assert np.sqrt((before**2).sum(axis=0).mean()) == pytest.approx(found.residuals.position_rms_before_mm, rel=1e-9)
    # measured minus predicted
    joints = np.column_stack([table[f"q{i}_deg"] for i in range(1, 7)])
    predicted = etalon.kinematics.predict(robot, found, joints, "SMR").xyz_mm
    assert after.T == pytest.approx(np.column_stack([table[name] for name in ("x_mm", "y_mm", "z_mm")]) - predicted, abs=1e-9)


@pytest.mark.parametrize("library", ["pandas", "polars", "pyarrow"])
def test_tables_of_documents_are_tables_of_libraries(arm, library):
    pytest.importorskip(library)
    robot, table, _ = arm
    found = etalon.identify(robot, table, standard_uncertainty_um=10)
    method = "to_arrow" if library == "pyarrow" else f"to_{library}"
    for records in (found.parameters, found.residuals_table()):
        frame = getattr(records, method)()
        column = "value" if records is not None and "value" in records.to_dict() else "after_x_mm"
        values = frame[column].to_pylist() if library == "pyarrow" else frame[column].to_list()
        assert values == records.column(column)


def test_a_data_frame_needs_no_pyarrow(arm, monkeypatch):
    pandas = pytest.importorskip("pandas")
    robot, table, _ = arm
    frame = pandas.DataFrame(table)
    monkeypatch.delattr(pandas.DataFrame, "__arrow_c_stream__", raising=False)
    values = [[p.value for p in etalon.identify(robot, of).parameters] for of in (table, frame)]
    assert values[0] == values[1]
    indexed = [p.value for p in etalon.identify(robot, frame.set_index(["pose", "cycle"])).parameters]
    assert indexed == values[0]
    missing = frame.copy()
    missing.loc[4, "x_mm"] = None
    with pytest.raises(etalon.Error):
        etalon.identify(robot, missing)
    twice = pandas.concat([frame, frame[["x_mm"]]], axis=1)
    with pytest.raises(etalon.Error, match="same heading twice"):
        etalon.identify(robot, twice)


def test_masked_values_are_missing_values(arm):
    robot, table, _ = arm
    mask = np.arange(60) == 4
    masked = {axis: np.ma.array(table[axis], mask=mask) for axis in ("x_mm", "y_mm", "z_mm")}
    without = {name: np.asarray(column)[~mask] for name, column in table.items()}
    values = []
    for of in (table | masked, table | {axis: np.where(mask, np.nan, table[axis]) for axis in ("x_mm", "y_mm", "z_mm")}, without):
        try:
            values.append([p.value for p in etalon.identify(robot, of, standard_uncertainty_um=10).parameters])
        except etalon.Error as error:
            values.append(error.id)
    assert values[0] == values[1]
    with pytest.raises(etalon.Error, match="masked"):
        etalon.kinematics.direct(robot, np.ma.array(np.zeros((2, 6)), mask=np.eye(2, 6)))
    with pytest.raises(etalon.Error, match="masked"):
        etalon.fit.plane(np.ma.array(np.random.default_rng(0).normal(size=(9, 3)), mask=np.eye(9, 3)))


def test_documents_show_values_with_their_uncertainty_and_messages_first(arm):
    robot, table, _ = arm
    found = etalon.identify(robot, table | {"remark": ["-"] * 60}, standard_uncertainty_um=10)
    shown = found._repr_html_()
    assert shown.index(found.messages[0].id) < shown.index("value ± U (k = 2)") < shown.index("provenance")
    entry = next(p for p in found.parameters if p.name == "a_3")
    text = repr(found)
    line = next(line for line in text.splitlines() if line.split()[:1] == ["a_3"])
    value, _, expanded, unit = line.split()[1:]
    assert float(value) == pytest.approx(entry.value, abs=entry.standard_uncertainty) and unit == "mm"
    assert float(expanded) == pytest.approx(2 * entry.standard_uncertainty, rel=0.06)
    assert found.messages[0].id in text.split("value ±")[0]


def test_members_are_typed_by_the_schemas():
    points = np.random.default_rng(3).normal(size=(20, 3))
    found = etalon.fit.sphere(points)
    assert isinstance(found.center_mm, np.ndarray) and (found.center_mm / 10).shape == (3,)
    assert type(found.radius_mm) is float and type(found.standard_uncertainty.radius_mm) is float
    # residuals belong to the points of the call
    before = found.residuals_mm.copy()
    points[:] = 0.0
    assert (found.residuals_mm == before).all()
    # members that hide nothing, and whose names are keywords
    record = etalon.documents.Record({"keys": ["a"], "values": [1.5], "import": 1})
    assert record.keys == ["a"] and record.values == [1.5] and record.import_ == 1 and record["import"] == 1
    with pytest.raises(AttributeError, match="it has keys"):
        record.nothing


def test_drawings_are_made(arm):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    points = np.random.default_rng(3).normal(size=(20, 3))
    assert etalon.fit.sphere(points).plot().get_ylabel() == "residual (µm)"
    assert etalon.Robot("ur5e").plot([[0] * 6, [10, -90, 80, 0, 0, 0]]).get_xlabel() == "x (mm)"
    robot, table, _ = arm
    assert etalon.identify(robot, table, standard_uncertainty_um=10).plot().get_ylabel()

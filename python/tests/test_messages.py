"""Warnings and errors: by id, at the caller's line, and with remedies in Python."""

import inspect
import json
import pickle
import re
import warnings
from pathlib import Path

import numpy as np
import pytest

import etalon
from etalon._errors import Message, python_words, warn

FOLDER = Path(__file__).resolve().parents[1]


def test_a_warning_has_the_class_of_its_id_and_points_at_the_call(arm):
    robot, table, _ = arm
    spare = table | {"remark": ["-"] * 60}
    with pytest.warns(etalon.MessageWarning) as caught:
        found = etalon.identify(robot, spare, standard_uncertainty_um=10)
    ids = {entry.message.message.id for entry in caught}
    assert ids == {message.id for message in found.messages} and ids
    for entry in caught:
        assert Path(entry.filename).name == Path(__file__).name
        assert isinstance(entry.message, etalon.warning_class(entry.message.message.id))
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        for id in ids:
            warnings.simplefilter("ignore", etalon.warning_class(id))
        etalon.identify(robot, spare, standard_uncertainty_um=10)
    assert not caught
    with warnings.catch_warnings(), pytest.raises(etalon.MessageWarning):
        warnings.simplefilter("error", etalon.MessageWarning)
        etalon.identify(robot, spare, standard_uncertainty_um=10)


def test_an_implausible_result_has_both_classes():
    message = Message({"severity": "error", "id": "tolerance-exceeded", "what": "1 parameter is beyond the tolerance", "hint": "check signs"})
    with pytest.warns(etalon.ImplausibleWarning, match="tolerance-exceeded.*\nhint: check signs") as caught:
        warn([message])
    assert isinstance(caught[0].message, etalon.warning_class("tolerance-exceeded"))
    # from the process of a pool
    again = pickle.loads(pickle.dumps(caught[0].message))
    assert type(again) is type(caught[0].message) and str(again) == str(caught[0].message)


def test_few_poses_do_not_pass_in_silence(arm):
    """Five poses fit ten parameters exactly: the residuals say nothing of the errors elsewhere."""
    robot, table, _ = arm
    few = {name: np.asarray(column)[:12] for name, column in table.items()}
    with pytest.warns(etalon.MessageWarning):
        found = etalon.identify(robot, few)
    assert found.messages


def test_a_run_and_a_fit_warn(sample):
    # the sample itself is sound
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        run = etalon.run(sample("prexyt-cmm"), reports=False)
    assert [entry.message.message.id for entry in caught] == [message.id for message in run.messages]
    corners = np.array([[x, y, z] for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])
    with pytest.warns(etalon.warning_class("element-ambiguous")):
        etalon.fit.plane(corners)


@pytest.mark.parametrize(
    ("shell", "python"),
    [
        ("state it: --unit mm", "state it: unit= mm"),
        ("name the column: `--column x_mm=HEADING`", 'name the column: `columns={"x_mm": "HEADING"}`'),
        ('state the order: `--rotation-order "Rz(c) Ry(b) Rx(a)"`', 'state the order: `rotation_order="Rz(c) Ry(b) Rx(a)"`'),
        ("hold parameters with `--hold`", "hold parameters with `hold=`"),
        ("or --standard-uncertainty-um of `etalon identify`", "or standard_uncertainty_um= of `etalon identify`"),
        ("state `--mounting target` (the instrument stands)", 'state `mounting="target"` (the instrument stands)'),
        ('state `columns = { x_mm = "X" }` (option --column)', 'state `columns={"x_mm": "X"}`'),
        ('or `pose = "row"` if', 'or `pose="row"` if'),
        ("`etalon cell --help` lists the columns", "`help(etalon.cell)` lists the columns"),
        ("`etalon export --help` lists them", "`etalon export --help` lists them"),
        ("name it under `hold` in [identify]; by default", "name it under `hold=`; by default"),
        ("hold parameters with `hold` in [identify] or --hold", "hold parameters with `hold=`"),
        ('state `orientation = "zyx"` in [observations], or --orientation', 'state `orientation="zyx"`'),
        ("state `drift_set` in [poses] (`--drift-set`), or warm up", "state `drift_set=`, or warm up"),
        ("omit these poses (`exclude`, --exclude)", "omit these poses (`exclude=`)"),
        ("a column `u_mm`, `expanded_uncertainty_um` in [instrument], or --standard-uncertainty-um", "a column `u_mm`, or standard_uncertainty_um="),
        ('state `target = "NAME"` of the table (option --target), a column `target`, or `targets` in [join]', 'state `target="NAME"` of the table, a column `target`'),
        ("choose another key with `by` in [join]", "choose another key with `by` in [join]"),
        ("measured - nominal -- by hand", "measured - nominal -- by hand"),
    ],
)
def test_options_of_hints_are_keyword_arguments(shell, python):
    assert python_words(shell) == python


def calls(arm):
    """Calls with a mistake, and the function that has to take the remedy of the hint."""
    robot, table, _ = arm
    poses = {"pose": [1] * 4, "cycle": [1, 2, 3, 4], "X": [1.0, 2, 3, 4], "y_mm": [1.0, 2, 3, 4], "z_mm": [1.0, 2, 3, 4]}
    axis = {"P": [0.0] * 4, "measured_mm": [0.0, 0.1, 0.0, 0.1], "direction": [1, 1, -1, -1]}
    motion = {"time_s": np.arange(300) / 100, "X": np.zeros(300), "y_mm": np.zeros(300), "z_mm": np.zeros(300)}
    renamed = {{"q1_deg": "J1"}.get(name, name): column for name, column in table.items()}
    return {
        "iso9283": (etalon.iso9283, (poses,), {"columns": {"x_mm": "X"}}),
        "iso230": (etalon.iso230, (axis,), {"columns": {"position_mm": "P"}}),
        "iso9283_path": (etalon.iso9283_path, (motion,), {"columns": {"x_mm": "X"}}),
        "identify": (etalon.identify, (robot, renamed), {"columns": {"q1_deg": "J1"}}),
        "plan": (etalon.plan, (robot, renamed, 20), {"columns": {"q1_deg": "J1"}}),
    }


@pytest.mark.parametrize("name", ["iso9283", "iso230", "iso9283_path", "identify", "plan"])
def test_every_table_takes_headings_and_its_hints_are_accepted(arm, name):
    function, arguments, remedy = calls(arm)[name]
    with pytest.raises(etalon.Error) as raised:
        function(*arguments)
    heading = next(iter(remedy["columns"]))
    text = str(raised.value)
    assert heading in text and not re.search(r"--[a-z]", text), text
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        function(*arguments, **remedy)


def test_options_in_hints_are_keywords_of_some_function():
    """Every option in a text of the catalogue is a keyword of a function, or an option of a command, which `command` takes."""
    functions = [etalon.identify, etalon.plan, etalon.verify, etalon.axes, etalon.cell, etalon.iso9283, etalon.iso9283_path, etalon.iso230]
    functions += [etalon.fit.element, etalon.validate, etalon.command]
    keywords = {name for function in functions for name in inspect.signature(function).parameters}
    known = set(keywords)
    for words in (["init"], ["run"], ["identify"], ["plan"], ["fit"], ["export"], ["compensate"], ["kinematics", "inverse"], ["validate"], ["cell"], ["axes"]):
        text = etalon.command(*words, help=True).text
        known |= {option.replace("-", "_") for option in re.findall(r"--([a-z][a-z0-9-]*)", text)}
    for name in ("stages", "documents", "formats"):
        for line in (FOLDER.parent / f"src/base/messages/en/{name}.ftl").read_text(encoding="utf-8").splitlines():
            if line.startswith("#"):
                continue
            for option in re.findall(r"(?<![\w-])--([a-z][a-z0-9-]*)", line):
                assert option.replace("-", "_") in known or option in OTHER_PROGRAMS, line


def test_hints_of_tables_name_no_section_of_a_campaign():
    """Of the texts with a key of [identify], the others belong to a verdict on a campaign."""
    left = set()
    for path in (FOLDER.parent / "src/base/messages/en").glob("*.ftl"):
        for line in path.read_text(encoding="utf-8").splitlines():
            if not line.startswith("#") and path.stem in ("stages", "documents", "identify", "fit", "formats"):
                left |= {line.split(" = ")[0].strip() for _ in re.findall(r"(?:in|of) \[(?:identify|observations)\]", python_words(line))}
    assert left == {"action-add-validation", "action-prove-effects", "action-prove-effects-first"}


#: Options of other programs, and of commands that the test above does not list.
OTHER_PROGRAMS = {"src", "dst", "dst-storage", "start", "end", "compression-mode", "rotation-order", "near-mm", "rate-hz", "with", "tool-length-mm"}
OTHER_PROGRAMS |= {"number", "frames", "field", "without", "orientation", "parameters", "force", "json", "solve", "help"}


def test_errors_are_those_of_etalon(arm, tmp_path):
    robot, table, _ = arm
    identify = etalon.identify
    wrong = {
        "text in a column": lambda: identify(robot, table | {"x_mm": ["a"] * 60}),
        "two dimensions": lambda: identify(robot, table | {"x_mm": np.zeros((60, 2))}),
        "a number as a column": lambda: identify(robot, table | {"x_mm": 1.0}),
        "a missing file": lambda: identify(robot, tmp_path / "missing.csv"),
        "a missing robot": lambda: identify(tmp_path / "missing.toml", table),
        "a number as a robot": lambda: identify(5, table),
        "a list as a table": lambda: identify(robot, [1, 2]),
        "missing parameters": lambda: etalon.verify(robot, tmp_path / "missing.json", table),
        "a number as parameters": lambda: etalon.kinematics.direct(robot, [0.0] * 6, parameters=5),
        "text as joints": lambda: etalon.kinematics.direct(robot, "abc"),
        "headings that are no dictionary": lambda: identify(robot, table, columns=["q1_deg"]),
        "targets that are no positions": lambda: identify(robot, table, targets={"SMR": "x"}),
        "a missing campaign": lambda: etalon.run(tmp_path / "missing"),
        "a number as a campaign": lambda: etalon.check(5),
        "an option of the wrong type": lambda: identify(robot, table, standard_uncertainty_um="ten"),
        "weights of another length": lambda: etalon.fit.plane(np.eye(3), weights=[1, 2]),
        "three dimensions of joints": lambda: etalon.kinematics.direct(robot, np.zeros((2, 3, 6))),
        "three dimensions of starts": lambda: etalon.kinematics.inverse(robot, np.eye(4), near=np.zeros((1, 2, 6))),
        "a number as progress": lambda: etalon.plan(robot, table, 20, progress=5),
        "a Series as a table": lambda: identify(robot, pytest.importorskip("pandas").Series([1.0])),
        "an unknown element": lambda: etalon.fit.element("square", np.eye(3)),
        "no joints": lambda: etalon.kinematics.direct(robot, None),
        "no points": lambda: etalon.fit.plane(None),
        "an uncertainty that is no number": lambda: identify(robot, table, standard_uncertainty_um=float("nan")),
        "a number as effects": lambda: identify(robot, table, effects=3),
        "a text as positions": lambda: etalon.plan(robot, table, "many"),
        "fewer than no positions": lambda: etalon.plan(robot, table, -1),
        "a text as a seed": lambda: etalon.iso9283(table, seed="x"),
        "a text as draws": lambda: etalon.uncertainty(tmp_path, draws="x"),
        "a number as campaigns": lambda: etalon.batch(5),
        "a number as a command": lambda: etalon.command(5),
        "no text of a robot": lambda: etalon.Robot.from_toml(None),
        "no URDF": lambda: etalon.Robot.from_urdf(None),
        "a number as a link": lambda: etalon.Robot.from_urdf(tmp_path / "a.urdf", tool_link=5),
        "text as joints of a drawing": lambda: robot.plot("x"),
    }
    for name, call in wrong.items():
        with pytest.raises(etalon.Error) as raised:
            call()
        assert str(raised.value) and not re.search(r"usize|u64|NoneType\b.*object|Usage:", str(raised.value)), name
    with pytest.raises(etalon.Error, match="`near` has the shape"):
        etalon.kinematics.inverse(robot, np.eye(4), near=[0.0] * 5)


def test_a_missing_coordinate_is_named_with_its_row(arm):
    robot, table, _ = arm
    broken = dict(table, x_mm=np.where(np.arange(60) == 4, np.nan, table["x_mm"]))
    with pytest.raises(etalon.Error) as raised:
        etalon.identify(robot, broken)
    assert "x is missing in row 5" in str(raised.value), str(raised.value)


def test_a_column_that_is_not_read_is_named_before_the_failure(arm):
    """The positions fit nowhere: an unread heading may be the cause."""
    robot, table, _ = arm
    with pytest.raises(etalon.Error) as raised:
        etalon.identify(robot, table | {"x_true": table["x_mm"], "x_mm": np.asarray(table["x_mm"]) * 0.001})
    assert raised.value.id == "placement-unexplained" and raised.value.hint, str(raised.value)
    unread = [message for message in raised.value.messages if message.id == "columns-not-read"]
    assert len(unread) == 1 and "`x_true`" in unread[0].what
    # without z the positions of an arm are unknown
    renamed = {{"z_mm": "Z"}.get(name, name): column for name, column in table.items()}
    with pytest.raises(etalon.Error) as raised:
        etalon.identify(robot, renamed)
    assert raised.value.id == "column-unknown" and raised.value.hint.endswith('`columns={"z_mm": "Z"}`'), str(raised.value)


def test_residuals_of_rounding_are_no_outliers(arm):
    robot, table, _ = arm
    joints = np.column_stack([table[f"q{i}_deg"] for i in range(1, 7)])
    exact = etalon.kinematics.direct(robot, joints).xyz_mm
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        etalon.identify(robot, table | {f"{axis}_mm": exact[:, k] for k, axis in enumerate("xyz")})
    assert "largest-residuals" not in {entry.message.message.id for entry in caught}


def test_a_misnamed_joint_is_not_told_of_coordinates(arm):
    robot, table, _ = arm
    joints = {f"q{i}_deg": f"J{i}" for i in range(1, 7)}
    renamed = {joints.get(name, name): column for name, column in table.items()}
    with pytest.raises(etalon.Error) as raised:
        etalon.identify(robot, renamed)
    hints = [message.arguments["hint"] for message in raised.value.messages]
    assert [hint["id"] for hint in hints] == ["state-column"] * 6
    assert {hint["arguments"]["column"]: hint["arguments"]["heading"] for hint in hints} == joints
    assert all(f'`columns={{"{name}": "{heading}"}}`' in str(raised.value) for name, heading in joints.items())
    assert str(raised.value).endswith(f"hint: together: columns={json.dumps(joints)}")
    etalon.identify(robot, renamed, columns=joints, standard_uncertainty_um=10)
    # a coordinate by its letter
    other = {{"x_mm": "X", "y_mm": "pos Y [mm]"}.get(name, name): column for name, column in renamed.items()}
    with pytest.raises(etalon.Error) as raised:
        etalon.identify(robot, other)
    headings = {"x_mm": "X", "y_mm": "pos Y [mm]"} | joints
    assert str(raised.value).endswith(f"hint: together: columns={json.dumps(headings)}"), str(raised.value)
    etalon.identify(robot, other, columns=headings, standard_uncertainty_um=10)
    strange = {{"q1_deg": "shoulder", "q2_deg": "elbow"}.get(name, name): column for name, column in table.items()}
    with pytest.raises(etalon.Error) as raised:
        etalon.identify(robot, strange)
    assert "shoulder" in raised.value.hint and "x_mm" not in raised.value.hint


def test_a_check_warns_and_hints_of_a_campaign_are_keys(sample):
    folder = sample("prexyt-cmm")
    text = (folder / "campaign.toml").read_text(encoding="utf-8")
    (folder / "campaign.toml").write_text(text.replace("unit = ", "unti = ", 1), encoding="utf-8")
    found = etalon.check(folder)
    assert any("`unit`" in (error.hint or "") for error in found.errors)
    with pytest.raises(etalon.Error) as raised:
        etalon.run(folder)
    assert not re.search(r"\w+=\{|--[a-z]", str(raised.value)), str(raised.value)
    (folder / "campaign.toml").write_text(text, encoding="utf-8")
    with (folder / "exports/poses.txt").open("a", encoding="utf-8") as export:
        export.write("extra 1 2 3\n")
    with pytest.warns(etalon.warning_class("labels-unused")):
        checked = etalon.check(folder)
    assert "labels-unused" in [message.id for message in checked.warnings]


def test_a_convention_is_named_with_the_valid_ones():
    sweeps = {"joint": ["q1"], "target": ["a"], "x_mm": [0.0], "y_mm": [0.0], "z_mm": [0.0]}
    with pytest.raises(etalon.Error, match="`convention`: (?=.*`poe`)(?=.*`dh`)(?=.*`mdh`)"):
        etalon.axes(sweeps, convention="craig")

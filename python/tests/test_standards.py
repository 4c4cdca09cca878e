"""Tests of standards: wrong tables have their cause, frames and limits do not pass in silence, and copied rows are named."""

import ast
import re
import warnings

import numpy as np
import pytest

import etalon

#: Poses of a test in general places, mm.
PLACES = np.array([[500.0, 0, 405], [337, -200, 280], [639, -200, 160], [810, 200, 611], [280, 200, 600]])
NAMES = ["x_mm", "y_mm", "z_mm"]


def tested(change=lambda p: p, cycles=30, seed=0):
    """Attained poses, 0.1 mm off and with a scatter of 0.02 mm, as a changed table; and the commanded poses."""
    noise = np.random.default_rng(seed)
    shape = (cycles, *PLACES.shape)
    points = change(PLACES + [0.1, 0, 0] + noise.normal(0, 0.02, shape))
    attained = {"pose": np.tile(np.arange(1, 6), cycles), "cycle": np.repeat(np.arange(1, cycles + 1), 5)}
    attained |= {name: points[..., k].ravel() for k, name in enumerate(NAMES)}
    return attained, {"pose": np.arange(1, 6)} | {name: PLACES[:, k] for k, name in enumerate(NAMES)}


def quietly(function, *arguments, **keywords):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", etalon.MessageWarning)
        return function(*arguments, **keywords)


def messages(found):
    return {message.id: message for message in found.messages}


#: Columns that are exchanged, and the headings of the attained poses that put them right.
EXCHANGED = {
    "x and y": (lambda p: p[..., [1, 0, 2]], {"x_mm": "y_mm", "y_mm": "x_mm"}),
    "y and z": (lambda p: p[..., [0, 2, 1]], {"y_mm": "z_mm", "z_mm": "y_mm"}),
    "all": (lambda p: p[..., [1, 2, 0]], {"x_mm": "z_mm", "y_mm": "x_mm", "z_mm": "y_mm"}),
    "sign of x": (lambda p: p * [-1, 1, 1], {"x_mm": "-x_mm"}),
}


@pytest.mark.parametrize("name", EXCHANGED)
def test_exchanged_columns_are_the_cause_and_their_hint_leads_to_the_right_answer(name):
    change, headings = EXCHANGED[name]
    right = [pose.ap_mm for pose in quietly(etalon.iso9283, *tested()).poses]
    with pytest.warns(etalon.warning_class("coordinates-exchanged")) as caught:
        found = etalon.iso9283(*tested(change))
    said = messages(found)
    assert "poses-in-other-frame" not in said and "deviation-as-large-as-test" not in said
    assert said["coordinates-exchanged"].arguments["left_mm"] < 0.12
    hint = next(entry.message.message.hint for entry in caught if entry.message.message.id == "coordinates-exchanged")
    remedy = ast.literal_eval(re.search(r"`columns=(\{[^`]*\})`", hint)[1])
    assert remedy == {"attained": headings}
    again = quietly(etalon.iso9283, *tested(change), columns=remedy)
    assert [pose.ap_mm for pose in again.poses] == pytest.approx(right, abs=1e-9)
    assert "coordinates-exchanged" not in messages(again)


@pytest.mark.parametrize("shift", [[100.0, 0, 0], [8.0, -3, 2]])
def test_a_shift_of_the_frame_is_named(shift):
    with pytest.warns(etalon.warning_class("poses-in-other-frame")):
        found = etalon.iso9283(*tested(lambda p: p + shift))
    stated = messages(found)["poses-in-other-frame"].arguments
    assert [stated[f"{axis}_mm"] for axis in "xyz"] == pytest.approx(np.array(shift) + [0.1, 0, 0], abs=0.02)
    assert stated["turned"] == "shifted" and stated["left_mm"] < 0.05


@pytest.mark.parametrize("degrees", [2.0, 10.0])
def test_a_rotation_of_the_frame_is_named(degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    with pytest.warns(etalon.warning_class("poses-in-other-frame")):
        found = etalon.iso9283(*tested(lambda p: p @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]).T))
    assert messages(found)["poses-in-other-frame"].arguments["turn_deg"] == pytest.approx(degrees, abs=0.05)


def test_errors_of_a_robot_are_no_frame():
    # lengths that are 1 % too long, and errors of 3 mm that differ from pose to pose
    differing = np.random.default_rng(1).normal(0, 3, PLACES.shape)
    for change in (lambda p: p, lambda p: 1.01 * p, lambda p: p + differing):
        said = messages(quietly(etalon.iso9283, *tested(change)))
        assert not {"poses-in-other-frame", "coordinates-exchanged", "deviation-as-large-as-test"} & set(said)


def test_limits_without_the_instrument_are_warned_of():
    attained, commanded = tested()
    id = "limits-without-instrument"
    with pytest.warns(etalon.warning_class(id)) as caught:
        etalon.iso9283(attained, commanded, ap_limit_mm=0.4, rp_limit_mm=0.3)
    hint = next(entry.message.message.hint for entry in caught if entry.message.message.id == id)
    assert "expanded_uncertainty_um=" in hint
    for stated in ({"expanded_uncertainty_um": 5.0}, {"decision_rule": "simple-acceptance"}):
        found = quietly(etalon.iso9283, attained, commanded, ap_limit_mm=0.4, **stated)
        assert id not in messages(found) and found.limits[0].met
    assert id not in messages(quietly(etalon.iso9283, attained, commanded))


def test_a_limit_of_one_cycle_is_undecided():
    attained, commanded = tested(cycles=1)
    found = quietly(etalon.iso9283, attained, commanded, ap_limit_mm=0.05, rp_limit_mm=0.01, expanded_uncertainty_um=5.0)
    by_name = {limit.name: limit for limit in found.limits}
    assert by_name["repeatability_max_mm"].conformity == "not_assessable"
    assert {limit.acceptance for limit in found.limits} == {"undecided"} and not any(limit.met for limit in found.limits)
    # one cycle has no interval to decide by
    assert "interval" in messages(found)["few-cycles"].hint and "decision" not in messages(found)["few-cycles"].hint


def test_each_table_has_its_own_headings():
    attained, commanded = tested()
    right = [pose.ap_mm for pose in quietly(etalon.iso9283, attained, commanded).poses]
    metres = attained | {name: np.asarray(attained[name]) / 1000 for name in NAMES}
    with pytest.raises(etalon.Error) as raised:
        etalon.iso9283(metres, commanded)
    remedy = ast.literal_eval(re.search(r"`columns=(\{[^`]*\})`", raised.value.hint)[1])
    assert remedy == {"attained": {"x_m": "x_mm", "y_m": "y_mm", "z_m": "z_mm"}}
    assert [pose.ap_mm for pose in quietly(etalon.iso9283, metres, commanded, columns=remedy).poses] == pytest.approx(right, abs=1e-9)
    # headings of all tables beside those of one
    renamed = [{{"pose": "P"}.get(name, name): column for name, column in table.items()} for table in (metres, commanded)]
    found = quietly(etalon.iso9283, *renamed, columns={"pose": "P", **remedy})
    assert [pose.ap_mm for pose in found.poses] == pytest.approx(right, abs=1e-9)
    with pytest.raises(etalon.Error, match="`columns` names reference: expected tables of this call"):
        etalon.iso9283(attained, commanded, columns={"reference": {"x_mm": "X"}})


def test_each_file_has_its_own_headings(tmp_path):
    attained, commanded = tested()
    right = [pose.ap_mm for pose in quietly(etalon.iso9283, attained, commanded).poses]
    paths = []
    for name, table in (("attained", attained), ("commanded", commanded)):
        headings = {axis: f"{axis[0].upper()} {name}" for axis in NAMES}
        rows = zip(*(np.asarray(column).tolist() for column in table.values()))
        lines = [",".join(headings.get(heading, heading) for heading in table), *(",".join(map(repr, row)) for row in rows)]
        paths.append(tmp_path / f"{name}.csv")
        paths[-1].write_text("\n".join(lines) + "\n")
    own = {name: {axis: f"{axis[0].upper()} {name}" for axis in NAMES} for name in ("attained", "commanded")}
    assert [pose.ap_mm for pose in quietly(etalon.iso9283, *paths, columns=own).poses] == pytest.approx(right, abs=1e-12)


def test_rows_that_were_copied_are_named():
    attained, commanded = tested(cycles=10)
    twice = {name: np.tile(column, 2) for name, column in attained.items() if name != "cycle"}
    with pytest.warns(etalon.warning_class("readings-repeated")):
        found = etalon.iso9283(twice, commanded, cycle="visit")
    assert messages(found)["readings-repeated"].arguments["count"] == 50
    assert "readings-repeated" not in messages(quietly(etalon.iso9283, attained, commanded))
    # a row with the cycle of another one, which it repeats
    last = {name: np.append(column, column[3]) for name, column in attained.items()}
    with pytest.raises(etalon.Error) as raised:
        etalon.iso9283(last, commanded)
    assert raised.value.id == "pose-attained-twice" and "row 4" in raised.value.hint
    changed = last | {"x_mm": np.append(attained["x_mm"], 0.0)}
    with pytest.raises(etalon.Error) as raised:
        etalon.iso9283(changed, commanded)
    assert "row 4" not in raised.value.hint


def motion(order=None, shift=0.0):
    """Ten passes of a straight path at 250 mm/s, sampled at 500 Hz; a table, and the path."""
    noise = np.random.default_rng(3)
    there, back = np.arange(-200, 200, 0.5), np.linspace(200, -200, 400)
    y = np.concatenate([np.concatenate([np.full(250, -200.0), there, np.full(250, 200.0), back])] * 10)
    x = np.concatenate([np.concatenate([np.full(len(y) // 10 - 400, 300.0), np.full(400, 360.0)])] * 10)
    points = np.column_stack([x + shift, y, np.full(len(y), 300.0)]) + noise.normal(0, 0.002, (len(y), 3))
    order = np.arange(len(y)) if order is None else order
    table = {"time_s": np.arange(len(y))[order] / 500} | {name: points[order, k] for k, name in enumerate(NAMES)}
    return table, {"x_mm": [300.0, 300.0], "y_mm": [-200.0, 200.0], "z_mm": [300.0, 300.0]}


def test_rows_in_another_order_are_no_coarse_stamps():
    recording, path = motion()
    right = quietly(etalon.iso9283_path, recording, path=path, velocity_mm_s=250).path
    assert right.velocity.mean_mm_s == pytest.approx(250, rel=1e-3)
    count = len(recording["time_s"])
    exchanged = np.r_[0:300, 900:1000, 400:900, 300:400, 1000:count]
    for rate in (None, 500.0):
        with pytest.raises(etalon.Error) as raised:
            etalon.iso9283_path(motion(exchanged)[0], path=path, velocity_mm_s=250, rate_hz=rate)
        assert raised.value.id == "time-not-increasing" and "sort" in raised.value.hint and "rate_hz" not in raised.value.hint
    with pytest.raises(etalon.Error) as raised:
        etalon.iso9283_path(motion(np.r_[0:500, 499, 500:count])[0], path=path)
    assert raised.value.id == "time-not-increasing" and "repeated" in raised.value.hint and "rate_hz" not in raised.value.hint
    # stamps of 10 ms at 500 Hz
    coarse = recording | {"time_s": np.floor(recording["time_s"] * 100) / 100}
    with pytest.raises(etalon.Error) as raised:
        etalon.iso9283_path(coarse, path=path, velocity_mm_s=250)
    assert "`rate_hz=`" in raised.value.hint or "rate_hz=" in raised.value.hint
    found = quietly(etalon.iso9283_path, coarse, path=path, velocity_mm_s=250, rate_hz=500.0).path
    assert found.at_mm == pytest.approx(right.at_mm, abs=1e-9)


def test_a_shifted_path_is_named():
    recording, path = motion(shift=8.0)
    with pytest.warns(etalon.warning_class("poses-in-other-frame")):
        found = etalon.iso9283_path(recording, path=path)
    assert found.path.at_mm == pytest.approx(8.0, abs=0.01)
    assert messages(found)["poses-in-other-frame"].arguments["x_mm"] == pytest.approx(8.0, abs=0.01)
    assert "poses-in-other-frame" not in messages(quietly(etalon.iso9283_path, motion()[0], path=path))


@pytest.mark.parametrize("factor", [1, 1000])
def test_velocities_and_times_in_another_unit_are_named(factor):
    recording, path = motion()
    stated = recording | {"time_s": np.asarray(recording["time_s"]) * factor}
    with pytest.warns(etalon.warning_class("path-velocity-far")) as caught:
        etalon.iso9283_path(stated, path=path, velocity_mm_s=250 if factor > 1 else 0.25, still_s=0.2 * factor)
    assert "velocity_mm_s=" in next(entry.message.message.hint for entry in caught if entry.message.message.id == "path-velocity-far")


def axis(change=lambda rows: rows, runs=5):
    """Runs of an axis to five positions with a scatter of 1 µm."""
    noise = np.random.default_rng(4)
    rows = [(at, at + noise.normal(0, 0.001), side) for _ in range(runs) for side in (1, -1) for at in (0.0, 100.0, 200.0, 300.0, 400.0)]
    return dict(zip(("position_mm", "measured_mm", "direction"), map(list, zip(*change(rows)))))


def test_a_run_far_from_the_others_is_named():
    assert not quietly(etalon.iso230, axis()).messages

    def wrong(rows):
        at, measured, side = rows[17]
        return [*rows[:17], (at, measured + 0.2, side), *rows[18:]]

    with pytest.warns(etalon.warning_class("runs-outlying")):
        found = etalon.iso230(axis(wrong))
    assert messages(found)["runs-outlying"].arguments["count"] == 1


def test_copied_runs_and_short_tests_of_an_axis_are_named():
    with pytest.warns(etalon.warning_class("runs-repeated")):
        found = etalon.iso230(axis(lambda rows: rows * 2))
    assert messages(found)["runs-repeated"].arguments["times"] == 2
    with pytest.warns(etalon.warning_class("axis-test-short")):
        etalon.iso230(axis(runs=2))


def test_exchanged_columns_of_an_axis_are_the_cause():
    table = axis()
    swapped = table | {"position_mm": table["measured_mm"], "measured_mm": table["position_mm"]}
    with pytest.raises(etalon.Error) as raised:
        etalon.iso230(swapped)
    assert raised.value.id == "iso230-columns-exchanged"
    remedy = {}
    for text in re.findall(r"`columns=(\{[^`]*\})`", raised.value.hint):
        remedy |= ast.literal_eval(text)
    assert quietly(etalon.iso230, swapped, columns=remedy).axis == quietly(etalon.iso230, table).axis
    # the column of an incomplete row
    with pytest.raises(etalon.Error, match="`direction` is neither"):
        etalon.iso230(table | {"direction": [0, *table["direction"][1:]]})

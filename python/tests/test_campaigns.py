"""Campaigns in folders, and the program in the wheel."""

import copy
import pickle
import subprocess
import sys
from pathlib import Path

import pytest

import etalon


def test_a_campaign_is_checked_and_run(sample):
    folder = sample("prexyt-cmm")
    assert etalon.check(folder).errors == []
    done = []
    found = etalon.run(folder, reports=False)
    assert found.met and found.parameters.parameters and found.accuracy.schema
    assert "<table>" in found._repr_html_()
    with pytest.raises(AttributeError):
        found.iso9283
    judged = etalon.validate(folder, found.parameters)
    assert isinstance(judged, etalon.documents.AccuracyDocument)
    assert set(judged.provenance.inputs) >= {"parameters"}
    with pytest.raises(etalon.Error, match="`field` needs `parameters`"):
        etalon.validate(folder, field=folder / "out/field.json")
    etalon.recommend(folder, progress=lambda some, whole: done.append((some, whole)))
    assert done and all(some <= whole for some, whole in done)


def test_residuals_of_a_run_are_those_of_its_file_and_of_identify(sample, arm):
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("pyarrow")
    run = etalon.run(sample("prexyt-cmm"), reports=False)
    found = run.residuals_table().to_pandas()
    written = pandas.read_parquet(run.folder / "residuals.parquet")
    assert list(found.columns) == list(written.columns) and len(found) == len(written)
    for name in written.columns:
        assert found[name].isna().tolist() == written[name].isna().tolist(), name
        assert found[name].dropna().tolist() == written[name].dropna().tolist(), name
    # the summary of accuracy.json is the root mean square of the rows
    rows = found[found["set"] == "calibration"]
    summary = next(s for s in run.accuracy.sets if s.name == "calibration").errors[0]
    assert summary.quantity == "position"
    for part, prefix in ((summary.before, "before"), (summary.after, "after")):
        squares = sum(rows[f"{prefix}_{axis}_mm"] ** 2 for axis in "xyz")
        assert squares.mean() ** 0.5 == pytest.approx(part.rms, rel=1e-9)
    robot, table, _ = arm
    of_identify = etalon.identify(robot, table, standard_uncertainty_um=10).residuals_table().to_dict()
    joints = {*robot.joints, "rho1_mm", "rho2_mm", "rho3_mm"}
    assert [n for n in of_identify if n not in joints] == [n for n in found.columns if n not in joints]
    assert of_identify["q2_deg"] == pytest.approx(list(table["q2_deg"]), abs=1e-12)
    # a campaign without identification has none
    (run.folder / "manifest.json").write_text("{}")
    with pytest.raises(etalon.Error):
        run.residuals_table()


def test_a_run_is_copied_and_pickled(sample, monkeypatch, tmp_path):
    monkeypatch.chdir(sample("prexyt-cmm"))
    run = etalon.run(".", reports=False)
    monkeypatch.chdir(tmp_path)
    for other in (copy.copy(run), copy.deepcopy(run), pickle.loads(pickle.dumps(run))):
        assert other.met and other.parameters == run.parameters and [m.id for m in other.messages] == [m.id for m in run.messages]


def test_what_is_wrong_with_a_campaign_is_raised(sample):
    folder = sample("prexyt-cmm")
    (folder / "encoders.csv").unlink()
    assert any("encoders.csv" in error.what for error in etalon.check(folder).errors)
    with pytest.raises(etalon.Error, match="encoders.csv"):
        etalon.run(folder)
    assert not (folder / "out").exists()


def test_many_campaigns_run_in_one_call(sample):
    """Other threads call `progress`: with the GIL held, the call would never end."""
    folders = [sample("prexyt-cmm"), sample("dextar")]
    done = []
    found = etalon.batch(folders, progress=lambda some, whole: done.append((some, whole)))
    assert (found.failed, len(found.campaigns)) == (0, 2) and sorted(done) == [(1, 2), (2, 2)]
    # a path is a folder, not a list of letters
    assert len(etalon.batch(folders[0]).campaigns) == len(etalon.batch(str(folders[0])).campaigns) == 1


def test_the_wheel_has_the_program(tmp_path):
    script = Path(sys.executable).parent / "etalon"
    for command in ([sys.executable, "-m", "etalon"], [script] if script.exists() else []):
        if command:
            shown = subprocess.run([*command, "--version"], capture_output=True, text=True, cwd=tmp_path)
            assert shown.stdout == f"etalon {etalon.__version__}\n" and shown.returncode == 0
            refused = subprocess.run([*command, "check", "nowhere"], capture_output=True, text=True, cwd=tmp_path)
            assert refused.returncode == 2 and "nowhere" in refused.stderr

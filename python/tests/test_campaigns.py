"""Campaigns in folders, and the program in the wheel."""

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
    etalon.recommend(folder, progress=lambda some, whole: done.append((some, whole)))
    assert done and all(some <= whole for some, whole in done)


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


def test_the_wheel_has_the_program(tmp_path):
    script = Path(sys.executable).parent / "etalon"
    for command in ([sys.executable, "-m", "etalon"], [script] if script.exists() else []):
        if command:
            shown = subprocess.run([*command, "--version"], capture_output=True, text=True, cwd=tmp_path)
            assert shown.stdout == f"etalon {etalon.__version__}\n" and shown.returncode == 0
            refused = subprocess.run([*command, "check", "nowhere"], capture_output=True, text=True, cwd=tmp_path)
            assert refused.returncode == 2 and "nowhere" in refused.stderr

"""Campaigns and robots of the samples, and those that `init` writes, are what the schemas allow: by jsonschema and by taplo."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT

tomllib = pytest.importorskip("tomllib")
NAMES = ["campaign.toml", "robot.toml"]


def files(name):
    return sorted((ROOT / "samples").glob(f"*/{name}"))


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """Folders that `init` writes."""
    folder = tmp_path_factory.mktemp("init")
    for options in (["synthetic", "--synthetic"], ["arm", "--robot", "ur5e"], ["hexapod", "--robot", "hexapod"]):
        subprocess.run([sys.executable, "-m", "etalon", "init", *options], cwd=folder, check=True, capture_output=True)
    return folder


@pytest.mark.parametrize("name", NAMES)
def test_samples_validate(name, made):
    jsonschema = pytest.importorskip("jsonschema")
    validator = jsonschema.Draft202012Validator(json.loads((ROOT / "schemas" / f"{name}.schema.json").read_text()))
    stated = [*files(name), *sorted(made.glob(f"*/{name}"))]
    assert len(stated) > 20
    for path in stated:
        errors = [error.message for error in validator.iter_errors(tomllib.loads(path.read_text(encoding="utf-8")))]
        assert not errors, f"{path}: {errors}"
    assert list(validator.iter_errors({"nonsense": 1}))


@pytest.mark.parametrize("name", NAMES)
def test_taplo_accepts_samples_and_what_init_writes(name, made, tmp_path):
    taplo = shutil.which("taplo", path=Path(sys.executable).parent)
    if taplo is None:
        pytest.skip("taplo is not installed")

    def lint(path, *schema):
        return subprocess.run([taplo, "lint", *schema, path], capture_output=True, text=True)

    schema = ("--schema", (ROOT / "schemas" / f"{name}.schema.json").as_uri())
    for path in files(name):
        assert lint(path, *schema).returncode == 0, lint(path, *schema).stderr
    for path in sorted(made.glob(f"*/{name}")):
        # by the line that `init` writes
        assert lint(path).returncode == 0, lint(path).stderr
    wrong = next(made.glob(f"arm/{name}"))
    wrong.write_text("nonsense = 1\n".join(wrong.read_text().split("\n", 1)[:1] + ["\n"]) + wrong.read_text().split("\n", 1)[1])
    refused = lint(wrong)
    assert refused.returncode != 0, "an unknown key is accepted"

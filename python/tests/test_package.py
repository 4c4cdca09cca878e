"""Examples run, stubs are those of the schemas, and everything public says what it does."""

import inspect
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import etalon

FOLDER = Path(__file__).resolve().parents[1]
EXAMPLES = sorted((FOLDER / "examples").glob("*.py"))


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_runs(example, tmp_path):
    shutil.copytree(FOLDER / "examples", tmp_path / "examples")
    ran = subprocess.run([sys.executable, example.name], cwd=tmp_path / "examples", capture_output=True, text=True)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert ran.stdout.strip()


def test_the_stub_is_that_of_the_schemas():
    sys.path.insert(0, str(FOLDER))
    try:
        import generate_stubs
    finally:
        sys.path.pop(0)
    stub = (FOLDER / "etalon/documents.pyi").read_text(encoding="utf-8")
    assert stub == generate_stubs.main(), "run python/generate_stubs.py"


def test_everything_public_has_a_docstring():
    modules = [etalon, etalon.fit, etalon.frames, etalon.kinematics]
    for module in modules:
        for name, item in vars(module).items():
            if not name.startswith("_") and (inspect.isfunction(item) or inspect.isclass(item)):
                assert inspect.getdoc(item), f"{module.__name__}.{name}"


def test_dask_takes_the_same_call(sample):
    distributed = pytest.importorskip("distributed")
    folder = str(sample("prexyt-cmm"))
    with distributed.Client(n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None) as client:
        assert client.submit(etalon.run, folder, reports=False).result().met

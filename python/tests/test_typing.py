"""What type checkers say of calls; the examples are free of remarks."""

import importlib.util
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import etalon

FOLDER = Path(__file__).resolve().parents[1]
EXAMPLES = sorted((FOLDER / "examples").glob("[0-9]*.py"))

RIGHT = """
import etalon
import numpy as np

points = np.zeros((10, 3))
shaft = etalon.fit.cylinder(points)
half: float = shaft.radius_mm / 2
u: float = 2 * shaft.standard_uncertainty.radius_mm
axis = shaft.axis / 10
run = etalon.run("folder")
name: str = run.parameters.parameters[0].name
found = etalon.identify("ur5", {"x_mm": [1.0]}, prior="none", effects=["zeros", "bending"])
value: float = found.parameters[0].value
poses = etalon.kinematics.direct("ur5", [0.0] * 6)
joints = etalon.kinematics.inverse("ur5", poses.matrix).joints
tested = etalon.iso9283("a.csv", "c.csv", columns={"x_mm": "X"})
tested = etalon.iso9283("a.csv", "c.csv", columns={"attained": {"x_m": "X"}, "commanded": {"x_mm": 3}})
expanded: float = etalon.fit.sphere(points, standard_uncertainty_um=1.5).expanded_uncertainty.radius_mm
drawn: int = etalon.uncertainty("folder", draws=100).draws
"""
#: Mistakes that a checker has to find, one a line.
WRONG = [
    "etalon.fit.cylinder(points, radius=3)",
    "etalon.fit.plane(points, radius_mm=3)",
    'etalon.identify("ur5", {}, prior="no")',
    'etalon.identify("ur5", {}, effects=["nonsense"])',
    'etalon.axes({}, convention="craig")',
    'etalon.cell({}, "nonsense")',
    "etalon.fit.sphere(points).normal",
    'etalon.run("folder").parameters.nonsense',
    "etalon.run(5)",
    'etalon.fit.sphere(points, standard_uncertainty_um="1")',
    'etalon.iso9283("a.csv", columns={"attained": ["x_m"]})',
]


def checked(tool, path):
    """Lines of a file with remarks, by a type checker."""
    if importlib.util.find_spec(tool) is None:
        pytest.skip(f"{tool} is not installed")
    command = {
        "mypy": [sys.executable, "-m", "mypy", "--strict", "--no-error-summary", "--hide-error-context", "--no-incremental", "--disable-error-code", "import-untyped", str(path)],
        "pyright": [sys.executable, "-m", "pyright", "--pythonpath", sys.executable, str(path)],
    }[tool]
    said = subprocess.run(command, capture_output=True, text=True, cwd=path.parent)
    if tool == "pyright" and "error" not in said.stdout and said.returncode > 1:
        pytest.skip(f"pyright does not run here: {said.stdout}{said.stderr}")
    lines = [line for line in said.stdout.splitlines() if f"{path.name}:" in line and "error" in line]
    return sorted({int(line.split(f"{path.name}:")[1].split(":")[0]) for line in lines}), said.stdout


@pytest.mark.parametrize("tool", ["mypy", "pyright"])
def test_right_calls_are_accepted_and_each_wrong_one_is_found(tool, tmp_path):
    path = tmp_path / "calls.py"
    path.write_text(RIGHT + "\n".join(WRONG) + "\n")
    first = RIGHT.count("\n") + 1
    found, said = checked(tool, path)
    assert found == list(range(first, first + len(WRONG))), said


@pytest.mark.parametrize("tool", ["mypy", "pyright"])
@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_examples_are_free_of_remarks(tool, example, tmp_path):
    copy = tmp_path / f"example_{example.name}"
    copy.write_text(example.read_text(encoding="utf-8"), encoding="utf-8")
    found, said = checked(tool, copy)
    assert not found, said


@pytest.mark.parametrize("tool", ["mypy", "pyright"])
def test_the_package_is_free_of_remarks(tool, tmp_path):
    shutil.copytree(FOLDER / "etalon", tmp_path / "etalon", ignore=shutil.ignore_patterns("__pycache__", "*.so", "*.pyd"))
    if importlib.util.find_spec(tool) is None:
        pytest.skip(f"{tool} is not installed")
    command = {"mypy": ["--strict", "--no-incremental", "etalon"], "pyright": ["--pythonpath", sys.executable, "etalon"]}[tool]
    said = subprocess.run([sys.executable, "-m", tool, *command], capture_output=True, text=True, cwd=tmp_path)
    if tool == "pyright" and "error" not in said.stdout and said.returncode > 1:
        pytest.skip(f"pyright does not run here: {said.stdout}{said.stderr}")
    assert said.returncode == 0, said.stdout


def test_the_stub_has_no_open_attributes():
    stub = (FOLDER / "etalon/documents.pyi").read_text(encoding="utf-8")
    assert "__getattr__" not in stub
    assert not any(name in vars(etalon.documents.Record) for name in ("keys", "values", "items"))

"""Python of the pages: type checkers have no remark, and the lines run."""

import os
import re
import warnings

import numpy as np
import pytest
from conftest import ROOT
from test_typing import checked

import etalon

#: Names that the reader of a page has, as a type checker sees them.
NAMES = """from pathlib import Path
from typing import Any
import numpy as np
from numpy.typing import NDArray
import etalon
points: NDArray[np.float64] = np.zeros((10, 3))
joints: NDArray[np.float64] = np.zeros((10, 6))
points_table: Any = None
table: Any = None
recorded: Any = None
candidates: Any = None
folders: list[str] = []
path = Path("bag")
"""
#: Sections that other tests run, and those of other languages.
ELSEWHERE = ["## ROS", "## MATLAB"]


def blocks(page):
    """Blocks of Python of a page, each with the heading above it."""
    heading, found = "", []
    text = (ROOT / page).read_text(encoding="utf-8")
    for part in re.finditer(r"^(#+ [^\n]*)$|^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        heading = part[1] or heading
        if part[2] and "{{#include" not in part[2]:
            found.append((heading, part[2]))
    return found


def pages():
    texts = [path for path in (ROOT / "docs").rglob("*.md")] + [ROOT / "README.md", ROOT / "python/README.md"]
    return sorted(str(path.relative_to(ROOT)) for path in texts if "```python" in path.read_text(encoding="utf-8"))


PAGES = [page for page in pages() if blocks(page)]


def test_pages_with_python_are_found():
    assert {"docs/python.md", "docs/how-to/python.md", "README.md", "python/README.md"} <= set(PAGES)
    # other blocks of code that begin with a statement of Python would not be checked
    text = re.sub(r"^```.*?^```", "", (ROOT / "docs/python.md").read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
    assert not re.findall(r"^ {4}(?:import|from|for|with|\w+ = etalon)\b.*", text, re.MULTILINE)


@pytest.mark.parametrize("tool", ["mypy", "pyright"])
@pytest.mark.parametrize("page", PAGES)
def test_pages_are_free_of_remarks(tool, page, tmp_path):
    path = tmp_path / "page.py"
    # the section of ROS begins anew
    section = lambda heading: heading if heading in ELSEWHERE else ""
    for part in dict.fromkeys(section(heading) for heading, _ in blocks(page)):
        lines = "".join(code for heading, code in blocks(page) if section(heading) == part)
        path.write_text(NAMES + lines, encoding="utf-8")
        found, said = checked(tool, path)
        assert not found, said


def test_the_page_of_the_module_runs(arm, sample, tmp_path, monkeypatch):
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("matplotlib").use("Agg")
    robot, table, _ = arm
    (tmp_path / "out").mkdir()
    monkeypatch.chdir(tmp_path)
    noise = np.random.default_rng(7)
    ball = noise.normal(size=(20, 3))
    ball *= 12.7 / np.linalg.norm(ball, axis=1, keepdims=True)
    turn = noise.uniform(0, 2 * np.pi, 40)
    joints = np.column_stack([table[f"q{i}_deg"] for i in range(1, 7)])
    names = {
        "points": np.column_stack([20 * np.cos(turn), 20 * np.sin(turn), noise.uniform(0, 50, 40)]),
        "points_table": pandas.DataFrame(np.vstack([ball, ball + [100, 0, 0]]), columns=["x", "y", "z"]).assign(ball=["A"] * 20 + ["B"] * 20),
        "table": table,
        "joints": joints,
        "candidates": table,
        "recorded": pandas.DataFrame(
            {f"q{i}_deg": joints[:, i - 1] for i in range(3, 7)}
            | {"j1": np.radians(joints[:, 0]), "j2": np.radians(joints[:, 1])}
            | {axis.upper(): np.asarray(table[f"{axis}_mm"]) / 1000 for axis in "xyz"}
        ),
        "folders": [str(sample("prexyt-cmm"))],
    }
    (tmp_path / "out/parameters.json").write_text(etalon.identify(robot, table, standard_uncertainty_um=10).to_json())
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", etalon.MessageWarning)
        for heading, code in blocks("docs/python.md"):
            if heading not in ELSEWHERE:
                exec(compile(code, heading, "exec"), names)
    assert (tmp_path / "cell").is_dir() and names["runs"][0].met and os.getcwd() == str(tmp_path)
    assert [round(ball.radius_mm, 6) for ball in names["balls"]] == [12.7, 12.7]
    assert names["solved"].joints == pytest.approx(joints, abs=1e-6)
    assert names["found"].residuals.position_rms_mm < 0.1

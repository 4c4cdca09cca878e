"""Examples run, stubs are those of the schemas, and everything public says what it does."""

import inspect
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import etalon

FOLDER = Path(__file__).resolve().parents[1]
EXAMPLES = sorted((FOLDER / "examples").glob("[0-9]*.py"))


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_runs(example, tmp_path):
    shutil.copytree(FOLDER / "examples", tmp_path / "examples")
    ran = subprocess.run([sys.executable, example.name], cwd=tmp_path / "examples", capture_output=True, text=True)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    # what the page shows below the script is printed, in this order
    page = (FOLDER.parent / "docs/notebooks.md").read_text(encoding="utf-8")
    shown = re.search(r"/" + re.escape(example.name) + r"\}\}\n```\n\n```text\n(.*?)```", page, re.DOTALL)
    assert shown and shown[1].strip(), f"{example.name} has no output in docs/notebooks.md"
    lines = iter(ran.stdout.splitlines())
    assert all(line in lines for line in shown[1].splitlines()), ran.stdout


def test_notebooks_are_those_of_the_scripts(tmp_path):
    sys.path.insert(0, str(FOLDER / "examples"))
    try:
        import make_notebooks
    finally:
        sys.path.pop(0)
    made = make_notebooks.notebooks()
    assert len(made) == len(EXAMPLES)
    for path, text in made.items():
        assert path.read_text(encoding="utf-8") == text, "run python/examples/make_notebooks.py"


@pytest.mark.parametrize("name", [path.stem for path in EXAMPLES])
def test_a_notebook_runs_in_jupyter(name, tmp_path):
    nbclient = pytest.importorskip("nbclient")
    nbformat = pytest.importorskip("nbformat")
    pytest.importorskip("ipykernel")
    shutil.copytree(FOLDER / "examples", tmp_path / "examples")
    book = nbformat.read(tmp_path / f"examples/{name}.ipynb", as_version=4)
    nbformat.validate(book)
    nbclient.NotebookClient(book, resources={"metadata": {"path": tmp_path / "examples"}}, kernel_name="python3").execute()
    printed = "".join(output.get("text", "") for cell in book.cells for output in cell.get("outputs", []))
    assert printed.strip() and ("(k = 2)" in printed or not name.startswith("01"))


def test_the_stub_is_that_of_the_schemas():
    sys.path.insert(0, str(FOLDER))
    try:
        import generate_stubs
    finally:
        sys.path.pop(0)
    stub = (FOLDER / "etalon/documents.pyi").read_text(encoding="utf-8")
    assert stub == generate_stubs.main(), "run python/generate_stubs.py"
    members = (FOLDER / "etalon/_members.py").read_text(encoding="utf-8")
    assert members == generate_stubs.members(), "run python/generate_stubs.py"


def test_everything_public_has_a_docstring():
    modules = [etalon, etalon.fit, etalon.frames, etalon.kinematics]
    for module in modules:
        for name, item in vars(module).items():
            own = getattr(item, "__module__", "").startswith("etalon")
            if own and not name.startswith("_") and (inspect.isfunction(item) or inspect.isclass(item)):
                assert inspect.getdoc(item), f"{module.__name__}.{name}"


def test_dask_takes_the_same_call(sample):
    distributed = pytest.importorskip("distributed")
    folder = str(sample("prexyt-cmm"))
    with distributed.Client(n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None) as client:
        assert client.submit(etalon.run, folder, reports=False).result().met


def test_every_document_has_its_class():
    schemas = [json.loads(path.read_text(encoding="utf-8")) for path in (FOLDER.parent / "schemas").glob("*.schema.json")]
    versioned = {schema["title"] for schema in schemas if "schema" in schema.get("properties", {})}
    assert "SelftestDocument" in versioned
    assert set(etalon.documents._CLASSES.values()) == versioned


#: Options that tables in memory do not need, or that write files.
OF_FILES = {
    "--robot --observations --candidates --parameters --json --report --language --logo --templates --toml --help",
    "--like --delimiter --widths --decimal --thousands --encoding --sheet --header --no-header --missing --comment --end --only --without --constant --coverage-factor",
    "--controller --name --number --with --tool-length-mm --force",
    # the plan of a verification, and of an ISO test, by `command`
    "--positions --candidates --plan --stream --compliance",
    # a controller file whose joint zeros are loaded: by `command`
    "--mastered",
}
OF_PLAN = "--poses --targets --generate --program --truth --workspace --grouped --column --target --pose"


@pytest.mark.parametrize("function", [etalon.identify, etalon.axes, etalon.cell, etalon.verify, etalon.plan], ids=lambda f: f.__name__)
def test_every_option_is_a_keyword(function):
    help_text = etalon.command(function.__name__, help=True).text
    options = set(re.findall(r"^ +(?:-\w, )?(--[a-z0-9-]+)", help_text, re.MULTILINE))
    assert "--standard-uncertainty-um" in options
    keywords = {"--" + name.replace("_", "-") for name in inspect.signature(function).parameters} | {"--column"}
    of_files = {option for text in OF_FILES for option in text.split()}
    if function is etalon.plan:
        # generated candidates come with files: by `command`
        of_files |= set(OF_PLAN.split())
        generation = help_text[help_text.index("--generate") :] if "--generate" in help_text else ""
        of_files |= set(re.findall(r"^ +(--[a-z0-9-]+)", generation, re.MULTILINE))
    if function in (etalon.axes, etalon.cell):
        of_files |= {"--target", "--pose"}
    assert options - keywords - of_files == set()

"""Write docs/functions.md, the functions of the module with their arguments, from the docstrings; with `-` print the page."""

from __future__ import annotations

import ast
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PAGE = HERE.parent / "docs/functions.md"
#: Sections of the page: title, file, and the prefix of its functions.
SECTIONS = [
    ("Robots", "_robot.py", "etalon."),
    ("Kinematics", "kinematics.py", "etalon.kinematics."),
    ("Identification, planning, standards", "_tasks.py", "etalon."),
    ("Campaigns", "_campaigns.py", "etalon."),
    ("Elements", "fit.py", "etalon.fit."),
    ("Frames", "frames.py", "etalon.frames."),
    ("Commands", "_commands.py", "etalon."),
]
#: Functions of these files that other modules of the package use.
INTERNAL = {"robot_of", "points_of", "json_of"}
HEAD = """# Functions of the Python module

Generated from the docstrings: `help(etalon.identify)` prints the same. [Python](python.md) shows how to use the functions.
"""


def markdown(text: str) -> str:
    """Return a text of a docstring in Markdown, in one line; items of a list are sentences."""
    text = re.sub(r"^ *- ", "", text, flags=re.MULTILINE)
    text = re.sub(r":\w+:`~?([^`]+)`", r"`\1`", " ".join(text.split()))
    return re.sub(r"\bum\b(?!`)", "µm", text.replace("``", "`"))


def parts(docstring: str) -> dict[str, str]:
    """Return the parts of a docstring by their title; the text before the first title is the summary."""
    titles = ["Summary", *re.findall(r"^(Args|Returns|Raises|Warns):$", docstring, re.MULTILINE)]
    texts = re.split(r"^(?:Args|Returns|Raises|Warns):$", docstring, flags=re.MULTILINE)
    return dict(zip(titles, texts))


def arguments(text: str) -> dict[str, str]:
    """Return the meaning of each argument."""
    items = re.split(r"^ {4}(\*{0,2}\w+): ", text, flags=re.MULTILINE)[1:]
    return {name: markdown(meaning) for name, meaning in zip(items[::2], items[1::2])}


def defaults(function: ast.FunctionDef) -> dict[str, str]:
    """Return the default of each argument in Markdown."""
    given = function.args
    positional = [*given.posonlyargs, *given.args]
    stated = [None] * (len(positional) - len(given.defaults)) + list(given.defaults)
    pairs = [*zip(positional, stated), *zip(given.kwonlyargs, given.kw_defaults)]
    pairs = [(argument.arg, value) for argument, value in pairs if argument.arg not in ("self", "cls")]
    return {name: "required" if value is None else f"`{ast.unparse(value)}`" for name, value in pairs}


def entry(name: str, docstring: str, given: dict[str, str], shared: dict[str, str]) -> list[str]:
    """Return the lines of a function."""
    found = parts(docstring)
    meanings = {**shared, **arguments(found.get("Args", ""))}
    lines = [f"### {name}", ""]
    lines += [line for text in found["Summary"].strip().split("\n\n") for line in (markdown(text), "")]
    rows = [(argument, default) for argument, default in given.items() if argument in meanings]
    rows += [(argument, "") for argument in meanings if argument not in given and argument in arguments(found.get("Args", ""))]
    if rows:
        lines += ["| argument | default | meaning |", "| --- | --- | --- |"]
        lines += [f"| `{argument}` | {default} | {meanings[argument]} |".replace("||", "\\|\\|") for argument, default in rows]
        lines.append("")
    others = [f"`{argument}` ({default})" for argument, default in given.items() if argument not in meanings]
    if others:
        lines += [f"{'Other arguments' if rows else 'Arguments'}: {', '.join(others)}.", ""]
    for title in ("Returns", "Raises", "Warns"):
        if title in found:
            lines += [f"{title}: {markdown(found[title])}", ""]
    return lines


def functions(file: str, prefix: str) -> list[str]:
    """Return the lines of the public classes with arguments, and of the public functions, of a file."""
    tree = ast.parse((HERE / "etalon" / file).read_text(encoding="utf-8"))
    public = [n for n in tree.body if isinstance(n, ast.FunctionDef) and not n.name.startswith("_") and n.name not in INTERNAL]
    classes = [n for n in tree.body if isinstance(n, ast.ClassDef) and "Args:" in (ast.get_docstring(n) or "")]
    lines = []
    for node in classes:
        create = next(n for n in node.body if isinstance(n, ast.FunctionDef) and n.name == "__init__")
        lines += entry(prefix + node.name, ast.get_docstring(node) or "", defaults(create), {})
        for method in (n for n in node.body if isinstance(n, ast.FunctionDef) and n.name.startswith(("from_", "with_"))):
            lines += entry(f"{prefix}{node.name}.{method.name}", ast.get_docstring(method) or "", defaults(method), {})
    # a function that is decorated takes the meanings of the arguments of `element`
    whole = next((n for n in public if n.name == "element"), None)
    shared = arguments(parts(ast.get_docstring(whole) or "").get("Args", "")) if whole else {}
    for node in public:
        own = shared if any(ast.unparse(d) == "_documented" for d in node.decorator_list) else {}
        lines += entry(prefix + node.name, ast.get_docstring(node) or "", defaults(node), own)
    return lines


def main() -> str:
    """Return the page."""
    lines = HEAD.splitlines() + [""]
    for title, file, prefix in SECTIONS:
        lines += [f"## {title}", "", *functions(file, prefix)]
    return "\n".join(lines).rstrip() + "\n"


if __name__ == "__main__":
    if sys.argv[1:] == ["-"]:
        sys.stdout.buffer.write(main().encode())
    else:
        PAGE.write_text(main(), encoding="utf-8")

"""Write the notebooks of this folder from its scripts: `# %%` begins a cell, text after it is a heading."""

from __future__ import annotations

import ast
import json
from pathlib import Path

HERE = Path(__file__).resolve().parent


def notebook(script: str) -> str:
    """Return the notebook of a script as JSON (nbformat 4.5)."""
    head, *parts = script.split("\n# %%")
    texts = [("markdown", "# " + (ast.get_docstring(ast.parse(head)) or ""))]
    for part in parts:
        title, _, code = part.partition("\n")
        if title.strip():
            texts.append(("markdown", title.strip()[:1].upper() + title.strip()[1:]))
        texts.append(("code", code.strip("\n")))
    cells = []
    for number, (kind, text) in enumerate(texts):
        cell = {"cell_type": kind, "id": f"cell-{number}", "metadata": {}, "source": text.splitlines(keepends=True)}
        cells.append(cell | ({"execution_count": None, "outputs": []} if kind == "code" else {}))
    kernel = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}}
    book = {"cells": cells, "metadata": kernel, "nbformat": 4, "nbformat_minor": 5}
    return json.dumps(book, indent=1, ensure_ascii=False) + "\n"


def notebooks() -> dict[Path, str]:
    """Return the text of each notebook by its path."""
    scripts = sorted(HERE.glob("[0-9]*.py"))
    return {path.with_suffix(".ipynb"): notebook(path.read_text(encoding="utf-8")) for path in scripts}


if __name__ == "__main__":
    for path, text in notebooks().items():
        path.write_text(text, encoding="utf-8")

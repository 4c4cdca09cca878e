"""Tables of callers as the text that etalon reads."""

from __future__ import annotations

import csv
import io
import os
from typing import Any

import numpy as np

from . import _etalon
from ._errors import Error


def named(table: Any, name: str) -> tuple[str, str]:
    """Return the name of a table for messages, which is that of its file if it has one, and its CSV text."""
    is_file = isinstance(table, (str, os.PathLike))
    return (os.fspath(table) if is_file else name, text_of(table))


def text_of(table: Any) -> str:
    """Return a table as CSV text; numbers keep every digit."""
    if isinstance(table, (str, os.PathLike)):
        with open(table, encoding="utf-8-sig") as file:
            return file.read()
    if hasattr(table, "__arrow_c_stream__"):
        try:
            return _etalon.csv(table)
        except ImportError as missing:
            raise Error(f"{type(table).__module__.split('.')[0]} needs another package for its Arrow interface: {missing}") from missing
    if isinstance(table, dict):
        return _of_columns({str(name): np.asarray(column) for name, column in table.items()})
    if isinstance(table, np.ndarray) and table.dtype.names:
        return _of_columns({name: table[name] for name in table.dtype.names})
    raise Error(
        f"a {type(table).__name__} is not a table: give a path, a dictionary of columns, "
        "or an object with __arrow_c_stream__ (polars, pandas, pyarrow, DuckDB)"
    )


def _of_columns(columns: dict[str, np.ndarray]) -> str:
    lengths = {name: len(column) if column.ndim == 1 else -1 for name, column in columns.items()}
    if len(set(lengths.values())) > 1 or -1 in lengths.values():
        raise Error(f"columns of a table have one dimension and one length: {lengths}")
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(zip(*(column.tolist() for column in columns.values())))
    return text.getvalue()

"""Tables of callers as the text that etalon reads."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from . import _etalon
from ._errors import Error

#: What a task takes as a table: a path, columns by name, a structured array, or a DataFrame.
Table = Any


def named(table: Any, name: str) -> tuple[str, str | None]:
    """Return the path of a file, or the name of a table for messages and its CSV text."""
    return (os.fspath(table), None) if isinstance(table, (str, os.PathLike)) else (name, text_of(table, name))


def text_of(table: Any, name: str) -> str:
    """Return a table as CSV text; numbers keep every digit, and a missing value is an empty cell."""
    if isinstance(table, Mapping):
        return _columns_text([(str(heading), column) for heading, column in table.items()], name)
    if isinstance(table, np.ndarray) and table.dtype.names:
        return _columns_text([(heading, table[heading]) for heading in table.dtype.names], name)
    if hasattr(table, "iloc") and hasattr(table, "columns"):
        # pandas: its own Arrow interface needs pyarrow
        frame: Any = table
        columns = [(str(heading), _pandas_values(frame.iloc[:, k])) for k, heading in enumerate(frame.columns)]
        # a named index is a column, as `reset_index` makes it
        levels = [level for level in frame.index.names if level is not None and level not in frame.columns]
        columns[:0] = [(str(level), frame.index.get_level_values(level).to_numpy(dtype=object)) for level in levels]
        return _columns_text(columns, name)
    if hasattr(table, "__arrow_c_stream__"):
        try:
            return _etalon.csv(table)
        except ImportError as missing:
            library = type(table).__module__.split(".")[0]
            raise Error(f"`{name}`: {library} needs another package for its Arrow interface: {missing}") from missing
        except (TypeError, ValueError) as wrong:
            raise Error(f"`{name}`: a {type(table).__name__} is not a table: {wrong}") from wrong
    raise Error(
        f"`{name}`: a {type(table).__name__} is not a table: give a path, a dictionary of columns, "
        "or a DataFrame (pandas, polars, pyarrow, DuckDB)"
    )


def file_text(path: str | os.PathLike[str], name: str) -> str:
    """Return the text of a file."""
    try:
        with open(path, encoding="utf-8-sig") as file:
            return file.read()
    except OSError as error:
        raise Error(f"`{name}`: {os.fspath(path)} cannot be read: {error.strerror or error}") from error
    except UnicodeDecodeError as error:
        raise Error(f"`{name}`: {os.fspath(path)} is no text in UTF-8: {error.reason} at byte {error.start}") from error


def _pandas_values(column: Any) -> Any:
    """Return the values of a column; what pandas calls missing is None."""
    values = column.to_numpy(dtype=object, copy=True)
    values[np.asarray(column.isna())] = None
    return values


def _columns_text(columns: Iterable[tuple[str, Any]], name: str) -> str:
    stated = [(heading, _cells(column, f"`{name}`, column {heading!r}")) for heading, column in columns]
    headings = [heading for heading, _ in stated]
    twice = sorted({heading for heading in headings if headings.count(heading) > 1})
    if twice:
        raise Error(f"`{name}` has the same heading twice: {', '.join(map(repr, twice))}")
    lengths = {heading: len(cells) for heading, cells in stated}
    if len(set(lengths.values())) > 1:
        raise Error(f"`{name}`: columns of a table have one length: {lengths}")
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(headings)
    writer.writerows(zip(*(cells for _, cells in stated), strict=True))
    return text.getvalue()


def _cells(column: Any, place: str) -> list[Any]:
    """Return the cells of a column. Masked values, None and missing values of pandas are empty."""
    if isinstance(column, (str, bytes)) or not hasattr(column, "__len__"):
        raise Error(f"{place}: a {type(column).__name__} is not a column: give a list or an array of one dimension")
    if hasattr(column, "isna"):
        column = _pandas_values(column)
    array = np.ma.asarray(column) if isinstance(column, np.ma.MaskedArray) else np.asarray(column)
    if array.ndim != 1:
        raise Error(f"{place} has the shape {array.shape}: a column has one dimension and one length")
    # `tolist` of a masked array has None where values are masked
    return ["" if cell is None else cell for cell in array.tolist()]

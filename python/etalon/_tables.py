"""Tables of callers as the text that etalon reads."""

from __future__ import annotations

import csv
import io
import json
import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np

from . import _etalon
from ._errors import Error

#: What a task takes as a table: a path, columns by name, a structured array, or a DataFrame.
Table = Any


#: A table for the native part: path or name for messages, CSV text of a table in memory, sheet and headings of this table alone.
Named = dict[str, Any]
#: Headings of columns that are called otherwise in the table: a heading, a number from 1, or an expression.
Columns = Mapping[str, str | int]


@dataclass(frozen=True)
class Marks:
    """How files are read, and texts of tables in memory.

    Attributes:
        delimiter: Delimiter of the columns of files.
        decimal: Decimal mark of files, and of texts in tables in memory.
        sheet: Sheet of a workbook or topic of a recording; by the name of the argument if tables have different ones.
    """

    delimiter: str | None = None
    decimal: str | None = None
    sheet: str | Mapping[str, str] | None = None

    def options(self, **tables: Any) -> dict[str, str | None]:
        """Return the options of the files among tables.

        Raises:
            Error: A mark that no table has.
        """
        files = [name for name, table in tables.items() if is_path(table)]
        if not files and (self.delimiter or self.sheet):
            stated = "`delimiter`" if self.delimiter else "`sheet`"
            raise Error(f"{stated} is a mark of a file, and no table of this call is one: leave it out")
        if isinstance(self.sheet, Mapping):
            wrong = sorted(set(self.sheet) - set(files))
            if wrong:
                raise Error(f"`sheet` names {', '.join(wrong)}: expected tables of this call that are files ({', '.join(files)})")
        sheet = self.sheet if isinstance(self.sheet, str) else None
        return {"delimiter": self.delimiter, "decimal": self.decimal, "sheet": sheet}

    @contextmanager
    def apart(self, **tables: Any) -> Iterator[None]:
        """Raise errors about a missing sheet with a sheet for each workbook of a call with several tables."""
        try:
            yield
        except Error as error:
            books = [name for name, table in tables.items() if is_path(table) and str(os.fspath(table)).lower().endswith((".xlsx", ".xlsm"))]
            raise (error.with_hint("sheet-not-stated", _sheets(error, books)) if len(books) > 1 else error) from None

    def named(self, table: Any, name: str, columns: Columns | None = None) -> Named:
        """Return the path of a file with its own sheet, or the name of a table for messages and its CSV text; with headings of its own."""
        own = [f"{column}={heading}" for column, heading in (columns or {}).items()]
        if not is_path(table):
            return {"name": name, "text": text_of(table, name, self.decimal), "sheet": None, "columns": own}
        sheet = self.sheet.get(name) if isinstance(self.sheet, Mapping) else None
        return {"name": os.fspath(table), "text": None, "sheet": sheet, "columns": own}


def _sheets(error: Error, books: list[str]) -> str:
    """Return the hint that gives each table its sheet: the one of the same name, or the next one."""
    stated = next((message.arguments.get("sheets") for message in error.messages if message.id == "sheet-not-stated"), None)
    left = [str(sheet) for sheet in stated] if isinstance(stated, list) else []
    own = {name: next((sheet for sheet in left if sheet.casefold().startswith(name[:4])), None) for name in books}
    left = [sheet for sheet in left if sheet not in own.values()]
    chosen = {name: sheet or (left.pop(0) if left else "SHEET") for name, sheet in own.items()}
    return f"set `sheet={json.dumps(chosen, ensure_ascii=False)}`"


def is_path(table: Any) -> bool:
    """Return True for the path of a file."""
    return isinstance(table, (str, os.PathLike))


def text_of(table: Any, name: str, decimal: str | None = None) -> str:
    """Return a table as CSV text; numbers keep every digit, and a missing value is an empty cell.

    Args:
        table: The table.
        name: Name for messages.
        decimal: Decimal mark of texts that are numbers; a point if None.
    """
    comma = decimal is not None and decimal not in (".", "point")
    text = _text_of(table, name, comma)
    if not text.partition("\n")[2].strip():
        raise Error(f"`{name}` has no rows")
    if not comma or not _is_arrow(table):
        return text
    # a library with the Arrow interface: columns of texts are columns with a comma
    head, *rows = csv.reader(io.StringIO(text))
    columns = [
        [_with_point(cell, f"`{name}`, column {heading!r}, row {row}") for row, cell in enumerate(cells, 1)] if any(map(_COMMA.fullmatch, cells)) else cells
        for heading, cells in zip(head, zip(*rows))
    ]
    return _csv([head, *zip(*columns)])


def _with_point(cell: str, place: str) -> str:
    """Return a number with a decimal comma as one with a point; other texts as they are. A number with a point has another mark."""
    stated = cell.strip()
    if _POINT.fullmatch(stated):
        raise Error(f"{place}: `{stated}` has a point, but the decimal mark is `,`: remove thousands marks, for example by `.str.replace(\".\", \"\")` of pandas")
    return stated.replace(",", ".") if _COMMA.fullmatch(stated) else cell


#: Number with a decimal comma, and one with points before it.
_COMMA = re.compile(r"[+-]?\d+,\d*(?:[eE][+-]?\d+)?")
_POINT = re.compile(r"[+-]?\d+(?:\.\d+)+(?:,\d*)?(?:[eE][+-]?\d+)?")
#: Columns of names, which may contain points.
_NAMES = frozenset({"pose", "target", "cycle", "point", "joint", "kind", "label"})


def _csv(rows: Iterable[Sequence[Any]]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()


def _is_arrow(table: Any) -> bool:
    """Return True for a table that is read through the Arrow interface."""
    return not (isinstance(table, (Mapping, np.ndarray)) or (hasattr(table, "iloc") and hasattr(table, "columns")))


def _text_of(table: Any, name: str, comma: bool) -> str:
    if isinstance(table, Mapping):
        return _columns_text([(_heading(heading, k), column) for k, (heading, column) in enumerate(table.items())], name, comma)
    if isinstance(table, np.ndarray) and table.dtype.names:
        return _columns_text([(heading, table[heading]) for heading in table.dtype.names], name, comma)
    if hasattr(table, "iloc") and hasattr(table, "columns"):
        # pandas: its own Arrow interface needs pyarrow
        frame: Any = table
        columns = [(_heading(heading, k), _pandas_values(frame.iloc[:, k])) for k, heading in enumerate(frame.columns)]
        # a named index is a column, as `reset_index` makes it
        levels = [level for level in frame.index.names if level is not None and level not in frame.columns]
        columns[:0] = [(str(level), frame.index.get_level_values(level).to_numpy(dtype=object)) for level in levels]
        return _columns_text(columns, name, comma)
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


def _heading(heading: Any, at: int) -> str:
    """Return the heading of a column; of a column with a number, as of an array, its place from 1."""
    return f"column {at + 1}" if isinstance(heading, (int, np.integer)) else str(heading)


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


def _columns_text(columns: Iterable[tuple[str, Any]], name: str, comma: bool) -> str:
    stated = [(heading, _cells(column, f"`{name}`, column {heading!r}", comma and heading not in _NAMES)) for heading, column in columns]
    headings = [heading for heading, _ in stated]
    twice = sorted({heading for heading in headings if headings.count(heading) > 1})
    if twice:
        raise Error(f"`{name}` has the same heading twice: {', '.join(map(repr, twice))}")
    lengths = {heading: len(cells) for heading, cells in stated}
    if len(set(lengths.values())) > 1:
        raise Error(f"`{name}`: columns of a table have one length: {lengths}")
    return _csv([headings, *zip(*(cells for _, cells in stated), strict=True)])


def _cells(column: Any, place: str, comma: bool) -> list[Any]:
    """Return the cells of a column. Masked values, None and missing values of pandas are empty; texts are numbers with a decimal comma, if there is one."""
    if isinstance(column, (str, bytes)) or not hasattr(column, "__len__"):
        raise Error(f"{place}: a {type(column).__name__} is not a column: give a list or an array of one dimension")
    if hasattr(column, "isna"):
        column = _pandas_values(column)
    array = np.ma.asarray(column) if isinstance(column, np.ma.MaskedArray) else np.asarray(column)
    if array.ndim != 1:
        raise Error(f"{place} has the shape {array.shape}: a column has one dimension and one length")
    # `tolist` of a masked array has None where values are masked
    cells = ["" if cell is None else cell for cell in array.tolist()]
    if not comma:
        return cells
    return [_with_point(cell, f"{place}, row {row}") if isinstance(cell, str) else cell for row, cell in enumerate(cells, 1)]

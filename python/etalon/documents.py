"""Documents: what etalon answers, as objects.

The classes and their attributes are those of the JSON schemas (``etalon schema NAME``); the stub ``documents.pyi`` has
them all. Attributes and items have the names of the schema; a name that is a keyword of Python has an underscore behind it. Lists of numbers are
arrays, lists of records have ``to_pandas()``, ``to_polars()``, ``to_arrow()`` and ``to_dict()``.
"""

from __future__ import annotations

import html
import json
import math
from collections.abc import Iterable, Iterator
from functools import cache
from keyword import iskeyword
from typing import Any

import numpy as np

from ._members import MEMBERS

_ROWS = 50
#: Values with uncertainties and other lines in the text of a document; rows and width of a table in it.
_VALUES = 100
_LINES = 60
_SHOWN = 6
_WIDTH = 110


class Record:
    """A JSON object whose members are attributes and items; an optional member that is absent is None, an absent list is empty."""

    __slots__ = ("_members",)
    #: Name of the class in the schemas.
    _schema_class = ""

    def __init__(self, members: dict[str, Any]) -> None:
        object.__setattr__(self, "_members", members)

    def __getattr__(self, name: str) -> Any:
        key = name[:-1] if name.endswith("_") and iskeyword(name[:-1]) else name
        known = self._known()
        if key in self._members:
            return _wrapped(self._members[key], known.get(key, ("", None))[0])
        if key in known:
            kind, default = known[key]
            return Records([]) if default == [] else _wrapped(default, kind)
        raise AttributeError(f"{type(self).__name__} has no {name!r}: it has {', '.join(self._members)}")

    @classmethod
    def _known(cls) -> dict[str, tuple[str, Any]]:
        return MEMBERS.get(cls._schema_class or cls.__name__, {})

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError("documents cannot be changed; to_dict() gives a copy")

    def __reduce__(self) -> tuple[Any, ...]:
        return (_record, (type(self).__name__, self._members))

    def __getitem__(self, name: str) -> Any:
        known = self._known()
        return _wrapped(self._members[name], known.get(name, ("", None))[0])

    def __contains__(self, name: object) -> bool:
        return name in self._members

    def __iter__(self) -> Iterator[str]:
        return iter(self._members)

    def __len__(self) -> int:
        return len(self._members)

    def __eq__(self, other: object) -> bool:
        return self._members == other._members if isinstance(other, Record) else NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def __dir__(self) -> list[str]:
        named = {name + "_" if iskeyword(name) else name for name in (*self._members, *self._known())}
        return sorted({*super().__dir__(), *named})

    def get(self, name: str, default: Any = None) -> Any:
        """Return the member with this name of the schema, or the default if it is absent."""
        return self[name] if name in self._members else default

    def to_dict(self) -> dict[str, Any]:
        """Return a copy as dictionaries, lists, numbers and texts."""
        copy: dict[str, Any] = json.loads(json.dumps(self._members))
        return copy

    def to_json(self, indent: int | None = None) -> str:
        """Return the document as JSON text, which the program reads."""
        return json.dumps(self._members, indent=indent)

    def __repr__(self) -> str:
        return "\n".join(_lines(type(self).__name__, self._members))

    def describe(self) -> Records:
        """Return the members as a table: name, type, and meaning with its unit, as in the JSON schema."""
        stated = _described().get(self._schema_class or type(self).__name__, {})
        rows = [{"name": name, "type": _kind(schema), "meaning": schema.get("description", "")} for name, schema in stated.items()]
        return Records([Record(row) for row in rows])

    def _repr_html_(self) -> str:
        others = {name: value for name, value in self._members.items() if name != "messages"}
        return _said(self._members) + _section(type(self).__name__, others)


class Document(Record):
    """A document with a schema, as ``--json`` of the program prints it."""

    __slots__ = ()


class Records(list):  # type: ignore[type-arg]
    """A list of records, which is also a table; a part of it is one too."""

    def __getitem__(self, at: Any) -> Any:
        if isinstance(at, str):
            return self._named(at)
        found = super().__getitem__(at)
        return Records(found) if isinstance(at, slice) else found

    def _named(self, name: str) -> Any:
        """Return the record with this name."""
        names = [record.get("name") for record in self if isinstance(record, Record)]
        if name not in names:
            raise KeyError(f"no record has the name {name!r}: the names are {', '.join(str(other) for other in names if other is not None) or 'missing'}")
        return super().__getitem__(names.index(name))

    def column(self, name: str) -> list[Any]:
        """Return the values of a member of all records; None where it is absent."""
        return [getattr(record, name) for record in self]

    def to_dict(self) -> dict[str, list[Any]]:
        """Return the table as columns; None where a record has no value."""
        rows = [record._members if isinstance(record, Record) else {"value": record} for record in self]
        names = dict.fromkeys(name for row in rows for name in row)
        return {name: [row.get(name) for row in rows] for name in names}

    def to_pandas(self, *, flat: bool = False) -> Any:
        """Return the table as a DataFrame of pandas. ``flat`` gives members of members columns of their own: ``interval.low_mm``."""
        import pandas

        if flat:
            return pandas.json_normalize([record._members for record in self])
        # a column without any value is one of missing numbers
        return pandas.DataFrame({name: np.full(len(self), np.nan) if column.count(None) == len(column) else column for name, column in self.to_dict().items()})

    def to_polars(self) -> Any:
        """Return the table as a DataFrame of polars."""
        import polars

        return polars.DataFrame(self.to_dict(), strict=False)

    def to_arrow(self) -> Any:
        """Return the table as a table of pyarrow."""
        import pyarrow

        return pyarrow.table(self.to_dict())

    def __repr__(self) -> str:
        rows = [record._members for record in self if isinstance(record, Record)]
        return "\n".join([f"Records({len(self)})", *_grid(rows, len(rows) if len(rows) <= _ROWS else _SHOWN)]) if rows else "Records(0)"

    def _repr_html_(self) -> str:
        return _table([record._members for record in self if isinstance(record, Record)])


@cache
def _described() -> dict[str, dict[str, dict[str, Any]]]:
    """Return the members of each class with their schemas."""
    from . import _etalon

    found: dict[str, dict[str, dict[str, Any]]] = {}
    for name in _CLASSES:
        schema = json.loads(_etalon.schema(name))
        for title, part in {**schema.get("$defs", {}), schema["title"]: schema}.items():
            found.setdefault(title, part.get("properties", {}))
    return found


def _kind(schema: dict[str, Any]) -> str:
    """Return the type of a member in words: of another class its name, which ``documents`` has."""
    if "$ref" in schema:
        return str(schema["$ref"]).rsplit("/", 1)[-1]
    if "anyOf" in schema:
        return " | ".join(_kind(part) for part in schema["anyOf"])
    kinds = schema.get("type", "any")
    listed = [f"array of {_kind(schema['items'])}" if kind == "array" and "items" in schema else kind for kind in (kinds if isinstance(kinds, list) else [kinds])]
    return " | ".join("absent" if kind == "null" else kind for kind in listed)


def _record(name: str, members: dict[str, Any]) -> Record:
    """Return a record of the class with this name."""
    return _class(name)(members)


def _class(name: str) -> type[Record]:
    found = globals().get(name) if name else Record
    if found is None:
        found = globals()[name] = type(name, (Record,), {"__slots__": (), "__module__": __name__})
    return found  # type: ignore[no-any-return]


def _wrapped(value: Any, kind: str) -> Any:
    """Return a value of JSON: objects as records of a class, lists of numbers as arrays."""
    if isinstance(value, dict):
        return _class(kind)(value)
    if isinstance(value, list):
        if _is_vector(value):
            return np.array(value)
        if value and all(isinstance(item, list) and _is_vector(item) for item in value) and len({len(item) for item in value}) == 1:
            return np.array(value)
        wrapped = [_wrapped(item, kind) for item in value]
        return Records(wrapped) if all(isinstance(item, Record) for item in wrapped) else wrapped
    return value


def _is_vector(value: list[Any]) -> bool:
    return bool(value) and all(isinstance(item, float) for item in value)


def _rounded(value: float, uncertainty: float) -> tuple[str, str]:
    """Return a value and its uncertainty with two digits of the uncertainty."""
    if not uncertainty > 0 or not math.isfinite(uncertainty):
        return f"{value:.6g}", f"{uncertainty:.2g}"
    digits = max(0, 1 - math.floor(math.log10(uncertainty)))
    return f"{value:.{digits}f}", f"{uncertainty:.{digits}f}"


def _value_with_uncertainty(row: dict[str, Any]) -> str | None:
    """Return the value of a row with its expanded uncertainty, if the row has both."""
    value, u = row.get("value"), row.get("standard_uncertainty")
    if not isinstance(value, float) or not isinstance(u, float):
        return None
    shown, expanded = _rounded(value, 2 * u)
    return f"{shown} ± {expanded}"


_EXPANDED = "value ± U (k = 2)"


def _cell(value: Any) -> str:
    text = f"{value:.6g}" if isinstance(value, float) else json.dumps(value) if isinstance(value, (dict, list)) else value
    return html.escape("" if text is None else str(text))


def _with_expanded(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return rows with values and their uncertainties behind the names, if they have them."""
    if not any(_value_with_uncertainty(row) for row in rows):
        return rows

    def row_of(row: dict[str, Any]) -> dict[str, Any]:
        first = {name: row[name] for name in ("name", "unit") if name in row}
        shown = _value_with_uncertainty(row)
        return {**first, _EXPANDED: shown if shown is not None else row.get("value"), **row}

    return [row_of(row) for row in rows]


def _table(rows: list[dict[str, Any]]) -> str:
    rows = _with_expanded([{name: value for name, value in row.items() if not _is_translation(name)} for row in rows])
    names = list(dict.fromkeys(name for row in rows for name, value in row.items() if not isinstance(value, (dict, list))))
    head = "".join(f"<th>{html.escape(name)}</th>" for name in names)
    body = "".join(f"<tr>{''.join(f'<td>{_cell(row.get(name))}</td>' for name in names)}</tr>" for row in rows[:_ROWS])
    more = f"<p>{len(rows) - _ROWS} more rows</p>" if len(rows) > _ROWS else ""
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{more}"


def _said(members: dict[str, Any]) -> str:
    from ._errors import Message, messages_of

    def item(said: Message) -> str:
        hint = f"<br><i>{html.escape(said.hint)}</i>" if said.hint else ""
        return f"<li><b>{html.escape(said.severity)}</b> <code>{html.escape(said.id or '')}</code>: {html.escape(said.what)}{hint}</li>"

    items = "".join(map(item, messages_of(members)))
    return f"<ul>{items}</ul>" if items else ""


def _section(title: str, members: dict[str, Any]) -> str:
    members = {name: value for name, value in members.items() if not _is_translation(name)}
    plain = {name: value for name, value in members.items() if not isinstance(value, (dict, list))}
    tables = [(name, value) for name, value in members.items() if _is_table(value)]
    # values with their uncertainties come first
    tables.sort(key=lambda table: not any(_value_with_uncertainty(row) for row in table[1]))
    parts = [f"<h4>{html.escape(title)}</h4>"]
    parts += [f"<h5>{html.escape(name)}</h5>{_table(value)}" for name, value in tables]
    if plain:
        parts.append(_table([plain]))
    parts += [_section(name, value) for name, value in members.items() if isinstance(value, dict)]
    return "".join(parts)


def _is_table(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and all(isinstance(item, dict) for item in value)


def _short(value: Any) -> str:
    """Return a value in some words."""
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, list):
        numbers = len(value) <= 8 and all(isinstance(item, (int, float, str)) for item in value)
        return "[" + ", ".join(map(_short, value)) + "]" if numbers else f"{len(value)} entries"
    if isinstance(value, dict):
        shown = [f"{name}=({_short(item)})" if isinstance(item, dict) else f"{name}={_short(item)}" for name, item in value.items() if not isinstance(item, list)]
        return ", ".join(shown[:12])
    text = str(value)
    return text if len(text) <= 100 else text[:97] + "..."


def _grid(rows: list[dict[str, Any]], shown: int) -> list[str]:
    """Return the first rows of a table as text: the first columns with numbers and words that fit on a line."""
    rows, left = rows[:shown], len(rows) - shown
    names = dict.fromkeys(name for row in rows for name, value in row.items() if isinstance(value, (int, float, str)) and not _is_translation(name))
    columns = [[name, *(_short(row.get(name, "")) for row in rows)] for name in names]
    widths = np.cumsum([2 + max(map(len, column)) for column in columns])
    columns = columns[: int(np.searchsorted(widths, _WIDTH, side="right"))]
    lines = ["  " + "".join(f"{cell:{2 + max(map(len, column))}}" for cell, column in zip(cells, columns)).rstrip() for cells in zip(*columns)]
    more = list(names)[len(columns) :]
    return lines + (["  ..."] if left > 0 and lines else []) + ([f"  more columns: {', '.join(more)}"] if more and lines else [])


def _rows(name: str, rows: list[dict[str, Any]]) -> list[str]:
    """Return the text of a table that is a member of a document."""
    return [f"  {name}: {len(rows)} entries", *(f"  {line}" for line in _grid(rows, _SHOWN))]


def _is_translation(name: str) -> bool:
    """Return True for a member with the id and the arguments of a text, from which a report in another language has the text."""
    return name.endswith(("_phrase", "_phrases")) or name in ("meaning_id", "title_id")


def _lines(title: str, members: dict[str, Any]) -> list[str]:
    """Return the text of a record: messages, values with their uncertainties, then the other members."""
    from ._errors import messages_of

    lines = [title]
    for message in messages_of(members):
        lines.append(f"  {message.severity}: {message.id or ''}: {message.what}")
    others: list[list[str]] = []
    names: list[str] = []
    for name, value in members.items():
        if name in ("messages", "schema") or _is_translation(name):
            continue
        if _is_table(value) and any(_value_with_uncertainty(row) for row in value):
            lines += _values(name, value)
            continue
        names.append(name)
        others.append(_rows(name, value) if _is_table(value) else [f"  {name}: {_short(value)}"])
    shown = 0
    while shown < len(others) and sum(map(len, others[: shown + 1])) <= _LINES:
        lines += others[shown]
        shown += 1
    return lines + ([f"  more members: {', '.join(names[shown:])}"] if shown < len(others) else [])


def _values(name: str, rows: list[dict[str, Any]]) -> list[str]:
    """Return the text of values with their uncertainties; those that have none are held, and are counted."""
    known = [row for row in rows if _value_with_uncertainty(row)]
    width = max(len(str(row.get("name", ""))) for row in known)
    lines = [f"  {name}: {len(known)} of {len(rows)} entries with {_EXPANDED}:"]
    lines += [f"    {row.get('name', '')!s:{width}} {_value_with_uncertainty(row)} {row.get('unit', '')}" for row in known[:_VALUES]]
    left = [f"{count} {what}" for count, what in ((len(known) - _VALUES, "more with uncertainties"), (len(rows) - len(known), "without")) if count > 0]
    return lines + ([f"    and {', '.join(left)}: .{name}, .{name}.to_pandas()"] if left else [])


#: Class of each document by its name in ``schema``: ``etalon/NAME/VERSION``.
_CLASSES = {
    "accuracy": "AccuracyDocument",
    "axes": "AxesDocument",
    "batch": "BatchDocument",
    "benchmark-score": "BenchmarkScoreDocument",
    "cell": "CellDocument",
    "check": "CheckDocument",
    "compare": "CompareDocument",
    "compensation": "CompensationDocument",
    "controllers": "ControllersDocument",
    "explanation": "ExplanationDocument",
    "features": "FeaturesDocument",
    "field": "FieldDocument",
    "fit": "FitDocument",
    "formats": "FormatsDocument",
    "frames": "FramesDocument",
    "geometric": "GeometricDocument",
    "import": "ImportDocument",
    "iso230": "AxisDocument",
    "iso9283": "Iso9283Document",
    "iso9283-compliance": "Iso9283ComplianceDocument",
    "iso9283-plan": "Iso9283PlanDocument",
    "iso9283-stream": "Iso9283StreamDocument",
    "iso9283-streams": "Iso9283StreamsDocument",
    "kinematics": "KinematicsDocument",
    "manifest": "ManifestDocument",
    "parameters": "ParametersDocument",
    "plan": "PlanDocument",
    "predictions": "PredictionsDocument",
    "recommendation": "RecommendationDocument",
    "selftest": "SelftestDocument",
    "study": "StudiesDocument",
    "uncertainty": "UncertaintyDocument",
    "verdict": "VerdictDocument",
    "verification": "VerificationDocument",
    "verification-plan": "VerificationPlanDocument",
    "written": "WrittenDocument",
}

for _name in _CLASSES.values():
    globals()[_name] = type(_name, (Document,), {"__slots__": (), "__module__": __name__})


def __getattr__(name: str) -> Any:
    """Return the class of a record of the schemas."""
    if name in MEMBERS:
        return _class(name)
    raise AttributeError(f"module 'etalon.documents' has no attribute {name!r}")


def load(text: str) -> Document:
    """Return the document in a JSON text, of the class that its schema names."""
    members = json.loads(text)
    schema = members.get("schema", "").split("/") if isinstance(members, dict) else []
    name = _CLASSES.get(schema[1]) if len(schema) == 3 else None
    return (globals()[name] if name else Document)(members)

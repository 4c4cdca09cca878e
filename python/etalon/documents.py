"""Documents: what etalon answers, as objects.

The classes and their attributes are those of the JSON schemas (``etalon schema NAME``); the stub ``documents.pyi`` has
them all. A document behaves like the JSON object: attributes and items have the names of the schema.
"""

from __future__ import annotations

import html
import json
from collections.abc import Iterator, Mapping
from typing import Any

_ROWS = 50


class Record(Mapping):
    """A JSON object whose members are attributes too; a member that the document leaves out raises AttributeError."""

    __slots__ = ("_members",)

    def __init__(self, members: dict[str, Any]) -> None:
        object.__setattr__(self, "_members", members)

    def __getattr__(self, name: str) -> Any:
        try:
            return _wrapped(self._members[name])
        except KeyError:
            raise AttributeError(f"{type(self).__name__} has no {name!r}") from None

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError("documents cannot be changed; to_dict() gives a copy")

    def __reduce__(self):
        return (type(self), (self._members,))

    def __getitem__(self, name: str) -> Any:
        return _wrapped(self._members[name])

    def __iter__(self) -> Iterator[str]:
        return iter(self._members)

    def __len__(self) -> int:
        return len(self._members)

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._members})

    def to_dict(self) -> dict[str, Any]:
        """Return a copy as dictionaries, lists, numbers and texts."""
        return json.loads(json.dumps(self._members))

    def to_json(self, indent: int | None = None) -> str:
        """Return the document as JSON text, which the program reads."""
        return json.dumps(self._members, indent=indent)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(self._members)})"

    def _repr_html_(self) -> str:
        return _section(type(self).__name__, self._members)


class Document(Record):
    """A document with a schema, as ``--json`` of the program prints it."""

    __slots__ = ()


def _wrapped(value: Any) -> Any:
    if isinstance(value, dict):
        return Record(value)
    if isinstance(value, list):
        return [_wrapped(item) for item in value]
    return value


def _cell(value: Any) -> str:
    text = f"{value:.6g}" if isinstance(value, float) else json.dumps(value) if isinstance(value, (dict, list)) else value
    return html.escape("" if text is None else str(text))


def _table(rows: list[dict[str, Any]]) -> str:
    names = list(dict.fromkeys(name for row in rows for name, value in row.items() if not isinstance(value, (dict, list))))
    head = "".join(f"<th>{html.escape(name)}</th>" for name in names)
    body = "".join(f"<tr>{''.join(f'<td>{_cell(row.get(name))}</td>' for name in names)}</tr>" for row in rows[:_ROWS])
    more = f"<p>{len(rows) - _ROWS} more rows</p>" if len(rows) > _ROWS else ""
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{more}"


def _section(title: str, members: dict[str, Any]) -> str:
    plain = {name: value for name, value in members.items() if not isinstance(value, (dict, list))}
    parts = [f"<h4>{html.escape(title)}</h4>", _table([plain])] if plain else [f"<h4>{html.escape(title)}</h4>"]
    for name, value in members.items():
        if isinstance(value, dict):
            parts.append(_section(name, value))
        elif isinstance(value, list) and value and all(isinstance(item, dict) for item in value):
            parts.append(f"<h5>{html.escape(name)}</h5>{_table(value)}")
    return "".join(parts)


#: Class of each document by its name in ``schema``: ``etalon/NAME/VERSION``.
_CLASSES = {
    "accuracy": "AccuracyDocument",
    "axes": "AxesDocument",
    "batch": "BatchDocument",
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


def load(text: str) -> Document:
    """Return the document in a JSON text, of the class that its schema names."""
    members = json.loads(text)
    schema = members.get("schema", "").split("/") if isinstance(members, dict) else []
    name = _CLASSES.get(schema[1]) if len(schema) == 3 else None
    return (globals()[name] if name else Document)(members)

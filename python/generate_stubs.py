"""Write etalon/documents.pyi and etalon/_members.py, the classes of all documents, from the JSON schemas of the program."""

from __future__ import annotations

import json
import keyword
import textwrap
from pathlib import Path

SCHEMAS = Path(__file__).parent.parent / "schemas"
HEAD = '''"""Classes of the documents; written by generate_stubs.py from the JSON schemas."""

from collections.abc import Iterator
from typing import Any, SupportsIndex, TypeVar, overload

import numpy as np
from numpy.typing import NDArray

_T = TypeVar("_T")

class Record:
    """A JSON object whose members are attributes and items; an optional member that is absent is None, an absent list is empty."""

    _members: dict[str, Any]

    def __init__(self, members: dict[str, Any]) -> None: ...
    def __getitem__(self, name: str) -> Any: ...
    def __contains__(self, name: object) -> bool: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def get(self, name: str, default: Any = None) -> Any:
        """Return the member with this name of the schema, or the default if it is absent."""
    def to_dict(self) -> dict[str, Any]:
        """Return a copy as dictionaries, lists, numbers and texts."""
    def to_json(self, indent: int | None = None) -> str:
        """Return the document as JSON text, which the program reads."""
    def describe(self) -> Records[Record]:
        """Return the members as a table: name, type, and meaning with its unit, as in the JSON schema."""
    def _repr_html_(self) -> str: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

class Document(Record):
    """A document with a schema, as ``--json`` of the program prints it."""

class Records(list[_T]):
    """A list of records, which is also a table; a part of it is one too."""

    @overload
    def __getitem__(self, at: SupportsIndex, /) -> _T: ...
    @overload
    def __getitem__(self, at: slice[Any, Any, Any], /) -> Records[_T]: ...
    @overload
    def __getitem__(self, at: str, /) -> _T: ...
    def column(self, name: str) -> list[Any]:
        """Return the values of a member of all records; None where it is absent."""
    def to_dict(self) -> dict[str, list[Any]]:
        """Return the table as columns; None where a record has no value."""
    def to_pandas(self, *, flat: bool = False) -> Any:
        """Return the table as a DataFrame of pandas. ``flat`` gives members of members columns of their own: ``interval.low_mm``."""
    def to_polars(self) -> Any:
        """Return the table as a DataFrame of polars."""
    def to_arrow(self) -> Any:
        """Return the table as a table of pyarrow."""
    def _repr_html_(self) -> str: ...

def load(text: str) -> Document:
    """Return the document in a JSON text, of the class that its schema names."""

def _table(rows: list[dict[str, Any]]) -> str: ...

_CLASSES: dict[str, str]
'''
PLAIN = {"string": "str", "number": "float", "integer": "int", "boolean": "bool", "null": "None"}


ARRAY = "NDArray[np.float64]"


def parts_of(schema: dict) -> list[object]:
    """Return the alternatives of a schema, but null."""
    stated = schema.get("anyOf", [schema])
    return [part for part in stated if part != {"type": "null"}]


def can_be_null(schema: object) -> bool:
    """Return whether a value may be null."""
    if not isinstance(schema, dict):
        return False
    kinds = schema.get("type")
    return {"type": "null"} in schema.get("anyOf", []) or (isinstance(kinds, list) and "null" in kinds)


def is_number(schema: object) -> bool:
    """Return whether a schema is that of a number with a fraction."""
    return isinstance(schema, dict) and schema.get("type") == "number"


def is_numbers(schema: object) -> bool:
    """Return whether a schema is a list of numbers, or a list of such lists."""
    if not isinstance(schema, dict) or "array" not in (schema.get("type") or []):
        return False
    items = schema.get("items") or (schema.get("prefixItems") or [None])[0]
    return is_number(items) or is_numbers(items)


def annotation(schema: object, classes: set[str]) -> str:
    """Return the type of a schema; what is no plain type is Any."""
    if not isinstance(schema, dict):
        return "Any"
    if "$ref" in schema:
        name = schema["$ref"].rsplit("/", 1)[-1]
        return name if name in classes else ENUMS.get(name, "Any")
    if "anyOf" in schema:
        parts = [annotation(part, classes) for part in schema["anyOf"]]
        return "Any" if "Any" in parts else " | ".join(dict.fromkeys(parts))
    kinds = schema.get("type")
    parts = []
    for kind in kinds if isinstance(kinds, list) else [kinds]:
        if kind == "array":
            item = annotation(schema.get("items"), classes)
            parts.append(ARRAY if is_numbers(schema) else f"Records[{item}]" if item in classes else f"list[{item}]")
        elif kind == "object":
            parts.append("Record")
        else:
            parts.append(PLAIN.get(kind, "Any"))
    return "Any" if "Any" in parts else " | ".join(parts)


#: Types of names that have a list of values, by their names in the schemas.
ENUMS: dict[str, str] = {}


def enum(schema: dict) -> str | None:
    """Return the type of a schema that lists its values."""
    values = schema.get("enum") or [part.get("const") for part in schema.get("oneOf", []) if "const" in part or "enum" in part]
    if "oneOf" in schema and any("const" not in part and "enum" not in part for part in schema["oneOf"]):
        return None
    if "oneOf" in schema:
        values = [value for part in schema["oneOf"] for value in ([part["const"]] if "const" in part else part["enum"])]
    return "str" if values and all(isinstance(value, str) for value in values) else None


def record_of(schema: object, records: set[str]) -> str:
    """Return the class of the records in a member, or an empty text."""
    if not isinstance(schema, dict):
        return ""
    if "$ref" in schema:
        name = schema["$ref"].rsplit("/", 1)[-1]
        return name if name in records else ""
    inner = [record_of(part, records) for part in schema.get("anyOf", [])]
    inner.append(record_of(schema.get("items"), records))
    named = [name for name in inner if name]
    return named[0] if len(named) == 1 else ""


def default_of(schema: object) -> object:
    """Return the value of a member that is absent."""
    if not isinstance(schema, dict) or can_be_null(schema):
        return None
    if "default" in schema:
        return schema["default"]
    kind = schema.get("type")
    return {"array": [], "string": "", "object": {}, "boolean": False}.get(kind) if isinstance(kind, str) else None


def text(described: str, indent: str) -> list[str]:
    """Return a docstring."""
    words = " ".join(described.replace("\\", "\\\\").replace('"""', "'''").split())
    lines = textwrap.wrap(words, 110) or ["..."]
    if len(lines) == 1:
        return [f'{indent}"""{lines[0]}"""']
    return [f'{indent}"""{lines[0]}', *(indent + line for line in lines[1:]), f'{indent}"""']


def schemas() -> tuple[dict, dict]:
    """Return documents and their records by name."""
    documents, parts = {}, {}
    for path in sorted(SCHEMAS.glob("*.schema.json")):
        if path.name.count(".toml"):
            continue
        schema = json.loads(path.read_text(encoding="utf-8"))
        documents[schema["title"]] = schema
        parts |= schema.get("$defs", {})
    ENUMS.update({name: kind for name, part in parts.items() if (kind := enum(part))})
    return documents, {name: part for name, part in parts.items() if "properties" in part and name not in documents}


def members() -> str:
    """Return the table of the members of each class."""
    documents, records = schemas()
    lines = ['"""Members of the classes of documents; written by generate_stubs.py from the JSON schemas."""', ""]
    lines += ["from typing import Any", "", "#: Class of the records in each member, and its value where it is absent."]
    lines += ["MEMBERS: dict[str, dict[str, tuple[str, Any]]] = {"]
    for name, schema in sorted({**records, **documents}.items()):
        lines.append(f"    {name!r}: {{")
        for member, stated in schema["properties"].items():
            lines.append(f"        {member!r}: ({record_of(stated, {*documents, *records})!r}, {default_of(stated)!r}),")
        lines.append("    },")
    return "\n".join([*lines, "}", ""]).replace("'", '"')


def main() -> str:
    """Return the stub."""
    documents, records = schemas()
    classes = {*documents, *records}
    lines = [HEAD]
    for base, group in (("Record", records), ("Document", documents)):
        for name, schema in sorted(group.items()):
            lines += [f"class {name}({base}):", *text(schema.get("description", name), "    ")]
            for member, stated in schema["properties"].items():
                if member.isidentifier():
                    name_of = member + "_" if keyword.iskeyword(member) else member
                    kind = annotation(stated, classes)
                    absent = member not in schema.get("required", []) and default_of(stated) is None
                    if absent and kind != "Any" and "None" not in kind.split(" | "):
                        kind += " | None"
                    lines.append(f"    {name_of}: {kind}")
                    if isinstance(stated, dict) and "description" in stated:
                        lines += text(stated["description"], "    ")
            lines.append("")
    return "\n".join(lines)


if __name__ == "__main__":
    package = Path(__file__).parent / "etalon"
    (package / "documents.pyi").write_text(main(), encoding="utf-8")
    (package / "_members.py").write_text(members(), encoding="utf-8")

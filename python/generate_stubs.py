"""Write etalon/documents.pyi, the classes of all documents, from the JSON schemas of the program."""

from __future__ import annotations

import json
import keyword
import textwrap
from pathlib import Path

SCHEMAS = Path(__file__).parent.parent / "schemas"
HEAD = '''"""Classes of the documents; written by generate_stubs.py from the JSON schemas."""

from collections.abc import Iterator, Mapping
from typing import Any

class Record(Mapping[str, Any]):
    """A JSON object whose members are attributes too; a member that the document leaves out raises AttributeError."""

    def __init__(self, members: dict[str, Any]) -> None: ...
    def __getattr__(self, name: str) -> Any: ...
    def __getitem__(self, name: str) -> Any: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def to_dict(self) -> dict[str, Any]:
        """Return a copy as dictionaries, lists, numbers and texts."""
    def to_json(self, indent: int | None = None) -> str:
        """Return the document as JSON text, which the program reads."""
    def _repr_html_(self) -> str: ...

class Document(Record):
    """A document with a schema, as ``--json`` of the program prints it."""

def load(text: str) -> Document:
    """Return the document in a JSON text, of the class that its schema names."""
'''
PLAIN = {"string": "str", "number": "float", "integer": "int", "boolean": "bool", "null": "None"}


def annotation(schema: object, classes: set[str]) -> str:
    """Return the type of a schema; what is no plain type is Any."""
    if not isinstance(schema, dict):
        return "Any"
    if "$ref" in schema:
        name = schema["$ref"].rsplit("/", 1)[-1]
        return f'"{name}"' if name in classes else "Any"
    if "anyOf" in schema:
        parts = [annotation(part, classes) for part in schema["anyOf"]]
        return "Any" if "Any" in parts else " | ".join(dict.fromkeys(parts)).replace('"', "")
    kinds = schema.get("type")
    parts = []
    for kind in kinds if isinstance(kinds, list) else [kinds]:
        if kind == "array":
            parts.append(f"list[{annotation(schema.get('items'), classes)}]")
        elif kind == "object":
            parts.append("Record")
        else:
            parts.append(PLAIN.get(kind, "Any"))
    return "Any" if "Any" in parts else " | ".join(parts).replace('"', "")


def text(described: str, indent: str) -> list[str]:
    """Return a docstring."""
    words = " ".join(described.replace("\\", "\\\\").replace('"""', "'''").split())
    lines = textwrap.wrap(words, 110) or ["..."]
    if len(lines) == 1:
        return [f'{indent}"""{lines[0]}"""']
    return [f'{indent}"""{lines[0]}', *(indent + line for line in lines[1:]), f'{indent}"""']


def main() -> str:
    """Return the stub."""
    documents, parts = {}, {}
    for path in sorted(SCHEMAS.glob("*.schema.json")):
        if path.name.count(".toml"):
            continue
        schema = json.loads(path.read_text(encoding="utf-8"))
        documents[schema["title"]] = schema
        parts |= schema.get("$defs", {})
    records = {name: part for name, part in parts.items() if "properties" in part and name not in documents}
    classes = {*documents, *records}
    lines = [HEAD]
    for base, group in (("Record", records), ("Document", documents)):
        for name, schema in sorted(group.items()):
            lines += [f"class {name}({base}):", *text(schema.get("description", name), "    ")]
            for member, stated in schema["properties"].items():
                if member.isidentifier() and not keyword.iskeyword(member):
                    lines.append(f"    {member}: {annotation(stated, classes)}")
                    if isinstance(stated, dict) and "description" in stated:
                        lines += text(stated["description"], "    ")
            lines.append("")
    return "\n".join(lines)


if __name__ == "__main__":
    (Path(__file__).parent / "etalon/documents.pyi").write_text(main(), encoding="utf-8")

"""Errors and warnings of etalon."""

from __future__ import annotations

import json
import re
import sys
import warnings
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

#: Option of a command line with the value that a text gives it.
_VALUE = r"\"[^\"]*\"|'[^']*'|[A-Za-z_]\w*=[^\s,;`)]+|[A-Z][^\s,;:`)]*|-?\d[\d.]*"
_OPTION = re.compile(rf"(?<![\w-])--([a-z][a-z0-9-]*)(?:[ =]({_VALUE}))?")
#: Option with any value, alone between marks.
_MARKED = re.compile(r"`--([a-z][a-z0-9-]*) ([^`]+)`")
_PAIR = re.compile(r"([A-Za-z_]\w*)=([^=]+)")
#: Options that take a dictionary, and their keywords.
_PAIRS = {"column": "columns", "constant": "constant", "only": "only", "without": "without"}


#: Options in brackets, behind a key of campaign.toml.
_BESIDE = re.compile(r" \(options? --[^()]*\)")
#: Key of a campaign behind an option.
_IN_CAMPAIGN = re.compile(r", in a campaign `[^`]*`")
#: Keys of campaign.toml with their values.
_INLINE = re.compile(r"`(\w+) = \{ ?([^{}]*?) ?\}`")
_KEY = re.compile(r"`(\w+) = (\"[^\"`]*\"|-?[\d.]+)`")
_ENTRY = re.compile(r"(\w+) = (\"[^\"]*\"|[^,\s]+)")
#: Key of a section of campaign.toml that no function has, before what it has instead.
_OF_INSTRUMENT = re.compile(r"(, )?`\w+` in \[instrument\],? or |,? or `\w+` in \[join\]$")
#: Key of a section of campaign.toml, perhaps before the option of the same name.
_IN_SECTION = re.compile(
    r"`(\w+)( = [^`]+)?`(?: in \[(?:identify|observations|poses|limits)\](?:(?:,? or | \()`?--([a-z-]+)`?\)?)?|, --([a-z-]+))"
)
#: Help of a command that is a function, and of any command.
_HELP = re.compile(r"`etalon (identify|plan|verify|axes|cell|iso9283|iso230|fit) --help`")
_ANY_HELP = re.compile(r"`etalon COMMAND --help` lists the values")


def campaign_words(text: str) -> str:
    """Return a text for campaign.toml: without the options that are behind its keys."""
    return _BESIDE.sub("", text)


def python_words(text: str) -> str:
    """Return a text for Python: keys of campaign.toml and options of the command line as keyword arguments."""
    text = _OF_INSTRUMENT.sub(lambda found: ", or " if found[1] else "", _IN_CAMPAIGN.sub("", _BESIDE.sub("", text)))
    text = _IN_SECTION.sub(_keyword_of_section, text)
    text = _HELP.sub(r"`help(etalon.\1)`", text)
    text = _ANY_HELP.sub("the documentation of the function lists the values", text)
    text = _INLINE.sub(lambda found: f"`{found[1]}={{" + _ENTRY.sub(r'"\1": \2', found[2]) + "}`", text)
    text = _KEY.sub(r"`\1=\2`", text)

    def keyword(found: re.Match[str]) -> str:
        name, value = found[1].replace("-", "_"), found[2]
        if name == "help":
            return found[0]
        pair = _PAIR.fullmatch(value.strip("\"'")) if value else None
        if found[1] in _PAIRS:
            return _PAIRS[found[1]] + (f'={{"{pair[1]}": "{pair[2]}"}}' if pair else "=" + (value or "{...}"))
        if value is None:
            return f"{name}="
        quoted = value if value[0] in "\"'" or re.fullmatch(r"-?\d+(\.\d+)?", value) else f'"{value}"'
        return f"{name}={quoted}"

    def part(found: re.Match[str]) -> str:
        # a command of a shell stays as it is
        if found[0].startswith("`") and not found[0].startswith("`--"):
            return found[0]
        marked = _MARKED.fullmatch(found[0])
        return f"`{keyword(marked)}`" if marked else _OPTION.sub(keyword, found[0])

    return re.sub(r"`[^`]*`|[^`]+", part, text)


def _keyword_of_section(found: re.Match[str]) -> str:
    """Return a key of campaign.toml as a keyword argument, without the option of the same name."""
    name, value, option = found[1], found[2] or "", found[3] or found[4]
    if option and option.replace("-", "_") != name:
        return found[0]
    return f"`{name}{value}`" if value else f"`{name}=`"


class Message:
    """One error or warning.

    Attributes:
        severity: ``"error"`` or ``"warning"``.
        what: What is wrong, in one sentence.
        expected: What was expected there, or None.
        hint: What to do, or None: keyword arguments, or of a campaign the keys of campaign.toml.
        place: File, line and column as a dictionary, of a table in memory its name and the row from 1; or None.
        id: Id of the message (``etalon explain ID``), or None.
        arguments: Arguments of the message by name.
    """

    def __init__(self, stated: dict[str, Any], *, in_campaign: bool = False, in_memory: bool = False) -> None:
        def words(text: str | None) -> str | None:
            if text is None or in_campaign:
                return None if text is None else campaign_words(text)
            return python_words(row_words(text) if has_rows else text)

        place: dict[str, Any] | None = stated.get("place")
        has_rows = place["file"] in TABLES if place and "file" in place else in_memory
        if place is not None and has_rows and "line" in place:
            place = {"file": place["file"], **({"row": place["line"] - 1} if place["line"] > 1 else {})}
        self.severity: str = stated.get("severity", "error")
        self.what: str = words(stated.get("what") or stated.get("text")) or ""
        self.expected: str | None = words(stated.get("expected"))
        self.hint: str | None = words(stated.get("hint"))
        self.stated_hint: str | None = stated.get("hint")
        self.place: dict[str, Any] | None = place
        self.id: str | None = stated.get("id")
        self.arguments: dict[str, Any] = stated.get("arguments", {})

    def __repr__(self) -> str:
        return f"Message({self.severity}: {self.what})"

    def __str__(self) -> str:
        named = f"{self.id}: {self.what}" if self.id else self.what
        return named + (f"\nhint: {self.hint}" if self.hint else "")


class MessageWarning(UserWarning):
    """A warning of etalon. Its text begins with the id of the message.

    Each id has a class of its own, :func:`warning_class`, for ``warnings.simplefilter``.

    Attributes:
        message: The message.
    """

    def __init__(self, message: Message | str) -> None:
        super().__init__(str(message))
        self.message = message if isinstance(message, Message) else Message({"severity": "warning", "what": message})

    def __reduce__(self) -> tuple[Any, ...]:
        # classes of ids are made when they are needed
        return (_warning, (self.message,))


class ImplausibleWarning(MessageWarning):
    """The result can be that of no such robot: a message of severity ``error``. The program ends with exit code 1."""


def warning_class(id: str) -> type[MessageWarning]:
    """Return the class of the warnings with an id.

    ``warnings.simplefilter("ignore", etalon.warning_class("columns-not-read"))`` silences one message,
    ``warnings.simplefilter("error", etalon.MessageWarning)`` turns all into exceptions.

    Args:
        id: Id of a message, as in ``docs/messages.md``.

    Raises:
        Error: No message has this id.
    """
    from . import _etalon

    _etalon.explain(id)
    return _class_of(id)


@cache
def _class_of(id: str) -> type[MessageWarning]:
    """Return the class of the warnings with an id."""
    name = "".join(part.capitalize() for part in re.split(r"\W+", id)) + "Warning"
    return type(name, (MessageWarning,), {"__doc__": f"Message `{id}`.", "__module__": __name__, "id": id})


@cache
def _implausible_class(id: str) -> type[MessageWarning]:
    """Return the class of the messages with an id that make a result implausible."""
    own = _class_of(id)
    return type("Implausible" + own.__name__, (ImplausibleWarning, own), {"__doc__": own.__doc__, "__module__": __name__, "id": id})


def _warning(message: Message) -> MessageWarning:
    """Return a message as a warning with the class of its id."""
    name = message.id or "message"
    return (_implausible_class(name) if message.severity == "error" else _class_of(name))(message)


def warn(messages: Iterable[Message]) -> None:
    """Warn of messages, at the line that called etalon."""
    # outside the package
    package, depth, frame = str(Path(__file__).parent), 2, sys._getframe(1)
    while frame is not None and frame.f_code.co_filename.startswith(package):
        depth, frame = depth + 1, frame.f_back  # type: ignore[assignment]
    for message in messages:
        warnings.warn(_warning(message), stacklevel=depth)


def with_warnings(document: Any, *, in_campaign: bool = False) -> Any:
    """Warn of the messages of a document, and return it."""
    warn(messages_of(document._members, in_campaign=in_campaign))
    return document


def messages_of(members: dict[str, Any], *, in_campaign: bool = False) -> list[Message]:
    """Return the messages of a document. Without a place they speak of the table in memory, if the document is of one."""
    inputs = (members.get("provenance") or {}).get("inputs") or {}
    in_memory = any(name in TABLES for name in inputs)
    return [Message(message, in_campaign=in_campaign, in_memory=in_memory) for message in members.get("messages") or []]


#: Texts of remedies for a column with another heading, with the name of the column if it is no argument.
_HEADING = {
    "state-column": None,
    "state-column-in-unit": None,
    "state-column-or-pose": "pose",
    "state-column-or-target": "target",
    "state-column-or-cycle": "cycle",
}


def _together(messages: Iterable[Message]) -> str:
    """Return the remedy for several columns with other headings as one keyword argument."""
    headings: dict[str, str] = {}
    for message in messages:
        remedy = message.arguments.get("hint")
        if message.id == "column-unknown" and isinstance(remedy, dict) and remedy.get("id") in _HEADING:
            stated = remedy.get("arguments", {})
            heading = stated.get("heading")
            if heading not in (None, "HEADING"):
                headings[_HEADING[remedy["id"]] or stated["column"]] = heading
    return f"\n\nhint: together: columns={json.dumps(headings, ensure_ascii=False)}" if len(headings) > 1 else ""


#: Names of tables in memory, which have rows instead of lines.
TABLES = frozenset({"observations", "candidates", "sweeps", "readings", "attained", "commanded", "reference", "recording", "path", "positions"})
#: Lines in a sentence, and the lines of a table that a text shows.
_LINES = re.compile(r"\bline(s?) (\d+(?:, \d+)*(?: and \d+(?!\d| more))?)")
_SHOWN = re.compile(rf"^( *)--> ({'|'.join(sorted(TABLES))}):(\d+)(.*\n(?: +\|\n)?)(\d+)( \|)", re.MULTILINE)


def row_words(text: str) -> str:
    """Return a text about a table in memory, whose header is line 1, with rows counted from 1."""

    def row(line: str) -> str:
        return str(int(line) - 1)

    def shown(found: re.Match[str]) -> str:
        space, table, line, between, same, bar = found.groups()
        place, number = (f"{table}, row {row(line)}", row(line)) if line != "1" else (f"{table}, headings", "")
        between = re.sub(r"^:\d+", "", between)
        return f"{space}--> {place}{between}{number:{len(same)}}{bar}" if line == same else found[0]

    text = _LINES.sub(lambda found: f"row{found[1]} " + re.sub(r"\d+", lambda line: row(line[0]), found[2]), text)
    return _SHOWN.sub(shown, text)


class Error(ValueError):
    """What is wrong with the input. ``str()`` gives the text of all messages with their places and hints.

    Attributes:
        messages: All messages; warnings that may explain the error come before it.
    """

    def __init__(self, text: str, messages: str = "[]", in_campaign: bool = False) -> None:
        self._stated = (text, messages, in_campaign)
        self.messages: tuple[Message, ...] = tuple(Message(stated, in_campaign=in_campaign) for stated in json.loads(messages))
        if in_campaign:
            super().__init__(campaign_words(text))
            return
        places = [message.place for message in self.messages if message.place]
        in_memory = bool(places) and all(place.get("file") in TABLES for place in places)
        super().__init__(python_words(row_words(text) if in_memory else text) + _together(self.messages))

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), self._stated)

    def for_campaign(self) -> Error:
        """Return the error with hints in the keys of campaign.toml."""
        return Error(self._stated[0], self._stated[1], True)

    def with_hint(self, id: str, hint: str) -> Error:
        """Return the error with another hint of the messages with an id."""
        text, stated, in_campaign = self._stated
        messages = json.loads(stated)
        for message in messages:
            if message.get("id") == id:
                text = text.replace(f"hint: {message.get('hint')}", f"hint: {hint}")
                message["hint"] = hint
        return Error(text, json.dumps(messages), in_campaign)

    def _first(self) -> Message | None:
        errors = [message for message in self.messages if message.severity == "error"]
        return next(iter(errors or self.messages), None)

    @property
    def message(self) -> str:
        """What the first error says."""
        first = self._first()
        return first.what if first else str(self)

    @property
    def hint(self) -> str | None:
        """What to do about the first error, or None."""
        first = self._first()
        return first.hint if first else None

    @property
    def id(self) -> str | None:
        """Id of the first error, or None."""
        first = self._first()
        return first.id if first else None

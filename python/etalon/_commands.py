"""Any command of the program in this process."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from contextlib import ExitStack
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from . import _etalon
from ._errors import Error, Message
from ._options import options_of
from ._robot import Robot
from .documents import Document, load


class Answer:
    """Answer of a command.

    Attributes:
        met: False if a stated limit is not met, or the result is implausible (exit code 1).
        document: Document of ``--json``, or None for a command that has none.
        text: What the command prints.
        messages: Warnings.
    """

    def __init__(self, met: bool, text: str, document: Document | None, messages: tuple[Message, ...]) -> None:
        self.met = met
        self.text = text
        self.document = document
        self.messages = messages

    def __repr__(self) -> str:
        return f"Answer(met={self.met}, document={self.document!r})"

    def _repr_html_(self) -> str:
        verdict = "" if self.met else "<p>a limit is not met, or the result is implausible</p>"
        return verdict + (self.document._repr_html_() if self.document is not None else "")


def command(*words: str | os.PathLike[str] | Document | Robot, **options: Any) -> Answer:
    """Run a command of the program in this process, with ``--json`` where the command has it.

    ``command("export", "out/parameters.json", format=["csv", "twincat"], to="cell")`` is
    ``etalon export out/parameters.json --format csv --format twincat --to cell --json``.

    ``command("export", found, robot=robot, format="csv", to="cell")`` takes the answer of :func:`etalon.identify` and a :class:`etalon.Robot`
    instead of files.

    Args:
        words: The command and its arguments: texts, paths, documents and robots.
        options: Options by name: True is a flag, a list repeats the option, None is left out; a dictionary states options of the form
            ``NAME=VALUE``: ``column={"q1_deg": "J1"}``.

    Raises:
        Error: The command could not run (exit code 2); for ``check``, the document says why.
    """
    # the word of hints and of the functions on tables
    if isinstance(options.get("columns"), Mapping):
        options["column"] = options.pop("columns")
    # commands read a robot.toml
    robot = options.get("robot")
    if isinstance(robot, (str, os.PathLike)) and os.fspath(robot).endswith(".urdf"):
        options["robot"] = Robot(robot)
    with ExitStack() as files:
        names = [_word(_written(word, files)) for word in words]
        options = {name: _written(value, files) for name, value in options.items()}
        code, text, said, stated = _etalon.command(names + options_of(**options))
    # the help of a command, and a text that is no document, stay texts
    try:
        answer = json.loads(text) if text.lstrip().startswith("{") else None
    except ValueError:
        answer = None
    document = load(text) if answer is not None else None
    if code == 2 and document is None:
        # the options of a shell are no help here
        raise Error(said.partition("\n\nUsage: ")[0].strip(), stated)
    messages = tuple(Message(message) for message in json.loads(stated))
    return Answer(code == 0, text, document, messages)


def _word(word: Any) -> str:
    """Return a word of a command line."""
    if not isinstance(word, (str, os.PathLike)):
        raise Error(f"`words` contains a value of type {type(word).__name__}: expected texts, paths, documents and robots; options are keyword arguments")
    return os.fspath(word)


def _written(value: Any, files: ExitStack) -> Any:
    """Return the path of a document or of a robot that is written for one command; other values as they are."""
    if not isinstance(value, (Document, Robot)):
        return value
    folder = Path(files.enter_context(TemporaryDirectory(prefix="etalon-")))
    if isinstance(value, Robot):
        return value._write(folder)
    path = folder / f"{value.get('schema', 'etalon/document/1').split('/')[1]}.json"
    path.write_text(value.to_json(), encoding="utf-8")
    return path

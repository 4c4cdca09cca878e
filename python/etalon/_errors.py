"""Errors of etalon."""

from __future__ import annotations

import json
import warnings
from typing import Any


class Message:
    """One error or warning.

    Attributes:
        severity: ``"error"`` or ``"warning"``.
        what: What is wrong, in one sentence.
        expected: What was expected there, or None.
        hint: What to do, or None.
        place: File, line and column as a dictionary, or None.
        id: Id of the message (``etalon explain ID``), or None.
        arguments: Arguments of the message by name.
    """

    def __init__(self, stated: dict[str, Any]) -> None:
        self.severity: str = stated.get("severity", "error")
        self.what: str = stated.get("what") or stated.get("text", "")
        self.expected: str | None = stated.get("expected")
        self.hint: str | None = stated.get("hint")
        self.place: dict[str, Any] | None = stated.get("place")
        self.id: str | None = stated.get("id")
        self.arguments: dict[str, Any] = stated.get("arguments", {})

    def __repr__(self) -> str:
        return f"Message({self.severity}: {self.what})"


class ImplausibleWarning(UserWarning):
    """The result can be that of no such robot; its messages of severity ``error`` say why. The program ends with exit code 1."""


def warn_if_implausible(document: Any) -> Any:
    """Warn if a document has messages of severity ``error``, and return the document."""
    stated = [Message(message) for message in document.to_dict().get("messages", [])]
    wrong = [message for message in stated if message.severity == "error"]
    if wrong:
        text = "\n".join(f"{message.id}: {message.what}" + (f"\nhint: {message.hint}" if message.hint else "") for message in wrong)
        warnings.warn(text, ImplausibleWarning, stacklevel=3)
    return document


class Error(ValueError):
    """What is wrong with the input. ``str()`` gives the text of all messages with their places and hints.

    Attributes:
        messages: All messages.
    """

    def __init__(self, text: str, messages: str = "[]") -> None:
        super().__init__(text)
        self._json = messages
        self.messages: tuple[Message, ...] = tuple(Message(stated) for stated in json.loads(messages))

    def __reduce__(self):
        return (type(self), (str(self), self._json))

    @property
    def message(self) -> str:
        """What the first error says."""
        return self.messages[0].what if self.messages else str(self)

    @property
    def hint(self) -> str | None:
        """What to do about the first error, or None."""
        return self.messages[0].hint if self.messages else None

    @property
    def id(self) -> str | None:
        """Id of the first error, or None."""
        return self.messages[0].id if self.messages else None

"""Keyword arguments as options of a command line."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping
from typing import Any

from ._errors import Error

#: Function that is called with what is done and the whole.
Progress = Callable[[int, int], Any]


def called(progress: Progress | None) -> Progress | None:
    """Return a function that is called with the progress of a computation."""
    if progress is not None and not callable(progress):
        raise Error(f"`progress` is of type {type(progress).__name__}: expected a function of what is done and the whole")
    return progress


def whole(value: Any, name: str) -> int:
    """Return a whole number, which may be one of NumPy."""
    try:
        return operator.index(value)
    except TypeError:
        raise Error(f"`{name}` is of type {type(value).__name__}: expected a whole number") from None


def options_of(**stated: Any) -> list[str]:
    """Return options: None is left out, True is a flag, a list repeats the option, a dictionary repeats it with ``NAME=VALUE``."""
    words: list[str] = []
    for name, value in stated.items():
        option = "--" + name.replace("_", "-")
        if value is None or value is False:
            continue
        if value is True:
            words.append(option)
        elif isinstance(value, Mapping):
            words.extend(f"{option}={key}={item}" for key, item in value.items())
        else:
            for item in value if isinstance(value, (list, tuple)) else [value]:
                words.append(f"{option}={item}")
    return words

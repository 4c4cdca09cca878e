"""Numbers of callers as arrays."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import Error


def refuse_masked(values: Any, name: str, remedy: str = "leave their rows out, or fill them") -> None:
    """Refuse masked values, whose numbers an array without a mask would have."""
    parts = values if isinstance(values, (list, tuple)) else [values]
    if any(isinstance(part, np.ma.MaskedArray) and np.ma.is_masked(part) for part in parts):
        raise Error(f"`{name}` has masked values: {remedy}")


def numbers(values: ArrayLike | None, name: str, masked: str = "leave their rows out, or fill them") -> NDArray[np.float64]:
    """Return an array of numbers in C order: the same array where it is one already. Masked values are refused."""
    refuse_masked(values, name, masked)
    if values is None:
        raise Error(f"`{name}` is None: expected numbers")
    try:
        return np.ascontiguousarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise Error(f"`{name}`: expected numbers: {error}") from error

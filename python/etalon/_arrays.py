"""Numbers of callers as arrays."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._errors import Error


def refuse_masked(values: Any, name: str, remedy: str = "leave their rows out, or fill them") -> None:
    """Refuse masked values, whose numbers an array without a mask would have."""
    parts = values if isinstance(values, (list, tuple)) else [values]
    if any(isinstance(part, np.ma.MaskedArray) and np.ma.is_masked(part) for part in parts):
        raise Error(f"`{name}` has masked values: {remedy}")

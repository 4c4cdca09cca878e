"""Errors of readings as a table."""

from __future__ import annotations

import json
from typing import Any

from .documents import Record, Records


class Residuals:
    """Errors of the readings of a result, as a table and as a drawing."""

    __slots__ = ()

    def _residual_columns(self) -> str:
        """Return names and values of the columns as JSON text."""
        raise NotImplementedError

    def residuals_table(self) -> Records[Record]:
        """Return the error of each reading, measured minus predicted, as a table with ``to_pandas()``, ``to_polars()`` and ``to_arrow()``.

        Columns are ``set`` (``calibration``, ``validation`` ...), ``pose``, ``cycle``, ``target``, ``quantity``, the measured position
        (``x_mm`` ...), the errors with nominal parameters (``before_x_mm`` ..., ``before_deg``) and with identified ones (``after_x_mm`` ...,
        ``after_deg``), the joint values (``q1_deg`` ...), and redundancy, w and smallest detectable error of the reading where they are computed.
        """
        columns = json.loads(self._residual_columns())
        names = [name for name, _ in columns]
        return Records([Record(dict(zip(names, row))) for row in zip(*(values for _, values in columns))])

    def plot(self, *, axes: Any = None) -> Any:
        """Draw position errors before and after with matplotlib, which ``pip install etalon-robot[plot]`` installs; returns the axes."""
        from ._plots import errors_of_readings

        return errors_of_readings(self.residuals_table(), axes)

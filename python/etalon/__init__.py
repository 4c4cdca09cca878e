"""Robot calibration from coordinate measurements.

Lengths are in millimetres and angles in degrees; names carry their unit. Points are arrays ``(n, 3)`` of float64. A table
is a path of a CSV file, a dictionary of columns, or any object with the Arrow PyCapsule interface (polars, pandas, pyarrow,
DuckDB); its columns are those of the documentation. Answers are documents (:class:`etalon.Document`): attributes, ``to_dict()``,
tables in notebooks. What is wrong with the input is raised as :class:`etalon.Error`. Long computations release the GIL.
"""

from . import documents, fit, frames, kinematics
from ._campaigns import Run, batch, check, recommend, run, uncertainty, validate
from ._commands import Answer, command
from ._errors import Error, ImplausibleWarning, Message
from ._etalon import VERSION as __version__
from ._robot import Robot, robots
from ._tasks import axes, cell, identify, iso230, iso9283, iso9283_path, plan, verify
from .documents import Document

__all__ = [
    "Answer",
    "Document",
    "Error",
    "ImplausibleWarning",
    "Message",
    "Robot",
    "Run",
    "__version__",
    "axes",
    "batch",
    "cell",
    "check",
    "command",
    "documents",
    "fit",
    "frames",
    "identify",
    "iso230",
    "iso9283",
    "iso9283_path",
    "kinematics",
    "plan",
    "recommend",
    "robots",
    "run",
    "uncertainty",
    "validate",
    "verify",
]

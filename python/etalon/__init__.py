"""Robot calibration from coordinate measurements.

Lengths are in millimetres and angles in degrees; names carry their unit. Points are arrays ``(n, 3)`` of float64. A table
is a path of a CSV file, a dictionary of columns, a DataFrame of pandas, or any object with the Arrow PyCapsule interface (polars, pyarrow,
DuckDB); its columns are those of the documentation. Answers are documents (:class:`etalon.Document`): attributes, ``to_dict()``,
tables in notebooks. What is wrong with the input is raised as :class:`etalon.Error`; warnings are Python warnings (:class:`etalon.MessageWarning`)
with a class for each id. Long computations release the GIL, and end at Ctrl-C.
"""

from . import documents, fit, frames, kinematics
from ._campaigns import Run, batch, check, recommend, run, uncertainty, validate
from ._commands import Answer, command
from ._errors import Error, ImplausibleWarning, Message, MessageWarning, warning_class
from ._etalon import VERSION as __version__
from ._robot import Robot, robots
from ._tasks import Identification, axes, cell, identify, iso230, iso9283, iso9283_path, plan, verify
from .documents import Document

__all__ = [
    "Answer",
    "Document",
    "Error",
    "Identification",
    "ImplausibleWarning",
    "Message",
    "MessageWarning",
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
    "warning_class",
]

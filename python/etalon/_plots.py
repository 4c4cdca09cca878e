"""Drawings with matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import numbers
from ._errors import Error

if TYPE_CHECKING:
    from ._robot import Robot
    from .documents import Record, Records


def _axes(axes: Any, **options: Any) -> Any:
    """Return the stated axes, or those of a new figure."""
    if axes is not None:
        if options and not hasattr(axes, "set_zlabel"):
            raise Error('`axes` has two dimensions: expected axes with `projection="3d"`')
        return axes
    try:
        from matplotlib import pyplot
    except ImportError as missing:
        raise Error("drawings need matplotlib: pip install etalon-robot[plot]") from missing
    return pyplot.figure(layout="constrained").add_subplot(**options)


def residuals_of_points(residuals_mm: NDArray[np.float64], axes: Any = None) -> Any:
    """Draw the residuals of points in their order."""
    axes = _axes(axes)
    axes.stem(np.arange(1, len(residuals_mm) + 1), 1000 * residuals_mm, basefmt="k-")
    axes.set_xlabel("point")
    axes.set_ylabel("residual (µm)")
    return axes


def errors_of_readings(table: Records[Record], axes: Any = None) -> Any:
    """Draw position errors of readings before and after identification."""
    axes = _axes(axes)
    columns = table.to_dict()
    for name, marker in (("before", "o"), ("after", "s")):
        vectors = np.array([columns[f"{name}_{axis}_mm"] for axis in "xyz"])
        axes.plot(np.arange(1, len(table) + 1), np.linalg.norm(vectors, axis=0), marker, label=name, markersize=4)
    axes.set_yscale("log")
    axes.set_xlabel("reading")
    axes.set_ylabel("error (mm)")
    axes.legend()
    return axes


def robot_poses(robot: Robot, joints: ArrayLike, parameters: Any = None, axes: Any = None) -> Any:
    """Draw base and flange frames at joint values."""
    from .kinematics import direct

    axes = _axes(axes, projection="3d")
    matrices = direct(robot, np.atleast_2d(numbers(joints, "joints")), parameters=parameters).matrix
    places = matrices[:, :3, 3]
    size = 0.15 * max(1.0, float(np.nanmax(np.linalg.norm(places, axis=1))))
    for matrix in [np.eye(4), *matrices]:
        for axis, colour in enumerate(("tab:red", "tab:green", "tab:blue")):
            start, end = matrix[:3, 3], matrix[:3, 3] + size * matrix[:3, axis]
            axes.plot(*np.column_stack([start, end]), color=colour)
    axes.plot(*places.T, "k.", markersize=3)
    axes.set_xlabel("x (mm)")
    axes.set_ylabel("y (mm)")
    axes.set_zlabel("z (mm)")
    axes.set_aspect("equal")
    return axes

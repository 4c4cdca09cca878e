"""Frames: rigid transforms between sets of points, and frames of three points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _etalon
from ._errors import Error
from ._tasks import cell
from .fit import Fit, points_of
from .kinematics import Poses


@dataclass(frozen=True, eq=False, repr=False)
class Rigid:
    """A rigid transform by least squares.

    Attributes:
        matrix: Homogeneous matrix ``(4, 4)``: ``p_onto = matrix @ p``; lengths in mm.
        residuals_mm: ``(n, 3)``, mm: the points onto which, minus those that were carried.
        centroid_uncertainty_mm: Standard uncertainty (k = 1) of each coordinate of the centroid.
        rotation_uncertainty_deg: Standard uncertainty (k = 1) of the rotation about its most uncertain axis.
    """

    matrix: NDArray[np.float64]
    residuals_mm: NDArray[np.float64]
    centroid_uncertainty_mm: float
    rotation_uncertainty_deg: float

    @property
    def rms_mm(self) -> float:
        """Root mean square of the distances that are left."""
        return float(np.sqrt(np.mean(np.sum(self.residuals_mm**2, axis=1))))

    def __call__(self, points: ArrayLike) -> NDArray[np.float64]:
        """Carry points ``(n, 3)``, or a single point ``(3,)``."""
        carried: NDArray[np.float64] = points_of(np.atleast_2d(points)) @ self.matrix[:3, :3].T + self.matrix[:3, 3]
        return carried[0] if np.ndim(points) == 1 else carried

    def __repr__(self) -> str:
        matrix = np.array2string(self.matrix, precision=6, suppress_small=True, prefix=" " * 13)
        return (
            f"Rigid(matrix={matrix},\n      rms_mm={self.rms_mm:.6g}, centroid_uncertainty_mm={self.centroid_uncertainty_mm:.2g}, "
            f"rotation_uncertainty_deg={self.rotation_uncertainty_deg:.2g})"
        )


def rigid(points: ArrayLike, onto: ArrayLike) -> Rigid:
    """Fit the rigid transform that carries points onto others, row by row (Horn 1987).

    Args:
        points: ``(n, 3)``, mm; at least three, not on one line.
        onto: ``(n, 3)``, mm, in the same order.

    Raises:
        Error: The points do not determine a transform.
    """
    return Rigid(*_etalon.rigid(points_of(points), points_of(onto)))


@dataclass(frozen=True, eq=False, repr=False)
class Frame:
    """A frame in the coordinates of the points that define it. Called with points, it gives their coordinates in the frame.

    Attributes:
        matrix: Homogeneous matrix ``(4, 4)`` of the frame: ``p_measured = matrix @ p_frame``; lengths in mm.
        standard_uncertainty_mm: Standard uncertainties ``(3,)`` of the origin (k = 1), mm; NaN without an uncertainty of the points.
        standard_uncertainty_deg: Standard uncertainties ``(3,)`` of a rotation about the axes of the measured coordinates (k = 1), deg; NaN likewise.
    """

    matrix: NDArray[np.float64]
    standard_uncertainty_mm: NDArray[np.float64]
    standard_uncertainty_deg: NDArray[np.float64]

    def __call__(self, points: ArrayLike) -> NDArray[np.float64]:
        """Return the coordinates of measured points ``(n, 3)``, or of a single point ``(3,)``, in the frame."""
        inside: NDArray[np.float64] = (points_of(np.atleast_2d(points)) - self.matrix[:3, 3]) @ self.matrix[:3, :3]
        return inside[0] if np.ndim(points) == 1 else inside

    def __repr__(self) -> str:
        matrix = np.array2string(self.matrix, precision=6, suppress_small=True, prefix=" " * 13)
        return f"Frame(matrix={matrix},\n      standard_uncertainty_mm={self.standard_uncertainty_mm}, standard_uncertainty_deg={self.standard_uncertainty_deg})"


def three_points(origin: Fit | ArrayLike, x: Fit | ArrayLike, xy: Fit | ArrayLike, *, standard_uncertainty_um: float | None = None) -> Frame:
    """Define a frame by three points: origin, a point on the x axis, and a point in the x-y plane with y > 0.

    Args:
        origin: Point ``(3,)`` in mm, several readings ``(n, 3)`` of it, or a fitted sphere or circle, whose centre is the point.
        x: Point on the positive x axis, likewise.
        xy: Point in the x-y plane, likewise.
        standard_uncertainty_um: Of one coordinate of a point (k = 1), um. If None, from the scatter of several readings. Of three fitted
            elements, the largest uncertainty of a centre.

    Raises:
        Error: The points are on one line.

    Warns:
        MessageWarning: Messages of ``etalon cell`` with ``three-points``, by id.
    """
    readings = {name: _readings(point, name) for name, point in (("origin", origin), ("x", x), ("xy", xy))}
    known = [point.standard_uncertainty.point_mm for point in (origin, x, xy) if isinstance(point, Fit)]
    if standard_uncertainty_um is None and len(known) == 3 and np.all(np.isfinite(known)):
        # the most uncertain direction of the most uncertain centre
        standard_uncertainty_um = 1000.0 * max(known)
    stacked = np.vstack(list(readings.values()))
    table = {"point": [name for name, rows in readings.items() for _ in rows]}
    found = cell(table | {f"{axis}_mm": stacked[:, k] for k, axis in enumerate("xyz")}, "three-points", standard_uncertainty_um=standard_uncertainty_um)
    frame = found.frames[0]
    unknown = np.full(3, np.nan)
    uncertainties = [unknown if u is None else np.asarray(u) for u in (frame.standard_uncertainty_mm, frame.standard_uncertainty_deg)]
    return Frame(Poses(np.asarray(frame.xyz_mm), np.asarray(frame.quaternion)).matrix, *uncertainties)


def _readings(point: Any, name: str) -> NDArray[np.float64]:
    """Return a point as rows of readings."""
    if isinstance(point, Fit):
        centre = point.get("center_mm")
        if centre is None:
            raise Error(f"`{name}`: a {point.element} has no centre: expected a point, a sphere or a circle")
        point = centre
    return points_of(np.atleast_2d(point))

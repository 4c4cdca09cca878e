"""Frames: rigid transforms between sets of points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _etalon
from .fit import points_of


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

"""Geometric elements fitted to points by least squares or minimum zone.

Points are arrays ``(n, 3)`` of float64 in mm; an array in C order is read where it is, without a copy. ``(n, 2)`` is in the plane z = 0.
A fit is a :class:`Fit`: ``.center_mm``, ``.point_mm``, ``.normal``, ``.axis`` and ``.radius_mm`` as the element has them,
``.rms_mm``, ``.form_mm``, ``.standard_uncertainty`` (k = 1), ``.residuals_mm``.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _etalon
from ._errors import Error
from .documents import FitDocument, load  # type: ignore[attr-defined]


class Fit(FitDocument):
    """A fitted element: the document, and the residuals, which a minimum zone does not have."""

    __slots__ = ("_given", "_residuals")

    def __init__(
        self, members: dict[str, Any], residuals_mm: NDArray[np.float64] | None = None, given: tuple[Any, Any] | None = None
    ) -> None:
        super().__init__(members)
        object.__setattr__(self, "_residuals", residuals_mm)
        object.__setattr__(self, "_given", given)

    @property
    def residuals_mm(self) -> NDArray[np.float64] | None:
        """Signed orthogonal distances of the points, ``(n,)``, mm, computed from the array of points as it is at the first call; unsigned for
        a line and for a circle by orthogonal distances."""
        if self._residuals is None and self._given is not None:
            fitted, points = self._given
            object.__setattr__(self, "_residuals", fitted.residuals(points))
            object.__setattr__(self, "_given", None)
        return self._residuals

    def __reduce__(self):
        return (Fit, (self._members, self.residuals_mm))


def points_of(points: ArrayLike) -> NDArray[np.float64]:
    """Return points as an array ``(n, 3)``, float64, C order: the same array where it is one already."""
    array = np.ascontiguousarray(points, dtype=np.float64)
    if array.ndim == 2 and array.shape[1] == 2:
        array = np.column_stack([array, np.zeros(len(array))])
    if array.ndim != 2 or array.shape[1] != 3:
        raise Error(f"points have the shape {array.shape}: expected (n, 3)")
    return array


def element(
    name: str,
    points: ArrayLike,
    *,
    weights: ArrayLike | None = None,
    radius_mm: float | None = None,
    axis: ArrayLike | None = None,
    orthogonal: bool = False,
    probe_radius_mm: float | None = None,
    probe_side: str | ArrayLike | None = None,
    minimum_zone: bool = False,
) -> Fit:
    """Fit an element.

    Args:
        name: ``line``, ``line2d``, ``plane``, ``circle2d``, ``circle3d``, ``sphere``, ``cylinder``, ``cone`` or ``torus``.
        points: ``(n, 3)``, mm.
        weights: ``(n,)``, in inverse proportion to the variances of the points.
        radius_mm: Holds the radius of a circle, sphere or cylinder.
        axis: Holds the direction ``(3,)``: normal of a plane or circle, axis of a line, cylinder or cone.
        orthogonal: Fits a circle in space by the full orthogonal distance instead of plane, projection, circle.
        probe_radius_mm: The points are centres of a probe of this radius; the answer is what it touched.
        probe_side: ``"inside"``, ``"outside"``, or for a plane or line the direction ``(3,)`` to the probe.
        minimum_zone: Fits by minimum zone (Chebyshev): the form of ISO 1101.

    Returns:
        The element. Lengths in mm, angles in deg, uncertainties with k = 1.

    Raises:
        Error: The points do not determine the element, or an option does not apply to it.
    """
    side = probe_side if probe_side is None or isinstance(probe_side, str) else [float(v) for v in np.ravel(probe_side)]
    options = {
        "weights": None if weights is None else np.ascontiguousarray(weights, dtype=np.float64),
        "radius_mm": radius_mm,
        "axis": None if axis is None else [float(v) for v in np.ravel(axis)],
        "orthogonal": orthogonal,
        "probe_radius_mm": probe_radius_mm,
        "probe_side": side,
        "minimum_zone": minimum_zone,
    }
    array = points_of(points)
    text, fitted = _etalon.fit(name, array, options)
    return Fit(load(text)._members, given=None if fitted is None else (fitted, array))


def line(points: ArrayLike, **options: Any) -> Fit:
    """Fit a line in space: ``.point_mm``, ``.axis``. Options are those of :func:`element`."""
    return element("line", points, **options)


def line2d(points: ArrayLike, **options: Any) -> Fit:
    """Fit a line in the plane z = 0. Options are those of :func:`element`."""
    return element("line2d", points, **options)


def plane(points: ArrayLike, **options: Any) -> Fit:
    """Fit a plane: ``.point_mm``, ``.normal``. Options are those of :func:`element`."""
    return element("plane", points, **options)


def circle(points: ArrayLike, **options: Any) -> Fit:
    """Fit a circle in space: ``.center_mm``, ``.normal``, ``.radius_mm``. Options are those of :func:`element`."""
    return element("circle3d", points, **options)


def circle2d(points: ArrayLike, **options: Any) -> Fit:
    """Fit a circle in the plane z = 0. Options are those of :func:`element`."""
    return element("circle2d", points, **options)


def sphere(points: ArrayLike, **options: Any) -> Fit:
    """Fit a sphere: ``.center_mm``, ``.radius_mm``. Options are those of :func:`element`."""
    return element("sphere", points, **options)


def cylinder(points: ArrayLike, **options: Any) -> Fit:
    """Fit a cylinder: ``.point_mm``, ``.axis``, ``.radius_mm``. Options are those of :func:`element`."""
    return element("cylinder", points, **options)


def cone(points: ArrayLike, **options: Any) -> Fit:
    """Fit a cone: ``.apex_mm``, ``.axis``, ``.apex_angle_deg``. Options are those of :func:`element`."""
    return element("cone", points, **options)


def torus(points: ArrayLike, **options: Any) -> Fit:
    """Fit a torus: ``.center_mm``, ``.normal``, ``.radius_mm``, ``.minor_radius_mm``. Options are those of :func:`element`."""
    return element("torus", points, **options)


def enclosing_circle(points: ArrayLike) -> Fit:
    """Return the smallest circle that encloses the points in the plane z = 0."""
    return Fit(load(_etalon.enclosing(False, points_of(points)))._members)


def enclosing_sphere(points: ArrayLike) -> Fit:
    """Return the smallest sphere that encloses the points."""
    return Fit(load(_etalon.enclosing(True, points_of(points)))._members)

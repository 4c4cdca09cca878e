"""Geometric elements fitted to points by least squares or minimum zone.

Points are arrays ``(n, 3)`` of float64 in mm; an array in C order is read where it is, without a copy. ``(n, 2)`` is in the plane z = 0.
Each element has its class: :class:`Line`, :class:`Plane`, :class:`Circle`, :class:`Sphere`, :class:`Cylinder`, :class:`Cone`, :class:`Torus`.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _etalon
from ._arrays import numbers, refuse_masked
from ._errors import Error, with_warnings
from .documents import Document, FitContacts, FitProbe, FitSolver, Message, Records, load

_Vector = NDArray[np.float64]
#: Side of the surface on which the probe was, or the direction to it.
ProbeSide = Literal["inside", "outside"] | ArrayLike
ElementName = Literal["line", "line2d", "plane", "circle2d", "circle3d", "sphere", "cylinder", "cone", "torus"]


@dataclass(frozen=True)
class Uncertainty:
    """Standard uncertainties (k = 1) of an element, from its residuals or from the stated uncertainty of the points; NaN without redundancy, by
    minimum zone, and for what the element lacks.

    Attributes:
        point_mm: Of the point or centre in its most uncertain direction, mm.
        direction_deg: Of the normal or axis about its most uncertain direction, deg.
        radius_mm: Of the radius, mm.
        minor_radius_mm: Of the radius of the tube of a torus, mm.
        apex_angle_deg: Of the full angle of a cone, deg.
        coverage_factor: Factor of the expanded uncertainties (95 %): Student's t with the degrees of freedom, 14 for one and 2.3 for ten; 2 for a
            stated uncertainty of the points.
    """

    point_mm: float = float("nan")
    direction_deg: float = float("nan")
    radius_mm: float = float("nan")
    minor_radius_mm: float = float("nan")
    apex_angle_deg: float = float("nan")
    coverage_factor: float = float("nan")


class Fit(Document):
    """A fitted element: the document of ``etalon fit``, and the residuals.

    Attributes:
        element: Name of the element.
        points: Number of points.
        rms_mm: Root mean square of the orthogonal distances, mm.
        max_mm: Largest of these distances, mm.
        form_mm: Form deviation, peak to valley, mm.
        coverage_deg: Arc of the circumference that is covered by points, deg.
        solver: Solver and its termination.
        messages: Warnings with hints.
    """

    __slots__ = ("_residuals",)
    _schema_class = "FitDocument"

    element: str
    points: int
    rms_mm: float
    max_mm: float
    form_mm: float
    coverage_deg: float | None
    contacts: FitContacts | None
    probe: FitProbe | None
    solver: FitSolver
    messages: Records[Message]

    def __init__(self, members: dict[str, Any], residuals_mm: _Vector | None = None) -> None:
        super().__init__(members)
        object.__setattr__(self, "_residuals", residuals_mm)

    @property
    def residuals_mm(self) -> _Vector:
        """Signed orthogonal distances of the points, ``(n,)``, mm; unsigned for a line and for a circle by orthogonal distances. NaN of a minimum
        zone and of an enclosing circle or sphere."""
        residuals = cast("_Vector | None", object.__getattribute__(self, "_residuals"))
        return np.full(self.points, np.nan) if residuals is None else residuals

    @property
    def is_set_aside(self) -> NDArray[np.bool_]:
        """Points that a robust fit leaves out, ``(n,)``."""
        marks = np.zeros(self.points, dtype=bool)
        # the document counts points from 1
        marks[np.array(self._members.get("set_aside") or [], dtype=int) - 1] = True
        return marks

    @property
    def standard_uncertainty(self) -> Uncertainty:
        """Standard uncertainties (k = 1)."""
        stated = self._members.get("standard_uncertainty") or {}
        return Uncertainty(**{name: value for name, value in stated.items() if value is not None})

    @property
    def expanded_uncertainty(self) -> Uncertainty:
        """Expanded uncertainties (95 %): standard uncertainties times ``coverage_factor``, which is large for a few points."""
        u = self.standard_uncertainty
        k = u.coverage_factor
        return Uncertainty(k * u.point_mm, k * u.direction_deg, k * u.radius_mm, k * u.minor_radius_mm, k * u.apex_angle_deg, k)

    def plot(self, *, axes: Any = None) -> Any:
        """Draw the residuals with matplotlib, which ``pip install etalon-robot[plot]`` installs; returns the axes."""
        from ._plots import residuals_of_points

        return residuals_of_points(self.residuals_mm, axes)

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (self._members, object.__getattribute__(self, "_residuals")))


class Line(Fit):
    """A line: a point ``point_mm`` and the unit vector ``axis``."""

    point_mm: _Vector
    axis: _Vector


class Plane(Fit):
    """A plane: a point ``point_mm`` and the unit vector ``normal``."""

    point_mm: _Vector
    normal: _Vector


class Circle(Fit):
    """A circle: ``center_mm``, the unit vector ``normal`` and ``radius_mm``. A circle in the plane z = 0 has the normal (0, 0, 1)."""

    center_mm: _Vector
    radius_mm: float

    @property
    def normal(self) -> _Vector:
        """Unit normal."""
        return np.array(self._members.get("normal") or [0.0, 0.0, 1.0])


class Sphere(Fit):
    """A sphere: ``center_mm`` and ``radius_mm``."""

    center_mm: _Vector
    radius_mm: float


class Cylinder(Fit):
    """A cylinder: a point ``point_mm`` of the axis, its unit vector ``axis``, and ``radius_mm``."""

    point_mm: _Vector
    axis: _Vector
    radius_mm: float


class Cone(Fit):
    """A cone: ``apex_mm``, the unit vector ``axis`` towards the increasing radius, the full angle ``apex_angle_deg``, and ``radius_mm`` at the
    point ``point_mm`` of the axis."""

    apex_mm: _Vector
    axis: _Vector
    apex_angle_deg: float
    point_mm: _Vector
    radius_mm: float


class Torus(Fit):
    """A torus: ``center_mm``, the unit vector ``normal``, ``radius_mm`` of the centre line and ``minor_radius_mm`` of the tube."""

    center_mm: _Vector
    normal: _Vector
    radius_mm: float
    minor_radius_mm: float


_CLASSES: dict[str, type[Fit]] = {
    "line": Line,
    "line2d": Line,
    "plane": Plane,
    "circle2d": Circle,
    "circle3d": Circle,
    "sphere": Sphere,
    "cylinder": Cylinder,
    "cone": Cone,
    "torus": Torus,
}
_Fitted = TypeVar("_Fitted", bound=Fit)
_Function = TypeVar("_Function", bound=Callable[..., Any])


def points_of(points: ArrayLike) -> NDArray[np.float64]:
    """Return points as an array ``(n, 3)``, float64, C order: the same array where it is one already. Masked points are refused."""
    array = numbers(points, "points", "leave these points out (`points[~points.mask.any(axis=1)]`)")
    if array.ndim == 2 and array.shape[1] == 2:
        array = np.column_stack([array, np.zeros(len(array))])
    if array.ndim != 2 or array.shape[1] != 3:
        raise Error(f"`points` has the shape {array.shape}: expected (n, 3)")
    return array


def element(
    name: ElementName,
    points: ArrayLike,
    *,
    weights: ArrayLike | None = None,
    radius_mm: float | None = None,
    axis: ArrayLike | None = None,
    orthogonal: bool = False,
    standard_uncertainty_um: float | None = None,
    probe_radius_mm: float | None = None,
    probe_side: ProbeSide | None = None,
    minimum_zone: bool = False,
    robust: bool = False,
) -> Fit:
    """Fit an element.

    Args:
        name: ``line``, ``line2d``, ``plane``, ``circle2d``, ``circle3d``, ``sphere``, ``cylinder``, ``cone`` or ``torus``.
        points: ``(n, 3)``, mm.
        weights: ``(n,)``, in inverse proportion to the variances of the points.
        radius_mm: Holds the radius of a circle, sphere or cylinder.
        axis: Holds the direction ``(3,)``: normal of a plane or circle, axis of a line, cylinder or cone.
        orthogonal: Fits a circle in space by the full orthogonal distance instead of plane, projection, circle.
        standard_uncertainty_um: Of one point (k = 1), um: of a touch, from the certificate of the machine; from the residuals if None.
        probe_radius_mm: The points are centres of a probe of this radius; the answer is what it touched.
        probe_side: ``"inside"``, ``"outside"``, or for a plane or line the direction ``(3,)`` to the probe.
        minimum_zone: Fits by minimum zone (Chebyshev): the form of ISO 1101.
        robust: Leaves points out that are far from the element of all others (trimmed least squares); ``is_set_aside`` marks them.

    Returns:
        The element, of its class. Lengths in mm, angles in deg, uncertainties with k = 1.

    Raises:
        Error: The points do not determine the element, or an option does not apply to it.

    Warns:
        MessageWarning: Messages of the fit, by id.
    """
    return _fitted(
        _CLASSES.get(name, Fit),
        name,
        points,
        weights=weights,
        radius_mm=radius_mm,
        axis=axis,
        orthogonal=orthogonal,
        standard_uncertainty_um=standard_uncertainty_um,
        probe_radius_mm=probe_radius_mm,
        probe_side=probe_side,
        minimum_zone=minimum_zone,
        robust=robust,
    )


def _fitted(kind: type[_Fitted], name: str, points: ArrayLike, **options: Any) -> _Fitted:
    """Fit an element of a class; an option that is None is not stated."""
    array = points_of(points)
    stated: dict[str, Any] = dict.fromkeys(["weights", "radius_mm", "axis", "probe_radius_mm", "probe_side", "standard_uncertainty_mm"])
    stated |= {"minimum_zone": False, "orthogonal": False, "robust": False}
    besides = [option for option, value in options.items() if value is not None and value is not False and option != "minimum_zone"]
    if options["minimum_zone"] and besides:
        raise Error(f"`minimum_zone` takes no other option: leave {', '.join(f'`{option}`' for option in besides)} out")
    uncertainty_um = _number(options.pop("standard_uncertainty_um", None), "standard_uncertainty_um")
    if uncertainty_um is not None:
        stated["standard_uncertainty_mm"] = uncertainty_um / 1000.0
    for option, value in options.items():
        if value is None or isinstance(value, bool) or (option == "probe_side" and isinstance(value, str)):
            stated[option] = value
        else:
            stated[option] = _number(value, option) if option.endswith("_mm") else np.ravel(numbers(value, option)).tolist()
    if stated["weights"] is not None:
        stated["weights"] = np.array(stated["weights"])
        if len(stated["weights"]) != len(array):
            raise Error(f"`weights` has {len(stated['weights'])} values: expected one for each of the {len(array)} points")
    text, fitted = _etalon.fit(name, array, stated)
    found = kind(load(text)._members, None if fitted is None else fitted.residuals(array))
    with_warnings(found)
    return found


def _documented(function: _Function) -> _Function:
    """Add what the docstring of :func:`element` says of the arguments of a function."""
    summary, _, rest = (element.__doc__ or "").partition("    Args:\n")
    arguments, _, others = rest.partition("\n\n")
    shared = [line for line in arguments.splitlines() if line.split(":")[0].strip() in inspect.signature(function).parameters]
    function.__doc__ = "\n".join([f"{function.__doc__}\n", "    Args:", *shared, "", others])
    return function


@_documented
def line(
    points: ArrayLike,
    *,
    weights: ArrayLike | None = None,
    axis: ArrayLike | None = None,
    standard_uncertainty_um: float | None = None,
    probe_radius_mm: float | None = None,
    probe_side: ProbeSide | None = None,
    minimum_zone: bool = False,
    robust: bool = False,
) -> Line:
    """Fit a line in space."""
    return _fitted(Line, "line", points, weights=weights, axis=axis, standard_uncertainty_um=standard_uncertainty_um, probe_radius_mm=probe_radius_mm, probe_side=probe_side, minimum_zone=minimum_zone, robust=robust)


@_documented
def line2d(
    points: ArrayLike,
    *,
    weights: ArrayLike | None = None,
    axis: ArrayLike | None = None,
    standard_uncertainty_um: float | None = None,
    probe_radius_mm: float | None = None,
    probe_side: ProbeSide | None = None,
    minimum_zone: bool = False,
    robust: bool = False,
) -> Line:
    """Fit a line in the plane z = 0."""
    return _fitted(Line, "line2d", points, weights=weights, axis=axis, standard_uncertainty_um=standard_uncertainty_um, probe_radius_mm=probe_radius_mm, probe_side=probe_side, minimum_zone=minimum_zone, robust=robust)


@_documented
def plane(
    points: ArrayLike,
    *,
    weights: ArrayLike | None = None,
    axis: ArrayLike | None = None,
    standard_uncertainty_um: float | None = None,
    probe_radius_mm: float | None = None,
    probe_side: ProbeSide | None = None,
    minimum_zone: bool = False,
    robust: bool = False,
) -> Plane:
    """Fit a plane."""
    return _fitted(Plane, "plane", points, weights=weights, axis=axis, standard_uncertainty_um=standard_uncertainty_um, probe_radius_mm=probe_radius_mm, probe_side=probe_side, minimum_zone=minimum_zone, robust=robust)


@_documented
def circle(
    points: ArrayLike,
    *,
    weights: ArrayLike | None = None,
    radius_mm: float | None = None,
    axis: ArrayLike | None = None,
    orthogonal: bool = False,
    standard_uncertainty_um: float | None = None,
    probe_radius_mm: float | None = None,
    probe_side: ProbeSide | None = None,
    minimum_zone: bool = False,
    robust: bool = False,
) -> Circle:
    """Fit a circle in space."""
    return _fitted(Circle, "circle3d", points, weights=weights, radius_mm=radius_mm, axis=axis, orthogonal=orthogonal, standard_uncertainty_um=standard_uncertainty_um, probe_radius_mm=probe_radius_mm, probe_side=probe_side, minimum_zone=minimum_zone, robust=robust)


@_documented
def circle2d(
    points: ArrayLike,
    *,
    weights: ArrayLike | None = None,
    radius_mm: float | None = None,
    standard_uncertainty_um: float | None = None,
    probe_radius_mm: float | None = None,
    probe_side: ProbeSide | None = None,
    minimum_zone: bool = False,
    robust: bool = False,
) -> Circle:
    """Fit a circle in the plane z = 0."""
    return _fitted(Circle, "circle2d", points, weights=weights, radius_mm=radius_mm, standard_uncertainty_um=standard_uncertainty_um, probe_radius_mm=probe_radius_mm, probe_side=probe_side, minimum_zone=minimum_zone, robust=robust)


@_documented
def sphere(
    points: ArrayLike,
    *,
    weights: ArrayLike | None = None,
    radius_mm: float | None = None,
    standard_uncertainty_um: float | None = None,
    probe_radius_mm: float | None = None,
    probe_side: ProbeSide | None = None,
    minimum_zone: bool = False,
    robust: bool = False,
) -> Sphere:
    """Fit a sphere."""
    return _fitted(Sphere, "sphere", points, weights=weights, radius_mm=radius_mm, standard_uncertainty_um=standard_uncertainty_um, probe_radius_mm=probe_radius_mm, probe_side=probe_side, minimum_zone=minimum_zone, robust=robust)


@_documented
def cylinder(
    points: ArrayLike,
    *,
    weights: ArrayLike | None = None,
    radius_mm: float | None = None,
    axis: ArrayLike | None = None,
    standard_uncertainty_um: float | None = None,
    probe_radius_mm: float | None = None,
    probe_side: ProbeSide | None = None,
    minimum_zone: bool = False,
    robust: bool = False,
) -> Cylinder:
    """Fit a cylinder."""
    return _fitted(Cylinder, "cylinder", points, weights=weights, radius_mm=radius_mm, axis=axis, standard_uncertainty_um=standard_uncertainty_um, probe_radius_mm=probe_radius_mm, probe_side=probe_side, minimum_zone=minimum_zone, robust=robust)


@_documented
def cone(
    points: ArrayLike,
    *,
    weights: ArrayLike | None = None,
    axis: ArrayLike | None = None,
    standard_uncertainty_um: float | None = None,
    probe_radius_mm: float | None = None,
    probe_side: ProbeSide | None = None,
    minimum_zone: bool = False,
    robust: bool = False,
) -> Cone:
    """Fit a cone."""
    return _fitted(Cone, "cone", points, weights=weights, axis=axis, standard_uncertainty_um=standard_uncertainty_um, probe_radius_mm=probe_radius_mm, probe_side=probe_side, minimum_zone=minimum_zone, robust=robust)


@_documented
def torus(
    points: ArrayLike,
    *,
    weights: ArrayLike | None = None,
    standard_uncertainty_um: float | None = None,
    probe_radius_mm: float | None = None,
    probe_side: ProbeSide | None = None,
    minimum_zone: bool = False,
    robust: bool = False,
) -> Torus:
    """Fit a torus."""
    return _fitted(Torus, "torus", points, weights=weights, standard_uncertainty_um=standard_uncertainty_um, probe_radius_mm=probe_radius_mm, probe_side=probe_side, minimum_zone=minimum_zone, robust=robust)


def enclosing_circle(points: ArrayLike) -> Circle:
    """Return the smallest circle that encloses the points in the plane z = 0."""
    return Circle(load(_etalon.enclosing("enclosing-circle", points_of(points)))._members)


def enclosing_sphere(points: ArrayLike) -> Sphere:
    """Return the smallest sphere that encloses the points."""
    return Sphere(load(_etalon.enclosing("enclosing-sphere", points_of(points)))._members)


def _number(value: float | None, name: str) -> float | None:
    refuse_masked(value, name)
    try:
        return None if value is None else float(value)
    except (TypeError, ValueError) as error:
        raise Error(f"`{name}`: expected a number: {error}") from error

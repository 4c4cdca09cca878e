"""Identification, planning, verification and tests by standards, on tables."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Literal, cast

import numpy as np

from . import _etalon, documents
from ._errors import Error, row_words, with_warnings
from ._options import Progress, called, whole
from ._residuals import Residuals
from ._robot import Robot, Targets, robot_of
from ._tables import Columns, Marks, Named, is_path
from .documents import load
from .kinematics import _needed

Effect = Literal[
    "zeros",
    "geometry",
    "gains",
    "harmonics",
    "backlash",
    "coupling",
    "bending",
    "payload",
    "torque",
    "expansion",
    "drift",
    "lateral",
    "pedestal",
]
#: Identified effects: a name of several, or a list.
Effects = Literal["usual", "all"] | Effect | Sequence[Effect]
Prior = Literal["tolerances", "none"]
Convention = Literal["poe", "dh", "mdh"]
Index = Literal["O1", "O2", "O3", "O4", "O5", "D", "A", "E", "I"]
#: Order of the rotations by the angles a, b, c: a product of three rotations about x, y or z, each by one of the angles. With the angles in the order
#: of the product the axes are those of the moved body; in the reverse order they are fixed.
RotationOrder = Literal[
    "Rz(a) Ry(b) Rx(c)", "Rx(a) Ry(b) Rz(c)", "Rx(a) Rz(b) Ry(c)", "Ry(a) Rx(b) Rz(c)",
    "Ry(a) Rz(b) Rx(c)", "Rz(a) Rx(b) Ry(c)", "Rz(a) Ry(b) Rz(c)", "Rz(a) Rx(b) Rz(c)",
    "Rx(a) Ry(b) Rx(c)", "Rx(a) Rz(b) Rx(c)", "Ry(a) Rx(b) Ry(c)", "Ry(a) Rz(b) Ry(c)",
    "Rz(c) Ry(b) Rx(a)", "Rx(c) Ry(b) Rz(a)", "Rx(c) Rz(b) Ry(a)", "Ry(c) Rx(b) Rz(a)",
    "Ry(c) Rz(b) Rx(a)", "Rz(c) Rx(b) Ry(a)", "Rz(c) Ry(b) Rz(a)", "Rz(c) Rx(b) Rz(a)",
    "Rx(c) Ry(b) Rx(a)", "Rx(c) Rz(b) Rx(a)", "Ry(c) Rx(b) Ry(a)", "Ry(c) Rz(b) Ry(a)",
    "Rx(a) Rz(c) Ry(b)", "Ry(b) Rx(a) Rz(c)", "Ry(b) Rz(c) Rx(a)", "Rz(c) Rx(a) Ry(b)",
]
Problem = Literal["tool-point", "tool-reflector", "tool-axes", "hand-eye", "object", "three-points", "linear-axis", "rotary-axis"]
Mounting = Literal["target", "sensor"]
DecisionRule = Literal["simple-acceptance", "guarded", "shared-risk"]
#: Headings of all tables of a call, and of single tables by the name of the argument.
ColumnsByTable = Mapping[str, str | int | Columns]


class Identification(documents.ParametersDocument, Residuals):
    """Identified parameters: ``parameters.json``, and the errors of the readings of this call."""

    __slots__ = ("_errors",)
    _schema_class = "ParametersDocument"

    def __init__(self, members: dict[str, Any], errors: str) -> None:
        super().__init__(members)
        object.__setattr__(self, "_errors", errors)

    def _residual_columns(self) -> str:
        return cast(str, object.__getattribute__(self, "_errors"))

    def __reduce__(self) -> tuple[Any, ...]:
        return (Identification, (self._members, self._residual_columns()))


def identify(
    robot: Robot | str | os.PathLike[str],
    observations: Any,
    *,
    standard_uncertainty_um: float | None = None,
    common_uncertainty_um: float | None = None,
    rotation_uncertainty_deg: float | None = None,
    orientation: str | None = None,
    pose_residuals: bool = False,
    hold: Sequence[str] | str = (),
    exclude: Sequence[str] | str = (),
    exclude_rows: Sequence[str] | str = (),
    effects: Effects = "usual",
    prior: Prior = "tolerances",
    uncertainty_bound: str | None = None,
    target: str | None = None,
    pose: Literal["row"] | None = None,
    columns: Columns | None = None,
    targets: Targets | None = None,
    delimiter: str | None = None,
    decimal: str | None = None,
    sheet: str | None = None,
) -> Identification:
    """Identify the parameters of a robot from a table of observations.

    Args:
        robot: The robot, or what :class:`etalon.Robot` takes.
        observations: Table with ``pose``, ``cycle``, ``target``, ``x_mm``, ``y_mm``, ``z_mm`` and a column for each joint (``q1_deg`` ...); with a
            column ``kind`` also poses, distances, contacts, surfaces and joint values.
        standard_uncertainty_um: Of one measured coordinate (k = 1), um; from the residuals if None.
        common_uncertainty_um: Of a coordinate that is common to rows with the same coordinates (k = 1), um.
        rotation_uncertainty_deg: Of a measured orientation about any axis (k = 1), deg.
        orientation: Order of the angles ``a_deg``, ``b_deg``, ``c_deg``: ``"zyx"``, ``"fixed xyz"`` ...
        pose_residuals: Compares poses instead of targets (planar robots).
        hold: Names of parameters that stay nominal; ``*`` stands for any text.
        exclude: ``"POSES: REASON"``: readings that are left out.
        exclude_rows: ``"ROWS: REASON"``: rows that are left out, counted from 1.
        effects: ``"usual"``, ``"all"``, or a list of zeros, geometry, gains, harmonics, backlash, coupling, bending, payload,
            torque, expansion, drift, lateral, pedestal.
        prior: ``"tolerances"``: nominal values with tolerances are readings; ``"none"``: plain least squares.
        uncertainty_bound: Bound of the expanded uncertainties of the answer: ``"0.5 mm, 0.1 deg"``; a share of the measured extent if None.
        target: Target of all rows, of a table without that column.
        pose: ``"row"``: rows are numbered as poses, of a table without that column.
        columns: Names of columns that are called otherwise in the table: ``{"q1_deg": "J1"}``.
        targets: Nominal positions (mm) of targets at the flange, as of :class:`etalon.Robot`. Without, a target is at the flange's origin.
        delimiter: Delimiter of the columns of a file: ``";"``, ``"tab"`` ...; a comma if None.
        decimal: Decimal mark of a file, and of texts in a table: ``","``; a point if None.
        sheet: Sheet of a workbook, or topic of a recording (MCAP); not needed for a workbook with one sheet.

    Returns:
        ``parameters.json`` as :class:`etalon.documents.ParametersDocument`: values and standard uncertainties (k = 1), mm and deg; with
        ``residuals_table()`` and ``plot()``.

    Raises:
        Error: The table does not read, does not belong to the robot, or does not determine the parameters.

    Warns:
        MessageWarning: Messages of the document, by id; :class:`etalon.ImplausibleWarning` if no such robot can have the parameters.
    """
    marks = Marks(delimiter, decimal, sheet)
    options = _json(
        standard_uncertainty_um=standard_uncertainty_um,
        common_uncertainty_um=common_uncertainty_um,
        rotation_uncertainty_deg=rotation_uncertainty_deg,
        orientation=orientation,
        pose_residuals=pose_residuals,
        hold=_names(hold, "hold"),
        exclude=_names(exclude, "exclude"),
        exclude_rows=_names(exclude_rows, "exclude_rows"),
        effects=_listed(effects, "effects"),
        prior=prior,
        uncertainty_bound=uncertainty_bound,
        target=target,
        pose=pose,
        column=_headings(columns),
        **marks.options(observations=observations),
    )
    native, table = robot_of(robot, targets), marks.named(observations, "observations")
    try:
        document, errors = _etalon.identify(native, table, options)
    except Error as error:
        raise _with_units(error, native.joints, _headings(columns)) from None
    return cast(Identification, with_warnings(Identification(load(document)._members, errors)))


def plan(
    robot: Robot | str | os.PathLike[str],
    candidates: Any,
    positions: int,
    *,
    index: Index = "O1",
    single: bool = False,
    start: Sequence[Any] = (),
    compare: Sequence[Any] = (),
    starts: int | None = None,
    nodes: int | None = None,
    seed: int = 1,
    standard_uncertainty_um: float | None = None,
    hold: Sequence[str] | str = (),
    effects: Effects = "usual",
    prior: Prior = "tolerances",
    target: str | None = None,
    pose: Literal["row"] | None = None,
    columns: Columns | None = None,
    targets: Targets | None = None,
    delimiter: str | None = None,
    decimal: str | None = None,
    sheet: str | None = None,
    progress: Progress | None = None,
) -> documents.PlanDocument:
    """Choose the poses to measure among candidates.

    Args:
        robot: The robot, or what :class:`etalon.Robot` takes.
        candidates: Table with ``pose``, ``target`` (of robots in space) and a column for each joint; rows of one pose are measured
            together.
        positions: Number of poses to choose.
        index: What is maximised: ``O1`` to ``O5``, or ``D``, ``A``, ``E``, ``I``.
        single: Chooses row by row instead of pose by pose.
        start: Poses from which the choice starts.
        compare: Poses to compare the plan with.
        starts: Random starts of the exchange; by default as many as the problem deserves.
        nodes: Largest number of nodes of branch and bound; likewise.
        seed: Seed of the random starts.
        standard_uncertainty_um: Of one coordinate (k = 1), um, for the predicted uncertainties.
        hold: As in :func:`identify`.
        effects: As in :func:`identify`.
        prior: As in :func:`identify`.
        target: As in :func:`identify`.
        pose: As in :func:`identify`.
        columns: As in :func:`identify`.
        targets: As in :func:`identify`. A target at the flange's origin does not depend on the zero of the last joint: state where it is.
        delimiter: As in :func:`identify`.
        decimal: As in :func:`identify`.
        sheet: As in :func:`identify`.
        progress: Called with what is done and the whole; an exception ends the search.

    Returns:
        :class:`etalon.documents.PlanDocument`, with a bound on the best plan.

    Raises:
        Error: The table does not belong to the robot, or has too few candidates.
    """
    marks = Marks(delimiter, decimal, sheet)
    options = _json(
        positions=whole(positions, "positions"),
        index=index,
        single=single,
        start=_listed(start, "start"),
        compare=_listed(compare, "compare"),
        starts=starts,
        nodes=nodes,
        seed=whole(seed, "seed"),
        standard_uncertainty_um=standard_uncertainty_um,
        hold=_names(hold, "hold"),
        effects=_listed(effects, "effects"),
        prior=prior,
        target=target,
        pose=pose,
        column=_headings(columns),
        **marks.options(candidates=candidates),
    )
    found = load(_etalon.plan(robot_of(robot, targets), marks.named(candidates, "candidates"), options, called(progress)))
    return cast(documents.PlanDocument, with_warnings(found))


def verify(
    robot: Robot | str | os.PathLike[str],
    parameters: Any,
    observations: Any,
    *,
    standard_uncertainty_um: float | None = None,
    rotation_uncertainty_deg: float | None = None,
    orientation: str | None = None,
    uncertainty_bound: str | None = None,
    target: str | None = None,
    pose: Literal["row"] | None = None,
    columns: Columns | None = None,
    targets: Targets | None = None,
    delimiter: str | None = None,
    decimal: str | None = None,
    sheet: str | None = None,
) -> documents.VerificationDocument:
    """Judge from some few measured poses whether identified parameters still hold.

    Args:
        robot: The robot, or what :class:`etalon.Robot` takes.
        parameters: The document of :func:`identify`, or the path of a ``parameters.json``.
        observations: Table of positions as of :func:`identify`; it contains targets of the calibration.
        standard_uncertainty_um: Of one measured coordinate (k = 1), um; that of the calibration if None.
        rotation_uncertainty_deg: Of a measured orientation about any axis (k = 1), deg; that of the calibration if None.
        orientation: Order of the angles ``a_deg``, ``b_deg``, ``c_deg``, as in :func:`identify`.
        uncertainty_bound: Bound of the expanded uncertainties of the answer: ``"0.5 mm, 0.1 deg"``; a share of the measured extent if None.
        target: As in :func:`identify`.
        pose: As in :func:`identify`.
        columns: As in :func:`identify`.
        targets: As in :func:`identify`; the calibration states the positions of its own targets.
        delimiter: As in :func:`identify`.
        decimal: As in :func:`identify`.
        sheet: As in :func:`identify`.

    Returns:
        :class:`etalon.documents.VerificationDocument`; ``.verdict`` is ``valid``, ``base_moved``, ``joint`` or ``other``.

    Raises:
        Error: The table or the parameters do not belong to the robot.
    """
    marks = Marks(delimiter, decimal, sheet)
    options = _json(
        standard_uncertainty_um=standard_uncertainty_um,
        rotation_uncertainty_deg=rotation_uncertainty_deg,
        orientation=orientation,
        uncertainty_bound=uncertainty_bound,
        target=target,
        pose=pose,
        column=_headings(columns),
        **marks.options(observations=observations),
    )
    table = marks.named(observations, "observations")
    return cast(documents.VerificationDocument, with_warnings(load(_etalon.verify(robot_of(robot, targets), _needed(parameters), table, options))))


def axes(
    sweeps: Any,
    *,
    joints: Sequence[str] = (),
    prismatic: Sequence[str] = (),
    backwards: Sequence[str] = (),
    standard_uncertainty_um: float | None = None,
    convention: Convention | None = None,
    uncertainty_bound: str | None = None,
    target: str | None = None,
    columns: Columns | None = None,
    delimiter: str | None = None,
    decimal: str | None = None,
    sheet: str | None = None,
) -> documents.AxesDocument:
    """Find the axes of joints from sweeps of one joint at a time (circle-point analysis).

    Args:
        sweeps: Table with ``joint`` (the swept joint), ``target``, ``x_mm``, ``y_mm``, ``z_mm`` and, where known, a column for each joint
            (``q1_deg`` ...).
        joints: Joints from the base; in the order of their numbers if empty.
        prismatic: Prismatic joints without a column of joint values.
        backwards: Joints that were swept in negative direction, without joint values.
        standard_uncertainty_um: Of one measured coordinate (k = 1), um; from the residuals of each sweep if None.
        convention: Convention of the robot file: ``"poe"``, ``"dh"`` or ``"mdh"``.
        uncertainty_bound: Bound of the expanded uncertainties of the answer: ``"0.5 mm, 0.1 deg"``; a share of the measured extent if None.
        target: As in :func:`identify`.
        columns: As in :func:`identify`.
        delimiter: As in :func:`identify`.
        decimal: As in :func:`identify`.
        sheet: As in :func:`identify`.

    Returns:
        :class:`etalon.documents.AxesDocument`; ``Robot.from_toml(found.robot.robot_toml)`` is the robot without a nominal model.

    Raises:
        Error: The table does not read, or a sweep determines no axis.
    """
    marks = Marks(delimiter, decimal, sheet)
    options = _json(
        joints=_listed(joints, "joints"),
        prismatic=_listed(prismatic, "prismatic"),
        backwards=_listed(backwards, "backwards"),
        standard_uncertainty_um=standard_uncertainty_um,
        convention=convention,
        uncertainty_bound=uncertainty_bound,
        target=target,
        column=_headings(columns),
        **marks.options(sweeps=sweeps),
    )
    return cast(documents.AxesDocument, with_warnings(load(_etalon.axes(marks.named(sweeps, "sweeps"), options))))


def cell(
    readings: Any,
    solve: Problem,
    *,
    orientation: str | None = None,
    measured_orientation: str | None = None,
    mounting: Mounting | None = None,
    standard_uncertainty_um: float | None = None,
    rotation_uncertainty_deg: float | None = None,
    uncertainty_bound: str | None = None,
    target: str | None = None,
    columns: Columns | None = None,
    delimiter: str | None = None,
    decimal: str | None = None,
    sheet: str | None = None,
) -> documents.CellDocument:
    """Find tool, work object, hand and eye, or an external axis from controller poses and measurements.

    Args:
        readings: Table with the columns of the problem. Poses of the flange: ``flange_x_mm``, ``flange_y_mm``, ``flange_z_mm`` and
            ``flange_qw`` ... ``flange_qz``, ``flange_rx_deg`` ... (rotation vector), or ``flange_a_deg`` ... with ``orientation``.

            - ``tool-point``: poses of the flange.
            - ``tool-reflector``: poses of the flange, ``x_mm``, ``y_mm``, ``z_mm`` of the reflector.
            - ``tool-axes``: poses of the flange, ``point`` (``tip``, ``z``, ``x``).
            - ``hand-eye``: poses of the flange, measured poses ``x_mm``, ``y_mm``, ``z_mm``, ``qw`` ... (or ``rx_deg`` ..., ``a_deg`` ...).
            - ``object``: ``nominal_x_mm``, ``nominal_y_mm``, ``nominal_z_mm``, ``x_mm``, ``y_mm``, ``z_mm``.
            - ``three-points``: ``point`` (``origin``, ``x``, ``xy`` or ``x1``, ``x2``, ``y1``), ``x_mm``, ``y_mm``, ``z_mm``.
            - ``linear-axis``, ``rotary-axis``: ``axis_mm`` or ``axis_deg``, ``x_mm``, ``y_mm``, ``z_mm``, ``target``.
        solve: Problem: ``"tool-point"``, ``"tool-reflector"``, ``"tool-axes"``, ``"hand-eye"``, ``"object"``, ``"three-points"``, ``"linear-axis"`` or
            ``"rotary-axis"``.
        orientation: Order of the angles ``flange_a_deg``, ``flange_b_deg``, ``flange_c_deg``.
        measured_orientation: Order of the angles ``a_deg``, ``b_deg``, ``c_deg``.
        mounting: Part of the measuring system that is on the robot (hand and eye).
        standard_uncertainty_um: Of one coordinate, robot and measurement together (k = 1), um; from the residuals if None.
        rotation_uncertainty_deg: Of an orientation about any axis (k = 1), deg; from the residuals if None.
        uncertainty_bound: Bound of the expanded uncertainties of the answer: ``"0.5 mm, 0.1 deg"``; a share of the measured extent if None.
        target: As in :func:`identify`.
        columns: As in :func:`identify`.
        delimiter: As in :func:`identify`.
        decimal: As in :func:`identify`.
        sheet: As in :func:`identify`.

    Returns:
        :class:`etalon.documents.CellDocument`: frames and points with standard uncertainties (k = 1), mm and deg.

    Raises:
        Error: The table does not read, or leaves a direction open.
    """
    marks = Marks(delimiter, decimal, sheet)
    options = _json(
        solve=solve,
        orientation=orientation,
        measured_orientation=measured_orientation,
        mounting=mounting,
        standard_uncertainty_um=standard_uncertainty_um,
        rotation_uncertainty_deg=rotation_uncertainty_deg,
        uncertainty_bound=uncertainty_bound,
        target=target,
        column=_headings(columns),
        **marks.options(readings=readings),
    )
    return cast(documents.CellDocument, with_warnings(load(_etalon.cell(marks.named(readings, "readings"), options))))


def iso9283(
    attained: Any,
    commanded: Any = None,
    *,
    reference: Any = None,
    expanded_uncertainty_um: float | None = None,
    ap_limit_mm: float | None = None,
    rp_limit_mm: float | None = None,
    decision_rule: DecisionRule | None = None,
    drift_set: int | None = None,
    rotation_order: RotationOrder | None = None,
    seed: int = 1,
    pose: Literal["row"] | None = None,
    cycle: Literal["visit"] | None = None,
    columns: ColumnsByTable | None = None,
    delimiter: str | None = None,
    decimal: str | None = None,
    sheet: str | Mapping[str, str] | None = None,
) -> documents.Iso9283Document:
    """Evaluate accuracy and repeatability of poses to ISO 9283.

    Args:
        attained: Table with ``pose``, ``cycle``, ``x_mm``, ``y_mm``, ``z_mm`` and, where measured, ``a_deg``, ``b_deg``, ``c_deg``; rows in the order of
            recording.
        commanded: Table with the same columns without ``cycle``; repeatability alone if None.
        reference: Table of targets that stand still: ``cycle``, ``target``, ``x_mm``, ``y_mm``, ``z_mm``.
        expanded_uncertainty_um: Of a measured coordinate (k = 2), um.
        ap_limit_mm: Limit of the accuracy AP, mm.
        rp_limit_mm: Limit of the repeatability RP, mm.
        decision_rule: As ``--decision-rule`` of the program.
        drift_set: Cycles of one set of a drift test.
        rotation_order: Order of the rotations by the angles a, b, c, multiplied from left to right. ``"Rz(c) Ry(b) Rx(a)"``: a, b, c about the
            fixed axes x, y, z (roll, pitch, yaw). ``"Rz(a) Ry(b) Rx(c)"``: a about z, b about the turned y, c about the turned x (KUKA). Angles
            that are not separable become rotation vectors, and ``reference`` also compensates angles; None: each angle by itself.
        seed: Seed of the bootstrap intervals.
        pose: As in :func:`identify`, for all three tables.
        cycle: ``"visit"``: the n-th row of a pose is cycle n, of a table without that column whose rows are in the order of recording.
        columns: As in :func:`identify`, for all three tables; by the name of the argument if they differ: ``{"attained": {"x_m": "X"}}``.
        delimiter: As in :func:`identify`, for all three tables.
        decimal: As in :func:`identify`, for all three tables.
        sheet: As in :func:`identify`, for all files; by the name of the argument if they differ: ``{"attained": "Measured", "commanded": "Programmed"}``.

    Returns:
        :class:`etalon.documents.Iso9283Document`; ``.poses`` has AP and RP of each pose, mm.

    Raises:
        Error: A table does not read, or the tables do not belong together.
    """
    options = _json(
        expanded_uncertainty_um=expanded_uncertainty_um,
        ap_limit_mm=ap_limit_mm,
        rp_limit_mm=rp_limit_mm,
        decision_rule=decision_rule,
        drift_set=drift_set,
        rotation_order=rotation_order,
    )
    marks = Marks(delimiter, decimal, sheet)
    tables = {"attained": attained, "commanded": commanded, "reference": reference}
    counted = {"cycle": cycle} if cycle is not None else None
    shared, own = _by_table(columns, tables)
    reading = _json(pose=pose, constant=counted, column=shared, **marks.options(**tables))
    named = [None if table is None else marks.named(table, name, own.get(name)) for name, table in tables.items()]
    with marks.apart(**tables):
        try:
            text = _etalon.iso9283(_first(named, "attained"), named[1:], [options, reading], whole(seed, "seed"))
        except Error as error:
            raise _with_own_units(error, columns) from None
    found = _loaded(text, attained, commanded, reference)
    _state_own_columns(found, columns)
    return cast(documents.Iso9283Document, with_warnings(found))


def iso9283_path(
    recording: Any,
    commanded: Any = None,
    path: Any = None,
    *,
    rate_hz: float | None = None,
    still_mm: float = 0.1,
    still_s: float = 0.2,
    near_mm: float = 10.0,
    band_mm: float | None = None,
    path_points: int = 50,
    velocity_mm_s: float | None = None,
    central_percent: float = 50.0,
    seed: int = 1,
    columns: ColumnsByTable | None = None,
    delimiter: str | None = None,
    decimal: str | None = None,
    sheet: str | Mapping[str, str] | None = None,
) -> documents.Iso9283StreamDocument:
    """Evaluate a recorded motion to ISO 9283: standstills, stabilisation, and the characteristics of a path.

    Args:
        recording: Table with ``time_s``, ``x_mm``, ``y_mm``, ``z_mm`` and, where measured, ``a_deg``, ``b_deg``, ``c_deg``.
        commanded: Table of the poses at which the motion stands.
        path: Table of the commanded path, a row a point.
        rate_hz: Sampling rate, instead of the time stamps.
        still_mm: Standing: all positions within this distance of their mean, mm.
        still_s: Standing: for at least this time, s.
        near_mm: Largest distance of a standstill from its pose, mm.
        band_mm: Limit band about the attained pose, mm.
        path_points: Command points on the path.
        velocity_mm_s: Commanded velocity on the path, mm/s.
        central_percent: Central part of the path over which velocities are compared, %.
        seed: Seed of the bootstrap intervals.
        columns: As in :func:`identify`, for all three tables; by the name of the argument if they differ: ``{"path": {"x_m": "X"}}``.
        delimiter: As in :func:`identify`, for all three tables.
        decimal: As in :func:`identify`, for all three tables.
        sheet: As in :func:`identify`, for all files; by the name of the argument if they differ: ``{"recording": "Measured", "commanded": "Programmed"}``.

    Returns:
        :class:`etalon.documents.Iso9283StreamDocument`.

    Raises:
        Error: A table does not read, or the recording does not show the motion.
    """
    marks = Marks(delimiter, decimal, sheet)
    tables = {"recording": recording, "commanded": commanded, "path": path}
    shared, own = _by_table(columns, tables)
    options = _json(
        rate_hz=rate_hz,
        still_mm=still_mm,
        still_s=still_s,
        near_mm=near_mm,
        band_mm=band_mm,
        path_points=path_points,
        velocity_mm_s=velocity_mm_s,
        central_percent=central_percent,
        column=shared,
        **marks.options(**tables),
    )
    named = [None if table is None else marks.named(table, name, own.get(name)) for name, table in tables.items()]
    with marks.apart(**tables):
        text = _etalon.iso9283_path(_first(named, "recording"), named[1:], options, whole(seed, "seed"))
    return cast(documents.Iso9283StreamDocument, with_warnings(_loaded(text, recording, commanded, path)))


def iso230(
    positions: Any,
    *,
    columns: Columns | None = None,
    delimiter: str | None = None,
    decimal: str | None = None,
    sheet: str | None = None,
) -> documents.AxisDocument:
    """Evaluate the positioning of a linear axis to ISO 230-2:2014.

    Args:
        positions: Table with ``position_mm`` (programmed), ``measured_mm`` and ``direction`` (+1 or -1); each position at least twice in either
            direction.
        columns: As in :func:`identify`.
        delimiter: As in :func:`identify`.
        decimal: As in :func:`identify`.
        sheet: As in :func:`identify`.

    Returns:
        :class:`etalon.documents.AxisDocument`; ``.axis`` has accuracy, repeatability and reversal, mm.

    Raises:
        Error: A position has too few runs.
    """
    marks = Marks(delimiter, decimal, sheet)
    reading = _json(column=_headings(columns), **marks.options(positions=positions))
    return cast(documents.AxisDocument, with_warnings(_loaded(_etalon.iso230(marks.named(positions, "positions"), reading), positions)))


def _loaded(text: str, *tables: Any) -> documents.Document:
    """Return a document that does not name its inputs; messages about tables in memory count rows."""
    found = load(text)
    if not any(is_path(table) for table in tables):
        for message in found._members.get("messages") or []:
            message |= {part: row_words(message[part]) for part in ("what", "hint") if isinstance(message.get(part), str)}
    return found


def _json(**options: Any) -> str:
    """Return options as JSON text, which the types of the tasks read; None is left out."""
    stated = {name: value for name, value in options.items() if value is not None}
    for name, value in stated.items():
        if isinstance(value, (float, np.floating)) and not np.isfinite(value):
            raise Error(f"`{name}` is {value}: expected a finite number")
    return json.dumps(stated, default=lambda value: value.tolist() if hasattr(value, "tolist") else str(value))


def _names(values: Sequence[str] | str, name: str) -> list[str]:
    """Return the values of an option that is repeated; a text is one of them."""
    if isinstance(values, str):
        return [values]
    stated: list[str] = list(values) if isinstance(values, Iterable) else [values]
    if not all(isinstance(value, str) for value in stated):
        example = '"11, 13-15: reason"' if name.startswith("exclude") else '"a_3"'
        raise Error(f"`{name}` contains a value that is no text: expected a text such as {example}, or a list of texts")
    return stated


def _listed(values: Any, name: str) -> list[Any] | None:
    """Return the values of an option that also takes a text with commas."""
    if isinstance(values, str):
        return values.split(",")
    if values is not None and not isinstance(values, Iterable):
        raise Error(f"`{name}` is of type {type(values).__name__}: expected a list")
    return None if values is None else list(values)


#: Unit of a column, and the unit of its numbers, by the name of the change in a message.
_UNITS = {"m-mm": ("mm", "m"), "inch-mm": ("mm", "inch"), "mm-m": ("m", "mm"), "mm-inch": ("inch", "mm"), "rad-deg": ("deg", "rad"), "deg-rad": ("rad", "deg")}


def _with_units(error: Error, joints: Sequence[str], columns: dict[str, str | int]) -> Error:
    """Return an error whose hint finds points or joints in another unit, with the columns in this unit."""
    for message in error.messages:
        change: Any = message.arguments.get("hint")
        for inner in ("first", "slip"):
            change = change.get("arguments", {}).get(inner) if isinstance(change, dict) else None
        stated = change["arguments"] if isinstance(change, dict) and change.get("id") == "slip-unit" else {}
        stems = {"points": ["x", "y", "z"], "all-joints": [name.rsplit("_", 1)[0] for name in joints]}.get(str(stated.get("quantity")), [])
        if not stems or stated["slip"] not in _UNITS or message.id is None:
            continue
        unit, other = _UNITS[stated["slip"]]
        changed = {f"{stem}_{other}": columns.get(f"{stem}_{unit}", f"{stem}_{unit}") for stem in stems}
        others = {name: heading for name, heading in columns.items() if name not in {f"{stem}_{unit}" for stem in stems}}
        remedy = json.dumps(others | changed, ensure_ascii=False)
        hint = (message.stated_hint or "").replace(" (`unit` of the export)", "")
        error = error.with_hint(message.id, f"{hint}; then set `columns={remedy}`")
    return error


#: Columns of a unit of length, by the unit.
_LENGTHS = {"m": "m", "inch": "inch"}


def _by_table(columns: ColumnsByTable | None, tables: Mapping[str, Any]) -> tuple[dict[str, str | int], dict[str, dict[str, str | int]]]:
    """Return the headings of all tables of a call, and those of each table."""
    stated = {} if columns is None else dict(_mapping(columns))
    own = {name: _headings(value) for name, value in stated.items() if isinstance(value, Mapping)}
    present = [name for name, table in tables.items() if table is not None]
    wrong = sorted(set(own) - set(present))
    if wrong:
        raise Error(f"`columns` names {', '.join(wrong)}: expected tables of this call ({', '.join(present)})")
    return {name: value for name, value in stated.items() if not isinstance(value, Mapping)}, own


def _first(named: Sequence[Named | None], name: str) -> Named:
    """Return the table that a call needs."""
    if named[0] is None:
        raise Error(f"`{name}` is None: expected a table")
    return named[0]


def _merged(columns: ColumnsByTable | None, table: str, changed: Mapping[str, str | int], replaced: Iterable[str]) -> str:
    """Return `columns` of a call with other headings of one table as JSON text; columns that the new ones replace are left out."""
    stated: dict[str, Any] = dict(columns or {})
    own = {name: value for name, value in dict(stated.get(table, {})).items() if name not in set(replaced)}
    return json.dumps({**stated, table: own | dict(changed)}, ensure_ascii=False)


def _heading_of(columns: ColumnsByTable | None, table: str, name: str) -> str | int:
    """Return the heading that a column has in a table."""
    stated: dict[str, Any] = dict(columns or {})
    own: dict[str, Any] = dict(stated.get(table, {}))
    heading: str | int = own.get(name, stated.get(name, name))
    return heading


def _with_own_units(error: Error, columns: ColumnsByTable | None) -> Error:
    """Return an error that finds the positions of one table in another unit, with the columns of this table in this unit."""
    for message in error.messages:
        unit, table, axes = (message.arguments.get(name) for name in ("unit", "table", "axes"))
        if message.id != "positions-in-other-unit" or table not in ("attained", "commanded") or unit not in _LENGTHS or not isinstance(axes, list):
            continue
        changed = {f"{axis}_{unit}": _heading_of(columns, str(table), f"{axis}_mm") for axis in axes}
        remedy = _merged(columns, str(table), changed, [f"{axis}_mm" for axis in axes])
        error = error.with_hint("positions-in-other-unit", f"set `columns={remedy}`, or convert the values to mm")
    return error


def _state_own_columns(found: documents.Document, columns: ColumnsByTable | None) -> None:
    """Write the headings of the attained poses into the hint of a message that finds their columns exchanged."""
    for message in found._members.get("messages") or []:
        stated = message.get("arguments", {})
        names = [f"{axis}_mm" for axis in stated.get("columns", [])]
        if message.get("id") != "coordinates-exchanged" or not names:
            continue
        headings = [_heading_of(columns, "attained", name) for name in names]
        changed: dict[str, str | int]
        if stated.get("change") == "sign":
            changed = {names[0]: f"-{headings[0]}"}
        elif stated.get("change") == "swapped":
            changed = dict(zip(names, headings[::-1]))
        else:
            changed = dict(zip(("x_mm", "y_mm", "z_mm"), headings))
        remedy = _merged(columns, "attained", changed, names)
        message["hint"] = f"if the attained poses are wrong, set `columns={remedy}`; if the commanded poses are wrong, exchange their columns likewise"


def _mapping(columns: Any) -> Mapping[str, Any]:
    if not isinstance(columns, Mapping):
        raise Error(f"`columns` is of type {type(columns).__name__}: expected headings by etalon's names, such as {{\"q1_deg\": \"J1\"}}")
    return columns


def _headings(columns: Columns | None) -> dict[str, str | int]:
    return {} if columns is None else dict(_mapping(columns))

"""Robots."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _etalon
from ._arrays import numbers, refuse_masked
from ._errors import Error, Message, warn

#: Nominal positions (mm) of targets at the flange, by name.
Targets = Mapping[str, Sequence[float]]


class Parameter(NamedTuple):
    """A parameter of a robot: its name, its unit (mm, deg or 1) and its nominal value."""

    name: str
    unit: str
    nominal: float


class Chain(NamedTuple):
    """A chain of a URDF: its base link, its tool link and the joints that move it."""

    base_link: str
    tool_link: str
    joints: list[str]


def robots() -> list[str]:
    """Return the names of robots whose published geometry etalon has."""
    return _etalon.robot_names()


class Robot:
    """A kinematic model with nominal parameters.

    Robots are compared by their description, copied, and pickled. A pickled robot contains the text of its URDF and no path.

    Args:
        source: A path of a ``robot.toml`` or of a URDF (``.urdf``, ``.xml``); otherwise a name of :func:`robots`, such as ``"ur5e"`` or ``"UR5e"``.
        targets: Nominal positions (mm) of targets at the flange, in addition to ``[nominal]``: ``{"SMR": (80, 0, 25)}``.

    Raises:
        Error: The file cannot be read, or no robot has this name.

    Warns:
        MessageWarning: ``urdf-chain-chosen``: a URDF has several chains; :attr:`chain` is the one with the most moving joints.
    """

    _native: _etalon.Robot
    _chain: Chain | None

    def __init__(self, source: str | os.PathLike[str], targets: Targets | None = None) -> None:
        self._chain = None
        if not isinstance(source, (str, os.PathLike)):
            raise Error(f"`source` is of type {type(source).__name__}: expected the name of a robot, or the path of a robot.toml or URDF")
        path = os.fspath(source)
        if path in robots():
            self._native = _etalon.Robot.named(path)
        elif path.endswith((".urdf", ".xml", ".xacro")):  # xacro is refused by name
            self._native, self._chain = _urdf_robot(path, None, None)
        elif path.endswith(".toml") or os.path.isfile(path):
            self._native = _etalon.Robot.read(path)
        else:
            self._native = _etalon.Robot.named(path)
        self._native = _with_targets(self._native, targets)

    @classmethod
    def _of(cls, native: _etalon.Robot, chain: Chain | None = None) -> Robot:
        robot = cls.__new__(cls)
        robot._native, robot._chain = native, chain
        return robot

    @classmethod
    def _restore(cls, text: str, description: str | None, chain: Chain | None) -> Robot:
        return cls._of(_etalon.Robot.restore(text, description), chain)

    @classmethod
    def from_toml(cls, text: str) -> Robot:
        """Return the robot that the text of a ``robot.toml`` describes."""
        if not isinstance(text, str):
            raise Error(f"`text` is of type {type(text).__name__}: expected the text of a robot.toml")
        return cls._of(_etalon.Robot.parse(text))

    @classmethod
    def from_dh(
        cls,
        alpha_deg: ArrayLike,
        a_mm: ArrayLike,
        theta_deg: ArrayLike,
        d_mm: ArrayLike,
        *,
        modified: bool = False,
        prismatic: Sequence[bool] | None = None,
        limits: ArrayLike | None = None,
    ) -> Robot:
        """Return a serial arm of Denavit-Hartenberg parameters, from the base; a value for each joint.

        Args:
            alpha_deg: Twists of the links, deg.
            a_mm: Lengths of the links, mm.
            theta_deg: Joint angles at the joint value 0, deg.
            d_mm: Link offsets, mm; of prismatic joints at the joint value 0.
            modified: Modified parameters (Craig) instead of the standard ones.
            prismatic: True for prismatic joints; all are revolute if None.
            limits: Lower and upper limit of each joint, ``(joints, 2)``, deg or mm; infinite without a limit.

        Raises:
            Error: The lengths differ, or angles are in radians.
        """
        stated = {"alpha_deg": alpha_deg, "a_mm": a_mm, "theta_deg": theta_deg, "d_mm": d_mm}
        columns = {name: numbers(values, name).ravel() for name, values in stated.items()}
        count = len(columns["alpha_deg"])
        ends = np.full((count, 2), np.inf) if limits is None else numbers(limits, "limits")
        slides = [False] * count if prismatic is None else [bool(slide) for slide in prismatic]
        if any(len(values) != count for values in columns.values()) or len(slides) != count or ends.shape != (count, 2):
            raise Error("expected one value of each parameter, and limits (joints, 2), for each joint")
        rows = []
        for joint, slide in enumerate(slides):
            keys = {name: repr(float(values[joint])) for name, values in columns.items()}
            if slide:
                keys["prismatic"] = "true"
            if np.isfinite(ends[joint]).all():
                keys["limits_mm" if slide else "limits_deg"] = str([float(end) for end in ends[joint]])
            rows.append("  { " + ", ".join(f"{key} = {value}" for key, value in keys.items()) + " },")
        convention = "mdh" if modified else "dh"
        try:
            return cls.from_toml("\n".join(['model = "serial"', f'convention = "{convention}"', "joint = [", *rows, "]", ""]))
        except Error as error:
            raise error.with_hint("joint-angle-unit", "give degrees: `np.degrees(alpha)`, `np.degrees(theta)`") from None

    @classmethod
    def from_urdf(
        cls,
        path: str | os.PathLike[str],
        base_link: str | None = None,
        tool_link: str | None = None,
    ) -> Robot:
        """Return a chain of a URDF, by default the one with the most moving joints; :attr:`chain` names it."""
        return cls._of(*_urdf_robot(path, base_link, tool_link))

    def with_targets(self, targets: Targets) -> Robot:
        """Return the robot with nominal positions (mm) of targets at the flange: ``{"SMR": (80, 0, 25)}``."""
        return Robot._of(_with_targets(self._native, targets), self._chain)

    @property
    def model(self) -> str:
        """Name of the model: ``serial``, ``urdf``, ``five_bar`` ..."""
        return self._native.model

    @property
    def joints(self) -> list[str]:
        """Columns of the joint values with their units: ``q1_deg``, ``rho1_mm`` ..."""
        return self._native.joints

    @property
    def limits(self) -> NDArray[np.float64]:
        """Lower and upper limit of each joint, ``(joints, 2)``, deg or mm; infinite without a limit."""
        return np.array(self._native.limits)

    @property
    def chain(self) -> Chain | None:
        """The chain of the URDF; None of a robot that was not read from a URDF."""
        return self._chain

    @property
    def parameters(self) -> list[Parameter]:
        """Parameters with their nominal values. Targets are those whose positions are stated; otherwise ``tool``, at the origin of the flange."""
        return [Parameter(*row) for row in self._native.parameters]

    @property
    def toml(self) -> str:
        """Text of the ``robot.toml``."""
        return self._native.toml

    def plot(self, joints: ArrayLike, *, parameters: Any = None, axes: Any = None) -> Any:
        """Draw flange poses at joint values with matplotlib, which ``pip install etalon-robot[plot]`` installs; returns the axes."""
        from ._plots import robot_poses

        return robot_poses(self, joints, parameters, axes)

    def _write(self, folder: Path) -> Path:
        """Write robot.toml, and the URDF of the robot beside it."""
        text, described = self._described()
        name = self._native.description_name
        if described is not None and name is not None:
            text = self._native.text_beside(Path(name).name)
            (folder / Path(name).name).write_text(described, encoding="utf-8")
        (folder / "robot.toml").write_text(text, encoding="utf-8")
        return folder / "robot.toml"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Robot):
            return NotImplemented
        return self._described() == other._described()

    def __hash__(self) -> int:
        return hash(self._described())

    def _described(self) -> tuple[str, str | None]:
        return (self._native.toml, self._native.description)

    def __reduce__(self) -> tuple[Any, ...]:
        return (Robot._restore, (*self._described(), self._chain))

    def __repr__(self) -> str:
        return f"Robot({self.model}: {', '.join(self.joints)})"

    def _repr_html_(self) -> str:
        from .documents import _table

        return f"<h4>Robot: {self.model}</h4>" + _table([parameter._asdict() for parameter in self.parameters])


def robot_of(robot: Robot | str | os.PathLike[str], targets: Targets | None = None) -> _etalon.Robot:
    """Return the native robot of a Robot, a path or a name, with nominal positions of targets."""
    if not isinstance(robot, (Robot, str, os.PathLike)):
        raise Error(f"`robot` is of type {type(robot).__name__}: expected a Robot, a name such as \"ur5e\", or the path of a robot.toml or URDF")
    return _with_targets((robot if isinstance(robot, Robot) else Robot(robot))._native, targets)


def _urdf_robot(path: str | os.PathLike[str], base_link: str | None, tool_link: str | None) -> tuple[_etalon.Robot, Chain]:
    for name, link in (("base_link", base_link), ("tool_link", tool_link)):
        if link is not None and not isinstance(link, str):
            raise Error(f"`{name}` is of type {type(link).__name__}: expected the name of a link")
    if not isinstance(path, (str, os.PathLike)):
        raise Error(f"`path` is of type {type(path).__name__}: expected the path of a URDF")
    path = os.fspath(path)
    native, base, tool, messages = _etalon.Robot.urdf(path, base_link, tool_link)
    warn(Message(stated) for stated in json.loads(messages))
    return native, Chain(base, tool, native.joints)


def _with_targets(robot: _etalon.Robot, targets: Targets | None) -> _etalon.Robot:
    if not targets:
        return robot
    if not isinstance(targets, Mapping):
        raise Error(f"`targets` is of type {type(targets).__name__}: expected positions by name, such as {{\"SMR\": (80, 0, 25)}}")
    for name, position in targets.items():
        refuse_masked(position, f"targets[{name!r}]")
    try:
        stated = {str(name): [float(value) for value in position] for name, position in targets.items()}
    except (TypeError, ValueError) as error:
        raise Error(f"`targets`: expected three numbers (mm) for each target: {error}") from error
    return robot.with_targets(stated)

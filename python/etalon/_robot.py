"""Robots."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from . import _etalon

#: Nominal positions (mm) of targets at the flange, by name.
Targets = Mapping[str, Sequence[float]]


class Parameter(NamedTuple):
    """A parameter of a robot: its name, its unit (mm, deg or 1) and its nominal value."""

    name: str
    unit: str
    nominal: float


def robots() -> list[str]:
    """Return the names of robots whose published geometry etalon has."""
    return _etalon.robot_names()


class Robot:
    """A kinematic model with nominal parameters.

    Args:
        source: A path of a ``robot.toml`` or of a URDF (``.urdf``, ``.xml``); otherwise a name of :func:`robots`, such as ``"ur5e"``.
        targets: Nominal positions (mm) of targets at the flange, beside those of ``[nominal]``: ``{"SMR": (80, 0, 25)}``.

    Raises:
        Error: The file does not read, or there is no robot of this name.
    """

    def __init__(self, source: str | os.PathLike[str], targets: Targets | None = None) -> None:
        path = os.fspath(source)
        if path in robots():
            self._native = _etalon.Robot.named(path)
        elif path.endswith((".urdf", ".xml", ".xacro")):  # xacro is refused by name
            self._native = _etalon.Robot.urdf(path, None, None)
        elif path.endswith(".toml") or os.path.isfile(path):
            self._native = _etalon.Robot.read(path)
        else:
            self._native = _etalon.Robot.named(path)
        self._native = _with_targets(self._native, targets)

    @classmethod
    def _of(cls, native: _etalon.Robot) -> Robot:
        robot = cls.__new__(cls)
        robot._native = native
        return robot

    @classmethod
    def from_toml(cls, text: str) -> Robot:
        """Return the robot that the text of a ``robot.toml`` describes."""
        return cls._of(_etalon.Robot.parse(text))

    @classmethod
    def from_urdf(
        cls,
        path: str | os.PathLike[str],
        base_link: str | None = None,
        tool_link: str | None = None,
    ) -> Robot:
        """Return a chain of a URDF, by default the one with the most moving joints."""
        return cls._of(_etalon.Robot.urdf(os.fspath(path), base_link, tool_link))

    def with_targets(self, targets: Targets) -> Robot:
        """Return the robot with nominal positions (mm) of targets at the flange: ``{"SMR": (80, 0, 25)}``."""
        return Robot._of(_with_targets(self._native, targets))

    @property
    def model(self) -> str:
        """Name of the model: ``serial``, ``urdf``, ``five_bar`` ..."""
        return self._native.model

    @property
    def joints(self) -> list[str]:
        """Columns of the joint values with their units: ``q1_deg``, ``rho1_mm`` ..."""
        return self._native.joints

    @property
    def parameters(self) -> list[Parameter]:
        """Parameters with their nominal values. Targets are those whose positions are stated; otherwise ``tool``, at the origin of the flange."""
        return [Parameter(*row) for row in self._native.parameters]

    @property
    def toml(self) -> str:
        """Text of the ``robot.toml``."""
        return self._native.toml

    def __repr__(self) -> str:
        return f"Robot({self.model}: {', '.join(self.joints)})"

    def _repr_html_(self) -> str:
        from .documents import _table

        return f"<h4>Robot: {self.model}</h4>" + _table([parameter._asdict() for parameter in self.parameters])


def robot_of(robot: Robot | str | os.PathLike[str], targets: Targets | None = None) -> _etalon.Robot:
    """Return the native robot of a Robot, a path or a name, with nominal positions of targets."""
    return _with_targets((robot if isinstance(robot, Robot) else Robot(robot))._native, targets)


def _with_targets(robot: _etalon.Robot, targets: Targets | None) -> _etalon.Robot:
    if not targets:
        return robot
    return robot.with_targets({str(name): [float(value) for value in position] for name, position in targets.items()})

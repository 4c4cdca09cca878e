"""Direct and inverse kinematics of arrays.

Joint values are ``(n, joints)`` in the order of :attr:`etalon.Robot.joints`, in mm and deg; the assembly mode (+1, -1) of a five-bar is the last
column. Poses are those of flange, tool link or platform in the base frame of the robot.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _etalon
from ._errors import Error
from ._robot import Robot, robot_of


@dataclass(frozen=True)
class Poses:
    """Poses.

    Attributes:
        xyz_mm: Positions ``(n, 3)``, mm.
        quaternion: Orientations ``(n, 4)``: w, x, y, z.
    """

    xyz_mm: NDArray[np.float64]
    quaternion: NDArray[np.float64]

    @property
    def matrix(self) -> NDArray[np.float64]:
        """Homogeneous matrices ``(n, 4, 4)``; lengths in mm."""
        w, x, y, z = np.moveaxis(self.quaternion, -1, 0)
        rows = [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
        matrix = np.zeros((len(self.xyz_mm), 4, 4))
        matrix[:, :3, :3] = np.moveaxis(np.array(rows), -1, 0)
        matrix[:, :3, 3] = self.xyz_mm
        matrix[:, 3, 3] = 1.0
        return matrix

    def __len__(self) -> int:
        return len(self.xyz_mm)


def direct(robot: Robot | str | os.PathLike[str], joints: ArrayLike, *, parameters: Any = None) -> Poses:
    """Compute poses from joint values.

    Args:
        robot: The robot, or what :class:`etalon.Robot` takes.
        joints: ``(n, joints)``, mm and deg.
        parameters: A parameters document, or the path of one; nominal values without.

    Returns:
        Poses; NaN where the robot cannot be there.

    Raises:
        Error: The shape is another, or the parameters are those of another robot.
    """
    found = _etalon.direct(robot_of(robot), _rows(joints), json_of(parameters))
    return Poses(found[:, :3], found[:, 3:])


@dataclass(frozen=True)
class Positions:
    """Predicted positions of a target in the world.

    Attributes:
        xyz_mm: Positions ``(n, 3)``, mm; NaN where the robot cannot be there.
        covariance_mm2: Covariances ``(n, 3, 3)`` by the identified parameters, mm2. Errors that the model leaves out are not in it.
    """

    xyz_mm: NDArray[np.float64]
    covariance_mm2: NDArray[np.float64]

    @property
    def standard_uncertainty_mm(self) -> NDArray[np.float64]:
        """Standard uncertainties ``(n, 3)`` of the coordinates (k = 1), mm."""
        return np.sqrt(np.diagonal(self.covariance_mm2, axis1=1, axis2=2))

    def __len__(self) -> int:
        return len(self.xyz_mm)


def predict(robot: Robot | str | os.PathLike[str], parameters: Any, joints: ArrayLike, target: str) -> Positions:
    """Predict positions of a target by identified parameters, with their uncertainties.

    Args:
        robot: The robot, or what :class:`etalon.Robot` takes.
        parameters: The document of :func:`etalon.identify`, or the path of a ``parameters.json``.
        joints: ``(n, joints)``, mm and deg.
        target: Name of an identified target.

    Returns:
        Positions in the world of the calibration: base and target are identified parameters.

    Raises:
        Error: The shape is another, or the parameters are those of another robot or other targets.
    """
    text = json_of(parameters)
    if text is None:
        raise Error("`parameters` is missing: a prediction needs identified parameters")
    xyz_mm, covariance_mm2 = _etalon.predict(robot_of(robot), text, _rows(joints), target)
    return Positions(xyz_mm, covariance_mm2.reshape(-1, 3, 3))


@dataclass(frozen=True)
class Solutions:
    """Joint values of poses.

    Attributes:
        joints: ``(m, joints)``, mm and deg: a row for each solution.
        pose: ``(m,)``: row of the pose of each solution.
        unreachable: Why a pose has no solution, by its row.
    """

    joints: NDArray[np.float64]
    pose: NDArray[np.intp]
    unreachable: dict[int, str]


def inverse(
    robot: Robot | str | os.PathLike[str],
    poses: Poses | ArrayLike,
    *,
    near: ArrayLike | None = None,
    all_solutions: bool = False,
    parameters: Any = None,
) -> Solutions:
    """Compute joint values from poses, within the limits of the robot.

    Args:
        robot: The robot, or what :class:`etalon.Robot` takes.
        poses: Poses, or an array ``(n, 7)`` of x, y, z (mm) and the quaternion w, x, y, z.
        near: Joint values near which the solution is looked for, ``(joints,)`` or ``(n, joints)``; by default those of the pose before. Values that
            reach the pose are the answer; of the family of solutions of a singular pose the nearest is.
        all_solutions: All solutions of each pose instead of the nearest; of robots with at most six joints.
        parameters: A parameters document, or the path of one; nominal values without.

    Raises:
        Error: The shape is another, or the robot has infinitely many solutions.
    """
    rows = np.column_stack([poses.xyz_mm, poses.quaternion]) if isinstance(poses, Poses) else poses
    search = {"near": None if near is None else _rows(near), "all": all_solutions}
    row, joints, missing = _etalon.inverse(robot_of(robot), _rows(rows), search, json_of(parameters))
    return Solutions(joints, np.asarray(row, dtype=np.intp), dict(missing))


def json_of(parameters: Any) -> str | None:
    """Return the JSON text of a document or of the file at a path."""
    if parameters is None:
        return None
    if hasattr(parameters, "to_json"):
        return parameters.to_json()
    with open(parameters, encoding="utf-8") as file:
        return file.read()


def _rows(values: ArrayLike) -> NDArray[np.float64]:
    return np.ascontiguousarray(np.atleast_2d(np.asarray(values, dtype=np.float64)))

"""Direct and inverse kinematics of arrays.

Joint values are ``(n, joints)`` or, of a single pose, ``(joints,)``, in the order of :attr:`etalon.Robot.joints`, in mm and deg; the assembly mode
(+1, -1) of a five-bar is the last column. Poses are those of flange, tool link or platform in the base frame of the robot. The answer to a single
pose is a single answer, without the first dimension.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _etalon
from ._arrays import numbers
from ._errors import Error
from ._robot import Robot, robot_of
from ._tables import file_text

#: Largest deviation of a rotation matrix from an orthogonal one.
_ORTHOGONAL = 1e-6


@dataclass(frozen=True, eq=False)
class Poses:
    """Poses, or a single pose without the first dimension.

    ``poses[3]`` is a single pose, ``poses[:5]`` and ``poses[mask]`` are poses; a loop gives single poses.

    Attributes:
        xyz_mm: Positions ``(n, 3)``, mm.
        quaternion: Orientations ``(n, 4)``: w, x, y, z.
    """

    xyz_mm: NDArray[np.float64]
    quaternion: NDArray[np.float64]

    #: Products with arrays are errors.
    __array_ufunc__ = None

    @classmethod
    def from_matrix(cls, matrix: ArrayLike) -> Poses:
        """Return the poses of homogeneous matrices ``(n, 4, 4)`` or ``(4, 4)``; lengths in mm."""
        stated = numbers(matrix, "matrix")
        if stated.ndim not in (2, 3) or stated.shape[-2:] != (4, 4):
            raise Error(f"`matrix` has the shape {stated.shape}: expected (n, 4, 4) or (4, 4)")
        rotation = stated[..., :3, :3]
        wrong = np.abs(rotation @ np.swapaxes(rotation, -1, -2) - np.eye(3)).max(axis=(-1, -2)) > _ORTHOGONAL
        if np.any(wrong | (np.linalg.det(rotation) < 0)) or not np.allclose(stated[..., 3, :], [0, 0, 0, 1]):
            raise Error("`matrix` is no rigid motion: expected rotations in the first three rows and columns, and 0, 0, 0, 1 in the last row")
        return cls(stated[..., :3, 3].copy(), _quaternion(rotation))

    @property
    def matrix(self) -> NDArray[np.float64]:
        """Homogeneous matrices ``(n, 4, 4)``; lengths in mm."""
        w, x, y, z = np.moveaxis(self.quaternion, -1, 0)
        rows = [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
        matrix = np.zeros((*self.xyz_mm.shape[:-1], 4, 4))
        matrix[..., :3, :3] = np.moveaxis(np.array(rows), (0, 1), (-2, -1))
        matrix[..., :3, 3] = self.xyz_mm
        matrix[..., 3, 3] = 1.0
        return matrix

    @property
    def quaternion_xyzw(self) -> NDArray[np.float64]:
        """Orientations ``(n, 4)`` with the scalar last: x, y, z, w, as ROS and SciPy have them."""
        return np.roll(self.quaternion, -1, axis=-1)

    def inverse(self) -> Poses:
        """Return the inverse poses: the base in the frame of the flange for the flange in the base frame."""
        rotation = np.swapaxes(self.matrix[..., :3, :3], -1, -2)
        return Poses(-(rotation @ self.xyz_mm[..., None])[..., 0], self.quaternion * [1.0, -1.0, -1.0, -1.0])

    def __matmul__(self, other: Poses) -> Poses:
        """Return the poses one after the other, as the product of their matrices: ``flange @ tool``. A single pose applies to all."""
        if not isinstance(other, Poses):
            return NotImplemented
        return Poses.from_matrix(self.matrix @ other.matrix)

    @property
    def single(self) -> bool:
        """True of a single pose."""
        return self.xyz_mm.ndim == 1

    def __len__(self) -> int:
        if self.single:
            raise TypeError("a single pose has no length")
        return len(self.xyz_mm)

    def __getitem__(self, rows: Any) -> Poses:
        if self.single:
            raise TypeError("a single pose has no rows")
        return Poses(self.xyz_mm[rows], self.quaternion[rows])

    def __iter__(self) -> Iterator[Poses]:
        return (self[row] for row in range(len(self)))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Poses):
            return NotImplemented
        return np.array_equal(self.xyz_mm, other.xyz_mm) and np.array_equal(self.quaternion, other.quaternion)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        if self.single:
            return f"Pose(xyz_mm={np.array2string(self.xyz_mm, precision=4)}, quaternion={np.array2string(self.quaternion, precision=6)})"
        return f"Poses({len(self)})\n" + np.array2string(np.column_stack([self.xyz_mm, self.quaternion]), precision=4, suppress_small=True, threshold=70)


def direct(robot: Robot | str | os.PathLike[str], joints: ArrayLike, *, parameters: Any = None) -> Poses:
    """Compute poses from joint values.

    Args:
        robot: The robot, or what :class:`etalon.Robot` takes.
        joints: ``(n, joints)`` or ``(joints,)``, mm and deg; or a DataFrame with the columns :attr:`etalon.Robot.joints`, in any order.
        parameters: A parameters document, its ``to_dict()``, or the path of one; nominal values without.

    Returns:
        Poses; NaN where the robot cannot be there.

    Raises:
        Error: The shape is another, or the parameters belong to another robot.
    """
    native = robot_of(robot)
    rows, single = _joint_rows(joints, native)
    found = _etalon.direct(native, rows, json_of(parameters))
    poses = Poses(found[:, :3], found[:, 3:])
    return poses[0] if single else poses


def jacobian(robot: Robot | str | os.PathLike[str], joints: ArrayLike, *, parameters: Any = None) -> NDArray[np.float64]:
    """Compute the Jacobian of the flange by the joints, in the base frame.

    Rows 0 to 2 are the velocity of the flange (mm), rows 3 to 5 its rotation vector (deg). Columns are the joints, per deg or mm. Derivatives are
    exact.

    Args:
        robot: The robot, or what :class:`etalon.Robot` takes.
        joints: ``(n, joints)`` or ``(joints,)``, mm and deg; or a DataFrame with the columns :attr:`etalon.Robot.joints`, in any order.
        parameters: As in :func:`direct`.

    Returns:
        ``(n, 6, joints)``, or ``(6, joints)`` of a single pose.

    Raises:
        Error: The shape is another, or the robot has no whole pose in space.
    """
    native = robot_of(robot)
    rows, single = _joint_rows(joints, native)
    found = _etalon.jacobian(native, rows, json_of(parameters)).reshape(len(rows), 6, -1)
    return found[0] if single else found


@dataclass(frozen=True, eq=False)
class Sensitivity:
    """Derivatives of the position of a target by the parameters of a robot.

    Attributes:
        parameters: Names of the parameters, one a column.
        matrix: ``(n, 3, parameters)``: mm per mm, deg or 1.
    """

    parameters: list[str]
    matrix: NDArray[np.float64]


def sensitivity(robot: Robot | str | os.PathLike[str], parameters: Any, joints: ArrayLike, target: str) -> Sensitivity:
    """Compute the Jacobian of the position of a target by all parameters, in the world of the calibration.

    Args:
        robot: The robot, or what :class:`etalon.Robot` takes.
        parameters: The document of :func:`etalon.identify`, its ``to_dict()``, or the path of a ``parameters.json``.
        joints: ``(n, joints)`` or ``(joints,)``, mm and deg; or a DataFrame with the columns :attr:`etalon.Robot.joints`, in any order.
        target: Name of an identified target.

    Raises:
        Error: As :func:`predict`.
    """
    native = robot_of(robot)
    rows, single = _joint_rows(joints, native)
    names, found = _etalon.sensitivity(native, _needed(parameters), rows, target)
    matrix = found.reshape(len(rows), 3, -1)
    return Sensitivity(names, matrix[0] if single else matrix)


@dataclass(frozen=True, eq=False)
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
        return np.sqrt(np.diagonal(self.covariance_mm2, axis1=-2, axis2=-1))

    def __len__(self) -> int:
        if self.xyz_mm.ndim == 1:
            raise TypeError("a single position has no length")
        return len(self.xyz_mm)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Positions):
            return NotImplemented
        return np.array_equal(self.xyz_mm, other.xyz_mm, equal_nan=True) and np.array_equal(self.covariance_mm2, other.covariance_mm2, equal_nan=True)

    __hash__ = None  # type: ignore[assignment]


def predict(robot: Robot | str | os.PathLike[str], parameters: Any, joints: ArrayLike, target: str) -> Positions:
    """Predict positions of a target by identified parameters, with their uncertainties.

    Args:
        robot: The robot, or what :class:`etalon.Robot` takes.
        parameters: The document of :func:`etalon.identify`, its ``to_dict()``, or the path of a ``parameters.json``.
        joints: ``(n, joints)`` or ``(joints,)``, mm and deg; or a DataFrame with the columns :attr:`etalon.Robot.joints`, in any order.
        target: Name of an identified target.

    Returns:
        Positions in the world of the calibration: base and target are identified parameters.

    Raises:
        Error: The shape is another, or the parameters belong to another robot or other targets.
    """
    native = robot_of(robot)
    rows, single = _joint_rows(joints, native)
    xyz_mm, covariance_mm2 = _etalon.predict(native, _needed(parameters), rows, target)
    covariance_mm2 = covariance_mm2.reshape(-1, 3, 3)
    return Positions(xyz_mm[0], covariance_mm2[0]) if single else Positions(xyz_mm, covariance_mm2)


class Reason(str):
    """Text of the reason why a pose has no solution.

    Attributes:
        id: ``"no-solution-found"`` (not converged), ``"out-of-reach-by"`` (outside the workspace), ``"joint-beyond-limits"`` ...
    """

    id: str

    def __new__(cls, text: str, id: str) -> Reason:
        reason = super().__new__(cls, text)
        reason.id = id
        return reason

    def __reduce__(self) -> tuple[Any, ...]:
        return (Reason, (str(self), self.id))


@dataclass(frozen=True, eq=False)
class Solutions:
    """Joint values of poses.

    Attributes:
        joints: ``(n, joints)``, mm and deg: a row for each pose, NaN without a solution; of a single pose ``(joints,)``. With ``all_solutions`` a
            row for each solution: ``(m, joints)``.
        pose: Row of the pose of each row of ``joints``.
        unreachable: Why a pose has no solution, by its row.
    """

    joints: NDArray[np.float64]
    pose: NDArray[np.intp]
    unreachable: dict[int, Reason]

    @property
    def reason(self) -> Reason | None:
        """Why the first pose without a solution has none; None if all poses have solutions."""
        return next(iter(self.unreachable.values()), None)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Solutions):
            return NotImplemented
        arrays = [(self.joints, other.joints), (self.pose, other.pose)]
        return all(np.array_equal(own, of, equal_nan=True) for own, of in arrays) and self.unreachable == other.unreachable

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        found = len(set(self.pose.tolist()) - set(self.unreachable))
        joints = np.array2string(self.joints, precision=4, suppress_small=True, threshold=70)
        return f"Solutions({found} poses solved, {len(self.unreachable)} unreachable)\n{joints}" + (f"\nfirst reason: {self.reason}" if self.reason else "")


def inverse(
    robot: Robot | str | os.PathLike[str],
    poses: Poses | ArrayLike,
    *,
    near: ArrayLike | None = None,
    all_solutions: bool = False,
    parameters: Any = None,
) -> Solutions:
    """Compute joint values from poses, within the limits of the robot; joints without limits stay within half a turn of zero.

    Args:
        robot: The robot, or what :class:`etalon.Robot` takes.
        poses: Poses, homogeneous matrices ``(n, 4, 4)`` in mm, or an array ``(n, 7)`` of x, y, z (mm) and the quaternion w, x, y, z. A single pose
            has no first dimension.
        near: Start of the search: ``(joints,)`` for all poses, or ``(n, joints)``, one row for each pose. By default it is the solution of the
            previous pose. If the start reaches the pose, it is the answer. At a singular pose, the answer is the nearest of all solutions.
        all_solutions: All solutions of each pose instead of the nearest; of robots with at most six joints. Solutions that differ by whole turns of
            a joint are one solution.
        parameters: A parameters document, its ``to_dict()``, or the path of one; nominal values without.

    Returns:
        :class:`Solutions`: ``.joints``, and ``.unreachable`` with the reason for each pose without a solution.

    Raises:
        Error: The shape is another, or the robot has infinitely many solutions.
    """
    native = robot_of(robot)
    stated, single = _pose_rows(poses)
    starts = None if near is None else _joint_rows(near, native, "near")[0]
    if starts is not None and len(starts) not in (1, len(stated)):
        raise Error(f"`near` has {len(starts)} rows: expected one, or one for each of the {len(stated)} poses")
    search = {"near": starts, "all": all_solutions}
    try:
        rows, joints, missing = _etalon.inverse(native, stated, search, json_of(parameters))
    except Error as error:
        raise error.with_hint("infinite-solutions", "leave `all_solutions` out to get one solution") from None
    row = np.asarray(rows, dtype=np.intp)
    unreachable = {at: Reason(text, id) for at, id, text in missing}
    if all_solutions:
        return Solutions(joints, row, unreachable)
    nearest = np.full((len(stated), joints.shape[1]), np.nan)
    nearest[row] = joints
    return Solutions(nearest[0] if single else nearest, np.arange(len(stated)), unreachable)


def _joint_rows(joints: ArrayLike, robot: _etalon.Robot, name: str = "joints") -> tuple[NDArray[np.float64], bool]:
    """Return joint values as rows, and whether those of a single pose were given. Columns of a DataFrame are selected by the names of the joints."""
    values = numbers(_joint_columns(joints, robot, name), name)
    if values.ndim not in (1, 2):
        raise Error(f"`{name}` has the shape {values.shape}: expected (n, joints), or (joints,) of a single pose")
    return np.atleast_2d(values), values.ndim == 1


def _joint_columns(joints: Any, robot: _etalon.Robot, name: str) -> ArrayLike:
    """Return the columns of the joints of a DataFrame that names them; other values as they are."""
    headings = [str(heading) for heading in joints.columns] if hasattr(joints, "columns") else []
    missing = [joint for joint in robot.joints if joint not in headings]
    if robot.model == "five_bar" or len(missing) == len(robot.joints):
        return cast(ArrayLike, joints)
    if missing:
        raise Error(f"`{name}` has no columns {', '.join(missing)}: expected a column for each joint, or an array in the order of `Robot.joints`")
    return np.column_stack([np.asarray(joints[joint], dtype=np.float64) for joint in robot.joints])


def _pose_rows(poses: Poses | ArrayLike) -> tuple[NDArray[np.float64], bool]:
    """Return poses as rows of seven numbers, and whether a single pose was given."""
    if not isinstance(poses, Poses):
        stated = numbers(poses, "poses")
        if stated.shape[-1:] == (7,) and stated.ndim in (1, 2):
            turned = np.linalg.norm(stated[..., 3:], axis=-1)
            if np.any(np.abs(turned - 1.0) > _ORTHOGONAL):
                raise Error("`poses`: a quaternion (w, x, y, z) has the norm 1")
            return np.ascontiguousarray(np.atleast_2d(stated)), stated.ndim == 1
        if stated.shape[-2:] != (4, 4) or stated.ndim not in (2, 3):
            raise Error(f"`poses` has the shape {stated.shape}: expected Poses, (n, 4, 4), (4, 4), or (n, 7) with x, y, z, qw, qx, qy, qz")
        poses = Poses.from_matrix(stated)
    rows = np.concatenate([poses.xyz_mm, poses.quaternion], axis=-1)
    return np.ascontiguousarray(np.atleast_2d(rows)), poses.single


def _quaternion(rotation: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the quaternions w, x, y, z of rotation matrices, by their largest component (Shepperd 1978)."""
    r = rotation.reshape(-1, 3, 3)
    xx, yy, zz = r[:, 0, 0], r[:, 1, 1], r[:, 2, 2]
    a, b, c = r[:, 2, 1] - r[:, 1, 2], r[:, 0, 2] - r[:, 2, 0], r[:, 1, 0] - r[:, 0, 1]
    d, e, f = r[:, 1, 0] + r[:, 0, 1], r[:, 0, 2] + r[:, 2, 0], r[:, 2, 1] + r[:, 1, 2]
    # rows of 4 q qᵀ
    rows = np.array([[1 + xx + yy + zz, a, b, c], [a, 1 + xx - yy - zz, d, e], [b, d, 1 - xx + yy - zz, f], [c, e, f, 1 - xx - yy + zz]])
    rows = np.moveaxis(rows, -1, 0)
    largest = np.argmax(np.diagonal(rows, axis1=1, axis2=2), axis=1)
    found = rows[np.arange(len(r)), largest]
    found = found / np.linalg.norm(found, axis=1, keepdims=True)
    signed: NDArray[np.float64] = np.where(found[:, :1] < 0, -found, found)
    return signed.reshape(*rotation.shape[:-2], 4)


def json_of(document: Any, name: str = "parameters") -> str | None:
    """Return the JSON text of a document or of the file at a path."""
    if document is None:
        return None
    if hasattr(document, "to_json"):
        return str(document.to_json())
    if isinstance(document, str) and document.lstrip().startswith("{"):
        return document
    if isinstance(document, (str, os.PathLike)):
        return file_text(document, name)
    if isinstance(document, Mapping):
        return json.dumps(document)
    raise Error(
        f"`{name}` is of type {type(document).__name__}: expected a document of etalon, its `to_dict()`, or the path of its JSON file"
    )


def _needed(parameters: Any) -> str:
    text = json_of(parameters)
    if text is None:
        raise Error("`parameters` is missing: a prediction needs identified parameters")
    return text

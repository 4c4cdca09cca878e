"""Least squares of a chain with NumPy and SciPy: the peers `nominal`, `scipy_dh` and `scipy_poe`.

    least_squares.py MODEL FOLDER PREDICTIONS

FOLDER holds calibration.csv, test_joints.csv and chain.json. MODEL is `nominal` (base and targets alone are fitted), `dh` (small changes of theta,
d, a, alpha and of beta about y behind each joint; Denavit & Hartenberg 1955, Hayati 1983) or `poe` (a small screw before each joint; local product
of exponentials, Chen et al. 2001, Mech. Mach. Theory 36, 1215). Parameters that the data do not separate are left to the trust region of SciPy,
whose steps are the shortest. Intervals are the classical ones: s² (JᵀJ)⁺ of independent residuals, and s² of a new one.
"""

import csv
import json
import pathlib
import sys

import numpy as np
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

SCALE = {"m": 1e3, "mm": 1.0, "deg": np.pi / 180, "rad": 1.0}


def table(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def rotations(vectors):
    return Rotation.from_rotvec(vectors).as_matrix()


def screw(values):
    """Small motions (rotation vector, then shift): n x 6 to n x 4 x 4."""
    values = np.atleast_2d(values)
    t = np.tile(np.eye(4), (len(values), 1, 1))
    t[:, :3, :3] = rotations(values[:, :3])
    t[:, :3, 3] = values[:, 3:]
    return t


def turning(vector):
    """Axes of rotation per unit of each component of a rotation vector (left Jacobian; Solà et al. 2018, eq. 145)."""
    angle = np.linalg.norm(vector)
    if angle < 1e-9:
        return np.eye(3)
    x, y, z = vector
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + (1 - np.cos(angle)) / angle**2 * k + (angle - np.sin(angle)) / angle**3 * k @ k


class Chain:
    def __init__(self, path, model):
        described = json.loads(pathlib.Path(path).read_text())
        self.joints, self.end, self.model = described["joints"], np.array(described["end"]), model
        self.count = {"nominal": 0, "dh": 5, "poe": 6}[model]
        self.origins = [np.array(j["origin"]) for j in self.joints]
        self.aligned = [self.to_z(j["axis"]) for j in self.joints]

    @staticmethod
    def to_z(axis):
        """Rotation that turns z onto the axis."""
        turned = Rotation.align_vectors([axis], [[0, 0, 1]])[0].as_matrix() if axis != [0, 0, 1] else np.eye(3)
        t = np.eye(4)
        t[:3, :3] = turned
        return t

    def parameters(self):
        return self.count * len(self.joints)

    def values(self, rows):
        """Motion of each joint (rad or mm) in each row."""
        out = []
        for j in self.joints:
            unit = j["column"].rsplit("_", 1)[1]
            out.append([j["factor"] * SCALE[unit] * float(r[j["column"]]) + j["offset"] for r in rows])
        return np.array(out)

    def poses(self, x, motions, frames=None):
        """Flange in the base for each row; `frames` takes the frame of the changes of each joint."""
        at = np.tile(np.eye(4), (motions.shape[1], 1, 1))
        x = x.reshape(len(self.joints), self.count)
        for k, j in enumerate(self.joints):
            origin = self.origins[k]
            if self.model == "poe":
                if frames is not None:
                    frames.append(at @ origin)
                origin = origin @ screw(x[k])[0]
            at = at @ origin
            moved = np.zeros((motions.shape[1], 6))
            axis = np.array(j["axis"]) / np.linalg.norm(j["axis"])
            moved[:, slice(3, 6) if j["kind"] == "prismatic" else slice(0, 3)] = motions[k][:, None] * axis
            at = at @ screw(moved)
            if self.model == "dh":
                theta, d, a, alpha, beta = x[k]
                small = screw([[0, 0, theta, 0, 0, d]])[0] @ screw([[alpha, 0, 0, a, 0, 0]])[0] @ screw([[0, beta, 0, 0, 0, 0]])[0]
                if frames is not None:
                    frames.append(at @ self.aligned[k])
                at = at @ self.aligned[k] @ small @ self.aligned[k].T
        return at @ self.end


class Problem:
    """Rows of a table against chain, base and targets."""

    def __init__(self, chain, rows, targets, measured):
        self.chain, self.targets, self.measured = chain, targets, measured
        self.motions = chain.values(rows)
        self.target = np.array([targets.index(r["target"]) for r in rows])
        if measured:
            self.xyz = np.array([[float(r[f"{a}_mm"]) for a in "xyz"] for r in rows])
            self.turned = Rotation.from_quat([[float(r[f"q{a}"]) for a in "xyzw"] for r in rows]) if "qw" in rows[0] else None
            number = lambda name, default: float(rows[0].get(name) or default)
            self.u, self.u_turn = number("u_mm", 1.0), np.radians(number("urot_deg", 1.0))

    def places(self, x, oriented):
        n = self.chain.parameters()
        base, rest = screw(x[n : n + 6] * [1e-3, 1e-3, 1e-3, 1, 1, 1])[0], x[n + 6 :]
        points = rest[: 3 * len(self.targets)].reshape(-1, 3)
        flange = base @ self.chain.poses(x[:n] * self.scale(), self.motions)
        xyz = np.einsum("nij,nj->ni", flange[:, :3, :3], points[self.target]) + flange[:, :3, 3]
        if not oriented:
            return xyz, None
        mounted = rotations(1e-3 * rest[3 * len(self.targets) :].reshape(-1, 3))[self.target]
        return xyz, Rotation.from_matrix(flange[:, :3, :3] @ mounted)

    def jacobian(self, x):
        """Derivatives of the residuals; those of the small changes are taken where they are zero, 1e-3 of them off."""
        oriented = self.turned is not None
        places, turns = self.derivatives(x, oriented)
        rows = (places / self.u).reshape(-1, len(x))
        return np.concatenate([rows, (turns / self.u_turn).reshape(-1, len(x))]) if oriented else rows

    def derivatives(self, x, oriented):
        """Derivatives of positions and of rotations (world axes) for each row: rows x 3 x parameters."""
        n, frames = self.chain.parameters(), []
        base = screw(x[n : n + 6] * [1e-3, 1e-3, 1e-3, 1, 1, 1])[0]
        flange = base @ self.chain.poses(x[:n] * self.scale(), self.motions, frames)
        points = x[n + 6 :][: 3 * len(self.targets)].reshape(-1, 3)
        xyz = np.einsum("nij,nj->ni", flange[:, :3, :3], points[self.target]) + flange[:, :3, 3]
        count = len(xyz)
        places, turns = np.zeros((count, 3, len(x))), np.zeros((count, 3, len(x)))

        def turn(k, axes, origin):
            places[:, :, k] = np.cross(axes, xyz - origin)
            turns[:, :, k] = axes

        scale = self.scale()
        kinds = {"nominal": [], "dh": ["rz", "tz", "tx", "rx", "ry"], "poe": ["rx", "ry", "rz", "tx", "ty", "tz"]}[self.chain.model]
        for j, frame in enumerate(frames):
            frame = base @ frame
            for i, kind in enumerate(kinds):
                k, axes = j * len(kinds) + i, frame[:, :3, "xyz".index(kind[1])]
                if kind[0] == "r":
                    turn(k, axes, frame[:, :3, 3])
                else:
                    places[:, :, k] = axes
                places[:, :, k] *= scale[k]
                turns[:, :, k] *= scale[k]
        about = turning(1e-3 * x[n : n + 3])
        for i in range(3):
            turn(n + i, np.tile(1e-3 * about[:, i], (count, 1)), base[:3, 3])
            places[:, i, n + 3 + i] = 1.0
        for t in range(len(self.targets)):
            own = self.target == t
            k = n + 6 + 3 * t
            places[own, :, k : k + 3] = flange[own, :3, :3]
            if oriented:
                m = n + 6 + 3 * len(self.targets) + 3 * t
                turns[own, :, m : m + 3] = 1e-3 * flange[own, :3, :3] @ turning(1e-3 * x[m : m + 3])
        return places, turns

    def scale(self):
        """Angles in milliradians, so that all parameters have the size of millimetres."""
        one = {"nominal": [], "dh": [1e-3, 1, 1, 1e-3, 1e-3], "poe": [1e-3] * 3 + [1] * 3}[self.chain.model]
        return np.tile(one, len(self.chain.joints))

    def residuals(self, x):
        xyz, turned = self.places(x, self.turned is not None)
        left = ((xyz - self.xyz) / self.u).ravel()
        if turned is None:
            return left
        return np.concatenate([left, ((turned * self.turned.inv()).as_rotvec() / self.u_turn).ravel()])


def start(problem):
    """Base and targets of the nominal chain by least squares, from several turns of the base."""
    oriented, best = problem.turned is not None, None
    for turn in Rotation.create_group("O").as_rotvec():
        x = np.zeros(problem.chain.parameters() + 6 + 3 * len(problem.targets) * (2 if oriented else 1))
        n = problem.chain.parameters()
        x[n : n + 3] = 1e3 * turn
        x[n + 3 : n + 6] = problem.xyz.mean(0)
        few = np.arange(n, len(x))

        def left(y):
            z = x.copy()
            z[few] = y
            return problem.residuals(z)

        def slopes(y):
            z = x.copy()
            z[few] = y
            return problem.jacobian(z)[:, few]

        found = least_squares(left, x[few], slopes, x_scale="jac", max_nfev=60)
        if best is None or found.cost < 0.999 * best[0]:
            z = x.copy()
            z[few] = found.x
            best = (found.cost, z)
    return best[1]


def main(model, folder, answer):
    folder = pathlib.Path(folder)
    rows, wanted = table(folder / "calibration.csv"), table(folder / "test_joints.csv")
    targets = sorted({r["target"] for r in rows})
    chain = Chain(folder / "chain.json", model)
    problem = Problem(chain, rows, targets, True)
    # the start is that of few poses, evenly taken
    some = rows[:: max(1, len(rows) // 40)]
    some += [r for r in rows if r["target"] not in {s["target"] for s in some}][:3]
    nominal = Chain(folder / "chain.json", "nominal")
    first = start(Problem(nominal, some, targets, True))
    x = np.concatenate([np.zeros(chain.parameters()), first])
    found = least_squares(problem.residuals, x, problem.jacobian, ftol=1e-7, xtol=1e-7, gtol=1e-7, max_nfev=40)
    jacobian, oriented = found.jac, problem.turned is not None
    rank = np.linalg.matrix_rank(jacobian, tol=1e-9 * np.linalg.norm(jacobian, 2))
    inverse = np.linalg.pinv(jacobian.T @ jacobian, rcond=1e-12, hermitian=True)
    count = 3 * len(rows)
    free = max(1, len(jacobian) - rank)
    per = lambda r: np.sum(r**2) / len(r) * len(jacobian) / free
    variance, turn_variance = per(found.fun[:count]), per(found.fun[count:]) if oriented else 0.0
    # residuals of both kinds have their own variance
    weight = np.concatenate([np.full(count, variance), np.full(len(jacobian) - count, turn_variance)])
    covariance = inverse @ (jacobian.T * weight) @ jacobian @ inverse
    test = Problem(chain, wanted, targets, False)
    xyz, turned = test.places(found.x, oriented)
    moved = np.concatenate(test.derivatives(found.x, oriented)[: 2 if oriented else 1], axis=1)
    spread = np.einsum("nik,kl,njl->nij", moved, covariance, moved)
    names = ["xx", "xy", "xz", "yy", "yz", "zz"]
    with open(answer, "w", newline="") as file:
        writer = csv.writer(file)
        head = ["pose", "target", "x_mm", "y_mm", "z_mm"] + [f"c{n}_mm2" for n in names]
        writer.writerow(head + (["qw", "qx", "qy", "qz", "urot_deg"] if oriented else []))
        for k, row in enumerate(wanted):
            c = spread[k, :3, :3] + np.eye(3) * variance * problem.u**2
            line = [row["pose"], row["target"], *xyz[k], *(c["xyz".index(a), "xyz".index(b)] for a, b in names)]
            if oriented:
                x_, y_, z_, w_ = turned[k].as_quat()
                own = np.trace(spread[k, 3:, 3:]) / 3 + turn_variance * problem.u_turn**2
                line += [w_, x_, y_, z_, np.degrees(np.sqrt(own))]
            writer.writerow(line)


if __name__ == "__main__":
    main(*sys.argv[1:])

"""Kinematics of the reference campaigns, from their definitions, in the precision of mpmath (mp.dps).

Millimetres and radians. A pose is a pair (R, t): R is a list of three rows, t a list of three coordinates.
Every model has `parameters`, a list of `Parameter`, and computes from a mapping of their names to values.
"""

from collections import namedtuple

from mpmath import acos, atan2, cos, mp, mpf, pi, sin, sqrt

mp.dps = 110

Parameter = namedtuple("Parameter", "name unit role nominal")
"""Name, unit outside (mm, deg or 1), role (robot, base, target or fixture), nominal value in mm, rad or 1."""

ZERO, ONE = mpf(0), mpf(1)


def radians(degrees):
    """Radians of degrees."""
    return mpf(degrees) * pi / 180


def inward(unit, text):
    """Value in mm, rad or 1 of a number in the unit outside."""
    return radians(text) if unit == "deg" else mpf(text)


def outward(unit, value):
    """Value in the unit outside."""
    return value * 180 / pi if unit == "deg" else value


# Vectors and poses


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum((x * y for x, y in zip(a, b)), ZERO)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def norm(a):
    return sqrt(dot(a, a))


def rotate(R, v):
    return [dot(row, v) for row in R]


def product(A, B):
    columns = list(zip(*B))
    return [[dot(row, column) for column in columns] for row in A]


def transposed(R):
    return [list(row) for row in zip(*R)]


IDENTITY = ([[ONE, ZERO, ZERO], [ZERO, ONE, ZERO], [ZERO, ZERO, ONE]], [ZERO, ZERO, ZERO])


def then(first, second):
    """The second pose in the frame of the first."""
    return product(first[0], second[0]), add(first[1], rotate(first[0], second[1]))


def apply(pose, point):
    return add(rotate(pose[0], point), pose[1])


def about(axis, angle):
    """Rotation matrix about a unit vector (Rodrigues)."""
    c, s = cos(angle), sin(angle)
    x, y, z = axis
    v = 1 - c
    return [
        [c + x * x * v, x * y * v - z * s, x * z * v + y * s],
        [y * x * v + z * s, c + y * y * v, y * z * v - x * s],
        [z * x * v - y * s, z * y * v + x * s, c + z * z * v],
    ]


AXIS = {"x": [ONE, ZERO, ZERO], "y": [ZERO, ONE, ZERO], "z": [ZERO, ZERO, ONE]}


def turn(pose, axis, angle):
    """Pose that rotates about a coordinate axis of its own."""
    if not angle:
        return pose
    c, s = cos(angle), sin(angle)
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    R = [list(row) for row in pose[0]]
    for row in R:
        row[i], row[j] = c * row[i] + s * row[j], c * row[j] - s * row[i]
    return R, pose[1]


def shift(pose, axis, length):
    """Pose that translates along a coordinate axis of its own."""
    k = "xyz".index(axis)
    return pose[0], [t + length * row[k] for t, row in zip(pose[1], pose[0])]


def solved(A, b):
    """Solution of linear equations (Gauss with pivots)."""
    n, rows = len(b), [list(row) + [v] for row, v in zip(A, b)]
    for k in range(n):
        best = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[best] = rows[best], rows[k]
        for row in rows[k + 1 :]:
            f = row[k] / rows[k][k]
            row[k:] = [v - f * w for v, w in zip(row[k:], rows[k][k:])]
    x = [ZERO] * n
    for k in reversed(range(n)):
        x[k] = (rows[k][n] - dot(rows[k][k + 1 : n], x[k + 1 :])) / rows[k][k]
    return x


def of_vector(vector):
    """Rotation matrix of a rotation vector."""
    angle = norm(vector)
    return about([v / angle for v in vector], angle) if angle else IDENTITY[0]


def vector_of(R):
    """Rotation vector of a rotation matrix, for an angle below pi."""
    w = [R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]]
    s, c = norm(w) / 2, (R[0][0] + R[1][1] + R[2][2] - 1) / 2
    if not s:
        return [ZERO, ZERO, ZERO]
    return [v * atan2(s, c) / (2 * s) for v in w]


def of_quaternion(w, x, y, z):
    """Rotation matrix of a quaternion of any length."""
    n = w * w + x * x + y * y + z * z
    return [
        [(w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n],
        [2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n],
        [2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n],
    ]


def quaternion_of(R):
    """Quaternion of a rotation matrix, by its rotation vector."""
    v = vector_of(R)
    angle = norm(v)
    return [cos(angle / 2)] + [x / angle * sin(angle / 2) for x in v]


# Planar robots


class Prexyt:
    """Table with three sliders. The platform lies on carriages 2 and 3; C is where the guide of slider 1 crosses it.

    Rail 2 is the y axis. Rail 3 is inclined by beta; its zero is s from rail 2. The guide of slider 1 is inclined by gamma.
    """

    dimension = 2
    joints = [("rho1", "mm"), ("rho2", "mm"), ("rho3", "mm")]
    targets = ["K", "L"]

    def __init__(self, nominal):
        table = [
            ("beta", "deg", "robot"), ("gamma", "deg", "robot"), ("epsilon_theta", "deg", "target"),
            ("s", "mm", "robot"), ("d3", "mm", "robot"), ("d", "mm", "robot"),
            ("x_c", "mm", "target"), ("y_c", "mm", "target"), ("x_o", "mm", "base"), ("y_o", "mm", "base"),
            ("delta", "1", "robot"), ("delta2", "1", "robot"), ("delta3", "1", "robot"), ("l_kl", "mm", "target"),
        ]
        self.parameters = [Parameter(n, unit, role, inward(unit, nominal[n])) for n, unit, role in table]

    def platform(self, p, q):
        """C in the base, and the direction of the platform: two straight lines cross."""
        second = [ZERO, p["delta2"] * q[1]]
        along = p["delta3"] * q[2] + p["d3"] / cos(p["beta"])
        third = [p["s"] - along * sin(p["beta"]), along * cos(p["beta"])]
        run, rise = sub(third, second)
        theta = atan2(rise, run)
        # points a + i u of the platform and b + j v of the guide
        a, u = second, [cos(theta), sin(theta)]
        b, v = [p["delta"] * q[0] + p["d"], ZERO], [sin(p["gamma"]), cos(p["gamma"])]
        i = ((b[0] - a[0]) * v[1] - (b[1] - a[1]) * v[0]) / (u[0] * v[1] - u[1] * v[0])
        return [a[0] + i * u[0], a[1] + i * u[1]], theta

    def positions(self, p, q):
        """Balls K and L in the world: C is at (x_c, y_c) in the frame of K whose x axis points to L."""
        c, theta = self.platform(p, q)
        angle = theta + p["epsilon_theta"]
        u, v = [cos(angle), sin(angle)], [-sin(angle), cos(angle)]
        k = [c[i] + p[("x_o", "y_o")[i]] - p["x_c"] * u[i] - p["y_c"] * v[i] for i in range(2)]
        return {"K": k, "L": [k[i] + p["l_kl"] * u[i] for i in range(2)]}

    def errors_of(self, p, q, measured):
        """Measured minus predicted position of C in the base, and orientation: C and angle by the measured balls."""
        k, l = measured["K"], measured["L"]
        c, theta = self.platform(p, q)
        angle = atan2(l[1] - k[1], l[0] - k[0])
        u, v = [cos(angle), sin(angle)], [-sin(angle), cos(angle)]
        at = [k[i] + p["x_c"] * u[i] + p["y_c"] * v[i] - p[("x_o", "y_o")[i]] for i in range(2)]
        return [("position", sub(at, c)), ("orientation", [angle - p["epsilon_theta"] - theta])]


class FiveBar:
    """Two arms A1 B1 C and A2 B2 C in the plane; the tool E is fixed to the link B2 C. Motors are d apart.

    `assembly` is +1 if C lies on the left of the way from B1 to B2.
    """

    dimension = 2
    joints = [("theta1", "deg"), ("theta2", "deg"), ("assembly", "")]
    targets = ["tool"]

    def __init__(self, nominal):
        table = [
            ("l11", "mm", "robot"), ("l12", "mm", "robot"), ("l21", "mm", "robot"), ("l22", "mm", "robot"),
            ("d", "mm", "robot"), ("l23", "mm", "robot"), ("gamma", "deg", "robot"), ("delta1", "deg", "robot"),
            ("delta2", "deg", "robot"), ("x_o", "mm", "base"), ("y_o", "mm", "base"), ("phi", "deg", "base"),
        ]
        self.parameters = [Parameter(n, unit, role, inward(unit, nominal[n])) for n, unit, role in table]

    def positions(self, p, q):
        angle1, angle2 = q[0] + p["delta1"], q[1] + p["delta2"]
        b1 = [p["l11"] * cos(angle1) - p["d"] / 2, p["l11"] * sin(angle1)]
        b2 = [p["l21"] * cos(angle2) + p["d"] / 2, p["l21"] * sin(angle2)]
        run, rise = sub(b2, b1)
        apart = sqrt(run * run + rise * rise)
        # law of cosines at B1
        opening = acos((p["l12"] ** 2 + apart**2 - p["l22"] ** 2) / (2 * p["l12"] * apart))
        direction = atan2(rise, run) + q[2] * opening
        c = [b1[0] + p["l12"] * cos(direction), b1[1] + p["l12"] * sin(direction)]
        tool = atan2(c[1] - b2[1], c[0] - b2[0]) + p["gamma"]
        e = [b2[0] + p["l23"] * cos(tool), b2[1] + p["l23"] * sin(tool)]
        s, k = sin(p["phi"]), cos(p["phi"])
        return {"tool": [p["x_o"] + k * e[0] - s * e[1], p["y_o"] + s * e[0] + k * e[1]]}


# Robots in space


def base_and_targets(targets):
    base = [Parameter(f"base_{k}", "mm", "base", ZERO) for k in "xyz"]
    base += [Parameter(f"base_r{k}", "deg", "base", ZERO) for k in "xyz"]
    return base + [Parameter(f"{t}_{k}", "mm", "target", ZERO) for t in targets for k in "xyz"]


class Spatial:
    """Robot whose flange is placed by `in_base`, with its base in the world and targets on the flange."""

    dimension = 3

    def flange(self, p, q, in_base=None):
        """Pose of the flange in the world; the base has a rotation vector. `in_base` is its pose in the base, if known."""
        base = of_vector([p[f"base_r{k}"] for k in "xyz"]), [p[f"base_{k}"] for k in "xyz"]
        return then(base, in_base or self.in_base(p, q))


class Table(Spatial):
    """Serial arm of revolute joints in Denavit-Hartenberg parameters.

    Modified: Rx(alpha) Tx(a) [Ry(beta)] Rz(theta + gain q) Tz(d). Standard: Rz(theta + gain q) Tz(d) Tx(a) Rx(alpha) [Ry(beta)].
    A row whose `parallel` is true has beta as a parameter in place of d, which keeps its nominal value.
    """

    def __init__(self, convention, rows, targets):
        self.modified, self.rows, self.targets = convention == "mdh", rows, targets
        self.joints = [(f"q{i + 1}", "deg") for i in range(len(rows))]
        self.parameters = base_and_targets(targets)
        for i, row in enumerate(rows, 1):
            last = ("beta", "deg", "0") if row["parallel"] else ("d", "mm", row["d_mm"])
            table = [("alpha", "deg", row["alpha_deg"]), ("a", "mm", row["a_mm"]), ("theta", "deg", row["theta_deg"]), last]
            self.parameters += [Parameter(f"{n}_{i}", unit, "robot", inward(unit, v)) for n, unit, v in table]
        self.parameters += [Parameter(f"gain_{i + 1}", "1", "robot", ONE) for i in range(len(rows))]

    def in_base(self, p, q):
        pose = IDENTITY
        for i, (row, joint) in enumerate(zip(self.rows, q), 1):
            d = mpf(row["d_mm"]) if row["parallel"] else p[f"d_{i}"]
            link = [(turn, "x", p[f"alpha_{i}"]), (shift, "x", p[f"a_{i}"])]
            along = [(turn, "z", p[f"theta_{i}"] + p[f"gain_{i}"] * joint), (shift, "z", d)]
            hayati = [(turn, "y", p[f"beta_{i}"])] if row["parallel"] else []
            motions = link + hayati + along if self.modified else along + link[::-1] + hayati
            for move, axis, by in motions:
                pose = move(pose, axis, by)
        return pose


def across(direction):
    """The two coordinate axes that are furthest from a direction."""
    along = max("zxy", key=lambda k: abs(direction["xyz".index(k)]))
    return [k for k in "xyz" if k != along]


class Screws(Spatial):
    """Serial arm of revolute screw axes in the base at zero joints, and the flange there (product of exponentials).

    An axis is displaced as a whole by its small errors E = Ta(..) Tb(..) Ra(..) Rb(..) at its stated point, along and about
    the two coordinate axes furthest from its direction: E R(direction, gain q) E^-1.
    """

    def __init__(self, axes, flange_xyz, flange_rpy, targets):
        self.axes, self.targets = axes, targets
        self.joints = [(f"q{i + 1}", "deg") for i in range(len(axes))]
        rx, ry, rz = [radians(v) for v in flange_rpy]
        rotation = product(product(about(AXIS["z"], rz), about(AXIS["y"], ry)), about(AXIS["x"], rx))
        self.home = rotation, [mpf(v) for v in flange_xyz]
        self.parameters = base_and_targets(targets)
        for i, axis in enumerate(axes, 1):
            for kind, unit in (("", "mm"), ("r", "deg")):
                names = [f"q{i}_{kind}{k}" for k in across([mpf(v) for v in axis["direction"]])]
                self.parameters += [Parameter(name, unit, "robot", ZERO) for name in names]
        self.parameters += [Parameter(f"gain_{i + 1}", "1", "robot", ONE) for i in range(len(axes))]

    def in_base(self, p, q):
        pose = IDENTITY
        for i, (axis, joint) in enumerate(zip(self.axes, q), 1):
            direction = [mpf(v) for v in axis["direction"]]
            point = [mpf(v) for v in axis["point_mm"]]
            error = IDENTITY
            for k in across(direction):
                error = shift(error, k, p[f"q{i}_{k}"])
            for k in across(direction):
                error = turn(error, k, p[f"q{i}_r{k}"])
            # the displaced axis in the base
            u = rotate(error[0], direction)
            through = add(point, error[1])
            R = about(u, p[f"gain_{i}"] * joint)
            pose = then(pose, (R, sub(through, rotate(R, through))))
        return then(pose, self.home)


class Urdf(Spatial):
    """Chain of a URDF: origin, small errors of the axis in the frame of the origin, rotation about the axis.

    `links` is a list of joints from the base: name, xyz (m), rpy (rad), and axis (None for a fixed joint).
    """

    def __init__(self, links, targets):
        self.links, self.targets = links, targets
        moving = [link for link in links if link["axis"]]
        self.joints = [(link["name"], "deg") for link in moving]
        self.parameters = base_and_targets(targets)
        for link in moving:
            for kind, unit in (("", "mm"), ("r", "deg")):
                names = [f"{link['name']}_{kind}{k}" for k in across([mpf(v) for v in link["axis"]])]
                self.parameters += [Parameter(name, unit, "robot", ZERO) for name in names]
        self.parameters += [Parameter(f"gain_{link['name']}", "1", "robot", ONE) for link in moving]

    def in_base(self, p, q):
        pose, values = IDENTITY, iter(q)
        for link in self.links:
            rx, ry, rz = [mpf(v) for v in link["rpy"]]
            rotation = product(product(about(AXIS["z"], rz), about(AXIS["y"], ry)), about(AXIS["x"], rx))
            pose = then(pose, (rotation, [1000 * mpf(v) for v in link["xyz"]]))
            if not link["axis"]:
                continue
            axis, name = [mpf(v) for v in link["axis"]], link["name"]
            for k in across(axis):
                pose = shift(pose, k, p[f"{name}_{k}"])
            for k in across(axis):
                pose = turn(pose, k, p[f"{name}_r{k}"])
            unit = [v / norm(axis) for v in axis]
            pose = then(pose, (about(unit, p[f"gain_{name}"] * next(values)), [ZERO, ZERO, ZERO]))
        return pose


class Hexapod(Spatial):
    """Platform on six legs: |R a + t - b| = l0 + q for each leg, with b on the base and a on the platform."""

    def __init__(self, legs, home, targets):
        self.targets, self.home = targets, (IDENTITY[0], [mpf(v) for v in home])
        self.joints = [(f"leg{i + 1}", "mm") for i in range(6)]
        self.parameters = base_and_targets(targets)
        for i, leg in enumerate(legs, 1):
            table = zip(("bx", "by", "bz", "ax", "ay", "az", "l0"), leg["base_mm"] + leg["platform_mm"] + [leg["length_mm"]])
            self.parameters += [Parameter(f"leg{i}_{n}", "mm", "robot", mpf(v)) for n, v in table]
        self.near = {}

    def in_base(self, p, q):
        """Pose of the platform: Newton's method from the pose last found at these joints, until the last digit."""
        base = [[p[f"leg{i}_b{k}"] for k in "xyz"] for i in range(1, 7)]
        own = [[p[f"leg{i}_a{k}"] for k in "xyz"] for i in range(1, 7)]
        length = [p[f"leg{i}_l0"] + q[i - 1] for i in range(1, 7)]
        pose = self.near.get(tuple(q), self.home)
        for _ in range(60):
            levers = [rotate(pose[0], a) for a in own]
            legs = [sub(add(lever, pose[1]), b) for lever, b in zip(levers, base)]
            sizes = [norm(leg) for leg in legs]
            units = [[v / size for v in leg] for leg, size in zip(legs, sizes)]
            system = [u + cross(lever, u) for lever, u in zip(levers, units)]
            step = solved(system, [l - size for l, size in zip(length, sizes)])
            pose = product(of_vector(step[3:]), pose[0]), add(pose[1], step[:3])
            if max(abs(v) for v in step) < mpf(10) ** (-mp.dps * 2 // 3):
                self.near.setdefault(tuple(q), pose)
                return pose
        raise ArithmeticError("the legs do not meet the platform")


class Delta(Spatial):
    """Platform on three rods that hang on rotating arms; it translates and does not rotate.

    In the frame of a leg, whose x axis points outwards, the motor is at (base_radius, base_side, base_height); its arm turns
    about the y axis of Rz(axis_rz) Rx(axis_rx), is level at zero and sinks as the angle grows.
    """

    def __init__(self, common, targets):
        self.targets, self.azimuths = targets, [radians(v) for v in (0, 120, 240)]
        self.joints = [(f"theta{i + 1}", "deg") for i in range(3)]
        self.parameters = base_and_targets(targets)
        for i in (1, 2, 3):
            table = [
                ("base_radius", "mm", common["base_radius_mm"]), ("base_side", "mm", "0"), ("base_height", "mm", "0"),
                ("axis_rz", "deg", "0"), ("axis_rx", "deg", "0"), ("upper_arm", "mm", common["upper_arm_mm"]),
                ("delta", "deg", "0"), ("rod", "mm", common["rod_mm"]), ("platform_radius", "mm", common["platform_radius_mm"]),
            ]
            self.parameters += [Parameter(f"{n}_{i}", unit, "robot", inward(unit, v)) for n, unit, v in table]

    def in_base(self, p, q):
        """Lower of the two places of the platform at which every rod has its length."""
        spheres = []
        for i, (azimuth, joint) in enumerate(zip(self.azimuths, q), 1):
            angle = joint + p[f"delta_{i}"]
            motor = [p[f"base_radius_{i}"] - p[f"platform_radius_{i}"], p[f"base_side_{i}"], p[f"base_height_{i}"]]
            leg = turn(IDENTITY, "z", azimuth)[0]
            axes = turn(turn((leg, rotate(leg, motor)), "z", p[f"axis_rz_{i}"]), "x", p[f"axis_rx_{i}"])
            arm = [p[f"upper_arm_{i}"] * cos(angle), ZERO, -p[f"upper_arm_{i}"] * sin(angle)]
            spheres.append((apply(axes, arm), p[f"rod_{i}"]))
        # differences of the spheres are two planes; their line is x = u + v z, y = ...
        (c0, r0), others = spheres[0], spheres[1:]
        rows = [(sub(c, c0), (dot(c, c) - dot(c0, c0) - r * r + r0 * r0) / 2) for c, r in others]
        (m, a), (n, b) = rows
        det = m[0] * n[1] - m[1] * n[0]
        u = [(a * n[1] - b * m[1]) / det, (m[0] * b - n[0] * a) / det]
        v = [(-m[2] * n[1] + n[2] * m[1]) / det, (-m[0] * n[2] + n[0] * m[2]) / det]
        # |u + v z - c0| = r0
        e = [u[0] - c0[0], u[1] - c0[1]]
        square = v[0] ** 2 + v[1] ** 2 + 1
        half = v[0] * e[0] + v[1] * e[1] - c0[2]
        rest = e[0] ** 2 + e[1] ** 2 + c0[2] ** 2 - r0**2
        z = (-half - sqrt(half**2 - square * rest)) / square
        return IDENTITY[0], [u[0] + v[0] * z, u[1] + v[1] * z, z]

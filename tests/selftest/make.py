"""Reference values of `etalon selftest`, to 24 digits: src/run/selftest/data/fits.json and kinematics.json.

Independent of etalon, in mpmath with 60 digits. Elements: orthogonal distances of synthetic points are minimised by
Gauss-Newton with numeric derivatives. Kinematics: 4x4 matrices for chains, intersections of lines and circles for planar
robots, and Newton's method on the lengths of the legs for platforms.
Run in the root of the repository: python3 tests/selftest/make.py
"""

import hashlib
import json
import pathlib
import random
import re

from mpmath import cos, eye, findroot, matrix, mp, mpf, pi, sin, sqrt

mp.dps = 60
STEP = mpf(10) ** -22


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def norm(a):
    return sqrt(dot(a, a))


def unit(a):
    return [x / norm(a) for x in a]


def direction(u, v):
    """Polar angle and azimuth: never near a pole for the data below."""
    return [sin(u) * cos(v), sin(u) * sin(v), cos(u)]


def off_axis(p, at, d):
    return norm(cross(minus(p, at), d))


# residuals of one point by the parameters of an element
def line(x, p):
    d, at = direction(x[3], x[4]), x[:3]
    w = minus(p, at)
    a = unit(cross(d, [mpf(1), mpf(0), mpf(0)]))
    return [dot(w, a), dot(w, cross(d, a))]


def plane(x, p):
    return [dot(minus(p, x[:3]), direction(x[3], x[4]))]


def circle2d(x, p):
    return [norm(minus(p[:2], x[:2])) - x[2]]


def circle3d(x, p):
    d = direction(x[3], x[4])
    w = minus(p, x[:3])
    return [norm(cross(d, w)) - x[5], dot(w, d)]


def sphere(x, p):
    return [norm(minus(p, x[:3])) - x[3]]


def cylinder(x, p):
    return [off_axis(p, x[:3], direction(x[3], x[4])) - x[5]]


def cone(x, p):
    d = direction(x[3], x[4])
    w = minus(p, x[:3])
    return [(norm(cross(d, w)) - x[5]) * cos(x[6]) - dot(w, d) * sin(x[6])]


def torus(x, p):
    d = direction(x[3], x[4])
    w = minus(p, x[:3])
    return [sqrt((norm(cross(d, w)) - x[5]) ** 2 + dot(w, d) ** 2) - x[6]]


def solve(residual, x, points, count, fixed):
    """Least squares; rows in `fixed`, with a weight that leaves them no variance, keep the point of an axis at the foot of the
    centroid."""
    x = [mpf(v) for v in x]

    def all_rows(x):
        rows = [r for p in points for r in residual(x, p)]
        return rows, [mpf(10) ** 15 * v for v in fixed(x)]

    for _ in range(60):
        rows, held = all_rows(x)
        n, m = len(x), len(rows)
        jacobian = matrix(m + len(held), n)
        for j in range(n):
            up, down = list(x), list(x)
            up[j] += STEP
            down[j] -= STEP
            (a, c), (b, e) = all_rows(up), all_rows(down)
            for i, (v, w) in enumerate(zip(a + c, b + e)):
                jacobian[i, j] = (v - w) / (2 * STEP)
        right = matrix(rows + held)
        normal = jacobian.T * jacobian
        step = mp.lu_solve(normal, -(jacobian.T * right))
        x = [v + s for v, s in zip(x, step)]
        if max(abs(s) for s in step) < mpf(10) ** -35:
            break
    rows, held = all_rows(x)
    # the normal matrix has a condition of 10^30 or more: 30 of 60 digits are left
    squares = dot(rows, rows)
    degrees = len(rows) - (n - len(held))
    inverse = normal ** -1
    return x, rows, squares, degrees, inverse


def main():
    random.seed(20261126)
    true = (1.1, 0.7)
    d = [float(v) for v in direction(*true)]
    a = [float(v) for v in unit(cross(d, [1, 0, 0]))]
    b = [float(v) for v in cross(d, a)]
    at = [312.5, -140.25, 77.125]

    def place(u, v, w):
        noise = [random.gauss(0, 0.004) for _ in range(3)]
        return [round(at[i] + u * a[i] + v * b[i] + w * d[i] + noise[i], 4) for i in range(3)]

    import math

    def ring(radius, angle, w):
        return place(radius * math.cos(angle), radius * math.sin(angle), w)

    angles = [0.3 + 0.43 * i for i in range(14)]
    shapes = {
        "line": (line, [place(0, 0, -40 + 9.0 * i) for i in range(11)], [*at, *true], True),
        "plane": (plane, [place(20 * math.cos(t * 3), 35 * math.sin(t * 5), 0) for t in angles], [*at, *true], False),
        "circle2d": (circle2d, [[*ring(40, t, 0)[:2], 0.0] for t in angles], None, False),
        "circle3d": (circle3d, [ring(40, t, 0) for t in angles[:9]], [*at, *true, 40], False),
        "sphere": (sphere, [ring(25 * math.cos(t / 7 - 0.4), t, 25 * math.sin(t / 7 - 0.4)) for t in angles],
                   [*at, 25], False),
        "cylinder": (cylinder, [ring(18, t, 4.0 * i - 30) for i, t in enumerate(angles)], [*at, *true, 18], True),
        "cone": (cone, [ring(30 + 0.3 * (4.0 * i - 26), t, 4.0 * i - 26) for i, t in enumerate(angles)],
                 [*at, *true, 30, math.atan(0.3)], True),
        "torus": (torus, [ring(60 + 11 * math.cos(2.3 * t), t, 11 * math.sin(2.3 * t)) for t in angles + [6.4, 6.9]],
                  [*at, *true, 60, 11], False),
    }
    # the circle in the plane has points of its own, and a noise that the other shapes share
    flat = [[round(40 * math.cos(t) + 5.5 + random.gauss(0, 0.004), 4),
             round(40 * math.sin(t) - 3.25 + random.gauss(0, 0.004), 4), 0.0] for t in angles[:8]]
    shapes["circle2d"] = (circle2d, flat, [5.5, -3.25, 40], False)
    out = []
    for name, (residual, points, start, has_axis) in shapes.items():
        exact = [[mpf(str(v)) for v in p] for p in points]
        middle = [sum(p[i] for p in exact) / len(exact) for i in range(3)]

        def fixed(x):
            w = minus(x[:3], middle)
            if name == "plane":
                across = direction(x[3], x[4])
                u = unit(cross(across, [mpf(1), mpf(0), mpf(0)]))
                return [dot(w, u), dot(w, cross(across, u))]
            return [dot(w, direction(x[3], x[4]))] if has_axis else []

        x, rows, squares, degrees, inverse = solve(residual, start, exact, len(exact), fixed)
        spatial = name not in ("circle2d",)
        point = x[:3] if spatial else [x[0], x[1], mpf(0)]
        axis = direction(x[3], x[4]) if name not in ("circle2d", "sphere") else []
        size = {"circle2d": x[2:3], "circle3d": x[5:6], "sphere": x[3:4], "cylinder": x[5:6], "torus": x[5:7],
                "cone": [x[5], 2 * x[6]] if name == "cone" else []}.get(name, [])
        radius = {"circle2d": 2, "circle3d": 5, "sphere": 3, "cylinder": 5, "cone": 5, "torus": 5}.get(name)
        spread = sqrt(squares / degrees)
        digits = lambda v: mp.nstr(v, 24, strip_zeros=False)
        out.append({
            "element": name,
            "points_mm": points,
            "point_mm": [digits(v) for v in point],
            "direction": [digits(v) for v in axis],
            "sizes": [digits(v) for v in size],
            "squares_mm2": digits(squares),
            "radius_uncertainty_mm": digits(spread * sqrt(inverse[radius, radius])) if radius is not None else None,
        })
    write("fits", out)


def write(name, out):
    """One list of numbers a line."""
    text = json.dumps(out, indent=1)
    text = re.sub(r"\[\s+([^][{}]*?)\s+\]", lambda m: "[" + re.sub(r"\s+", " ", m.group(1)) + "]", text)
    with open(f"src/run/selftest/data/{name}.json", "w") as file:
        file.write(text + "\n")


# kinematics: millimetres and degrees outside, as in robot.toml
def deg(v):
    return mpf(str(v)) * pi / 180


def number(v):
    return mpf(str(v))


def turn(axis, angle):
    """Rotation matrix about a direction (Rodrigues), 4x4."""
    x, y, z = unit([mpf(v) for v in axis])
    s, c, out = sin(angle), cos(angle), eye(4)
    k = matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    r = eye(3) + s * k + (1 - c) * k * k
    for i in range(3):
        for j in range(3):
            out[i, j] = r[i, j]
    return out


def shift(x, y, z):
    out = eye(4)
    out[0, 3], out[1, 3], out[2, 3] = x, y, z
    return out


X, Y, Z = [1, 0, 0], [0, 1, 0], [0, 0, 1]


def rpy(r, p, y):
    return turn(Z, deg(y)) * turn(Y, deg(p)) * turn(X, deg(r))


def rotation_vector(v):
    angles = [deg(a) for a in v]
    size = norm(angles)
    return turn(angles, size) if size else eye(4)


def applied(frame, at):
    p = frame * matrix([number(v) for v in at] + [1])
    return [p[0], p[1], p[2]]


def base_of(nominal):
    at = shift(*(number(nominal[f"base_{k}"]) for k in "xyz"))
    return at * rotation_vector([nominal[f"base_r{k}"] for k in "xyz"])


def target_of(nominal):
    return [nominal[f"ball_{k}"] for k in "xyz"]


BASE = {"base_x": 101.5, "base_y": -53.2, "base_z": 12.7, "base_rx": 10.0, "base_ry": -20.0, "base_rz": 35.0,
        "ball_x": 12.3, "ball_y": -4.5, "ball_z": 33.0}


def table(**values):
    return "\n[nominal]\n" + "".join(f"{k} = {v}\n" for k, v in values.items())


def inline(**values):
    return "{ " + ", ".join(f"{k} = {json.dumps(v)}" for k, v in values.items()) + " }"


def serial_table(convention):
    rows = [(0.3, 1.2, 1.0, 290.5), (-89.8, 0.4, -90.4, 0.7), (0.15, 270.3, 0.5, 0.8), (-90.1, 70.1, 0.2, 302.4),
            (90.2, 0.2, -0.7, 0.9), (-89.9, -0.3, 180.3, 72.6)]
    parallel = [i == 2 for i in range(6)]
    if convention == "dh":
        # a twist of more than three degrees after each joint: no axes are near-parallel
        rows = [(-89.8, 0.4, 1.0, 290.5), (4.2, 270.3, -90.4, 0.7), (-90.1, 70.1, 0.5, 0.8), (90.2, 0.2, 0.2, 302.4),
                (-89.9, -0.3, -0.7, 0.9), (5.5, 0.6, 180.3, 72.6)]
        parallel = [False] * 6
    effects = {"gain_2": 1.0004, "gain_5": 0.9993, "harmonic_3_sin1": 0.02, "harmonic_3_cos1": -0.03,
               "harmonic_3_sin2": 0.011, "harmonic_3_cos2": 0.017, "coupling_6_5": 0.002}
    joints = ",\n".join("    " + inline(alpha_deg=a, a_mm=l, theta_deg=t, d_mm=d, parallel=p)
                        for (a, l, t, d), p in zip(rows, parallel))
    text = f'model = "serial"\nconvention = "{convention}"\nharmonics = [3]\ncoupling = [[6, 5]]\n'
    text += f"joint = [\n{joints}\n]\n" + table(**BASE, **effects)

    def place(q):
        frame = base_of(BASE)
        for i, (alpha, a, theta, d) in enumerate(rows):
            angle = deg(q[i]) * number(effects.get(f"gain_{i + 1}", 1.0))
            if i == 2:
                for name, order, wave in (("sin1", 1, sin), ("cos1", 1, cos), ("sin2", 2, sin), ("cos2", 2, cos)):
                    angle += deg(effects[f"harmonic_3_{name}"]) * wave(order * deg(q[i]))
            if i == 5:
                angle += number(effects["coupling_6_5"]) * deg(q[4])
            link = turn(X, deg(alpha)), shift(number(a), 0, 0)
            moved = turn(Z, deg(theta) + angle) * shift(0, 0, number(d))
            frame = frame * (link[0] * link[1] * moved if convention == "mdh" else moved * link[1] * link[0])
        return [applied(frame, target_of(BASE))]

    return text, ARM, place


ARM = [[20.0, -35.0, 40.0, 60.0, -70.0, 110.0], [-75.0, 12.0, -25.0, -130.0, 55.0, -20.0], [140.0, 48.0, 15.0, 33.0, 88.0, 5.0]]


def serial_screws():
    axes = [([0.01, -0.02, 1.0], [1.0, 2.0, 0.0], False), ([0.02, 1.0, 0.01], [0.0, 0.0, 290.0], False),
            ([0.0, 0.999, 0.03], [0.5, 0.0, 560.0], False), ([1.0, 0.01, 0.02], [0.0, 0.3, 630.0], False),
            ([-0.02, 1.0, 0.0], [302.0, 0.0, 630.0], False), ([0.1, 0.2, 1.0], None, True)]
    home, angles = [374.0, 1.0, 630.0], [10.0, 85.0, -20.0]
    joints = ",\n".join("    " + (inline(direction=d, prismatic=True) if p else inline(direction=d, point_mm=at))
                        for d, at, p in axes)
    text = f'model = "serial"\nconvention = "poe"\nflange_xyz_mm = {home}\nflange_rpy_deg = {angles}\n'
    text += f"joint = [\n{joints}\n]\n" + table(**BASE)

    def place(q):
        frame = base_of(BASE)
        for (d, at, slides), value in zip(axes, q):
            along = unit([number(v) for v in d])
            if slides:
                frame = frame * shift(*(number(value) * v for v in along))
            else:
                frame = frame * shift(*map(number, at)) * turn(along, deg(value)) * shift(*(-number(v) for v in at))
        return [applied(frame * shift(*map(number, home)) * rpy(*angles), target_of(BASE))]

    return text, [[20.0, -35.0, 40.0, 60.0, -70.0, 25.0], [-75.0, 12.0, -25.0, -130.0, 55.0, 80.0]], place


def urdf():
    joints = [("lift", "prismatic", [0.1, -0.02, 0.4], [0.02, -0.01, 0.3], [0.03, 0.01, 1.0]),
              ("pan", "revolute", [0.05, 0.01, 0.2], [0.1, 0.2, -0.3], [0.0, 0.02, 1.0]),
              ("elbow", "revolute", [0.3, -0.04, 0.06], [-1.2, 0.4, 0.7], [0.3, -0.5, 0.8]),
              ("wrist", "revolute", [0.02, 0.31, 0.01], [0.5, -0.6, 1.1], [-1.0, 0.02, 0.01])]
    xml = '<robot name="arm">\n  <link name="base"/>\n'
    parent = "base"
    for name, kind, xyz, angles, axis in joints:
        row = lambda v: " ".join(map(str, v))
        limit = '<limit lower="-3" upper="3" effort="1" velocity="1"/>'
        xml += (f'  <link name="{name}_link"/>\n  <joint name="{name}" type="{kind}"><parent link="{parent}"/>'
                f'<child link="{name}_link"/><origin xyz="{row(xyz)}" rpy="{row(angles)}"/><axis xyz="{row(axis)}"/>'
                f"{limit}</joint>\n")
        parent = f"{name}_link"
    xml += "</robot>\n"
    text = 'model = "urdf"\nfile = "arm.urdf"\nbase_link = "base"\ntool_link = "wrist_link"\n' + table(**BASE)

    def place(q):
        frame = base_of(BASE)
        for (_, kind, xyz, angles, axis), value in zip(joints, q):
            r, p, y = map(number, angles)
            frame = frame * shift(*(1000 * number(v) for v in xyz)) * turn(Z, y) * turn(Y, p) * turn(X, r)
            along = unit([number(v) for v in axis])
            if kind == "prismatic":
                frame = frame * shift(*(number(value) * v for v in along))
            else:
                frame = frame * turn(along, deg(value))
        return [applied(frame, target_of(BASE))]

    return text, [[250.0, 33.0, -71.0, 104.0], [610.0, -120.0, 25.0, -48.0]], place, xml


def prexyt():
    n = {"beta": -0.42, "gamma": 0.83, "epsilon_theta": -0.37, "s": 393.93, "d3": 0.85, "d": 116.23, "x_c": 73.09,
         "y_c": -73.02, "x_o": 23.34, "y_o": -30.71, "delta": 0.9992, "delta2": 0.9996, "delta3": 0.9998, "l_kl": 146.02}
    v = {k: deg(x) if k in ("beta", "gamma", "epsilon_theta") else number(x) for k, x in n.items()}

    def place(rho):
        # thesis, figure 3.3: the line through the revolute joints 2 and 3, and the guide of carriage 1
        rho = [number(r) for r in rho]
        tan = lambda a: sin(a) / cos(a)
        joint2 = [mpf(0), v["delta2"] * rho[1]]
        reach = v["delta3"] * rho[2]
        joint3 = [v["s"] - reach * sin(v["beta"]) - v["d3"] * tan(v["beta"]), reach * cos(v["beta"]) + v["d3"]]
        run, rise = joint3[0] - joint2[0], joint3[1] - joint2[1]
        # (x, y) = joint2 + k (run, rise), and x - y tan(gamma) = delta rho1 + d
        k = (v["delta"] * rho[0] + v["d"] + joint2[1] * tan(v["gamma"])) / (run - rise * tan(v["gamma"]))
        centre = [joint2[0] + k * run, joint2[1] + k * rise]
        theta = mp.atan2(rise, run) + v["epsilon_theta"]
        s, c = sin(theta), cos(theta)
        ball = [centre[0] + v["x_o"] - (v["x_c"] * c - v["y_c"] * s), centre[1] + v["y_o"] - (v["x_c"] * s + v["y_c"] * c)]
        return [[*ball, mpf(0)], [ball[0] + v["l_kl"] * c, ball[1] + v["l_kl"] * s, mpf(0)]]

    return 'model = "prexyt"\n' + table(**n), [[0.0, 10.0, 44.0], [85.0, 150.0, 170.0], [170.0, 300.0, 255.0]], place


def five_bar():
    n = {"l11": 230.3, "l12": 229.6, "l21": 230.8, "l22": 229.1, "d": 274.7, "l23": 231.4, "gamma": 0.9, "delta1": 0.35,
         "delta2": -0.27, "x_o": 262.6, "y_o": 75.8, "phi": 1.3}
    angles = ("gamma", "delta1", "delta2", "phi")
    v = {k: deg(x) if k in angles else number(x) for k, x in n.items()}

    def place(q):
        q1, q2, mode = deg(q[0]) + v["delta1"], deg(q[1]) + v["delta2"], q[2]
        b1 = [-v["d"] / 2 + v["l11"] * cos(q1), v["l11"] * sin(q1)]
        b2 = [v["d"] / 2 + v["l21"] * cos(q2), v["l21"] * sin(q2)]
        # two circles by the law of cosines: C is to the left of b1 -> b2 in mode +1
        between = minus(b2, b1)
        far = norm(between)
        along = (v["l12"] ** 2 - v["l22"] ** 2 + far**2) / (2 * far)
        aside = mode * sqrt(v["l12"] ** 2 - along**2)
        u = [between[0] / far, between[1] / far]
        c = [b1[0] + along * u[0] - aside * u[1], b1[1] + along * u[1] + aside * u[0]]
        link = minus(c, b2)
        s, k = sin(v["gamma"]), cos(v["gamma"])
        grown = v["l23"] / v["l22"]
        e = [b2[0] + grown * (link[0] * k - link[1] * s), b2[1] + grown * (link[0] * s + link[1] * k)]
        s, k = sin(v["phi"]), cos(v["phi"])
        return [[v["x_o"] + e[0] * k - e[1] * s, v["y_o"] + e[0] * s + e[1] * k, mpf(0)]]

    joints = [[95.0, 80.0, 1.0], [95.0, 80.0, -1.0], [20.0, -140.0, 1.0], [-65.0, -115.0, -1.0]]
    return 'model = "five_bar"\n' + table(**n), joints, place


def platform(rods, guess):
    """Pose whose platform joints are at the lengths of the rods: six unknowns, or three without rotation."""
    turns = len(rods) == 6

    def gaps(*x):
        frame = shift(*x[:3]) * (turn(Z, x[5]) * turn(Y, x[4]) * turn(X, x[3]) if turns else eye(4))
        return [norm(minus(applied_exact(frame, a), b)) - length for b, a, length in rods]

    x = findroot(gaps, guess if turns else guess[:3], tol=mpf(10) ** -90, maxsteps=60)
    return shift(x[0], x[1], x[2]) * (turn(Z, x[5]) * turn(Y, x[4]) * turn(X, x[3]) if turns else eye(4))


def applied_exact(frame, at):
    p = frame * matrix(list(at) + [1])
    return [p[0], p[1], p[2]]


def hexapod():
    ring = lambda radius, angle: [round(radius * float(cos(deg(angle))), 3), round(radius * float(sin(deg(angle))), 3)]
    base = [[*ring(300.5, a), 0.4 * i] for i, a in enumerate((-10, 11, 109, 131, 229, 251))]
    top = [[*ring(150.2, a), -0.3 * i] for i, a in enumerate((-50, 51, 69, 171, 189, 291))]
    lengths = [380.0 + 0.7 * i for i in range(6)]
    legs = ",\n".join("    " + inline(base_mm=b, platform_mm=a, length_mm=l) for b, a, l in zip(base, top, lengths))
    text = f'model = "hexapod"\nhome_xyz_mm = [0.0, 0.0, 400.0]\nleg = [\n{legs}\n]\n' + table(**BASE)

    def place(q):
        rods = [([number(v) for v in b], [number(v) for v in a], number(l) + number(j))
                for b, a, l, j in zip(base, top, lengths, q)]
        return [applied(base_of(BASE) * platform(rods, [0, 0, 400, 0, 0, 0]), target_of(BASE))]

    return text, [[91.3, 61.0, 16.7, 40.4, 67.4, 75.1], [65.9, 20.4, 35.8, 55.9, 73.1, 56.4]], place


def delta():
    n = {}
    for i in (1, 2, 3):
        n |= {f"base_radius_{i}": 200.0 + 0.4 * i, f"base_side_{i}": 0.3 * i - 0.5, f"base_height_{i}": 0.6 - 0.2 * i,
              f"axis_rz_{i}": 0.2 * i - 0.3, f"axis_rx_{i}": 0.5 - 0.3 * i, f"upper_arm_{i}": 235.0 - 0.3 * i,
              f"delta_{i}": 0.4 - 0.15 * i, f"rod_{i}": 800.0 + 0.5 * i, f"platform_radius_{i}": 45.0 + 0.1 * i}
    text = 'model = "delta"\nbase_radius_mm = 200.0\nplatform_radius_mm = 45.0\nupper_arm_mm = 235.0\nrod_mm = 800.0\n'

    def place(q):
        rods = []
        for i, value in enumerate(q, 1):
            own = lambda name: number(n[f"{name}_{i}"])
            leg = turn(Z, deg(120 * (i - 1)))
            motor = leg * shift(own("base_radius"), own("base_side"), own("base_height"))
            motor = motor * turn(Z, deg(n[f"axis_rz_{i}"])) * turn(X, deg(n[f"axis_rx_{i}"]))
            elbow = motor * turn(Y, deg(value) + deg(n[f"delta_{i}"])) * shift(own("upper_arm"), 0, 0)
            joint = leg * shift(own("platform_radius"), 0, 0)
            rods.append(([elbow[k, 3] for k in range(3)], [joint[k, 3] for k in range(3)], own("rod")))
        return [applied(base_of(BASE) * platform(rods, [0, 0, -900]), target_of(BASE))]

    return text + table(**BASE, **n), [[14.1, 30.8, -20.3], [43.2, -24.7, 23.8]], place


def delta_linear():
    n = {}
    for i in (1, 2, 3):
        n |= {f"offset_{i}": 0.5 * i - 0.7, f"tower_ry_{i}": 0.2 * i - 0.3, f"tower_rx_{i}": 0.5 - 0.3 * i,
              f"base_radius_{i}": 220.0 + 0.3 * i, f"base_side_{i}": 0.3 * i - 0.5, f"rod_{i}": 420.0 + 0.4 * i,
              f"platform_radius_{i}": 40.0 + 0.1 * i}
    text = 'model = "delta_linear"\nbase_radius_mm = 220.0\nplatform_radius_mm = 40.0\nrod_mm = 420.0\n'

    def place(q):
        rods = []
        for i, value in enumerate(q, 1):
            own = lambda name: number(n[f"{name}_{i}"])
            leg = turn(Z, deg(120 * (i - 1)))
            tower = leg * shift(own("base_radius"), own("base_side"), 0)
            tower = tower * turn(Y, deg(n[f"tower_ry_{i}"])) * turn(X, deg(n[f"tower_rx_{i}"]))
            carriage = tower * shift(0, 0, number(value) + own("offset"))
            joint = leg * shift(own("platform_radius"), 0, 0)
            rods.append(([carriage[k, 3] for k in range(3)], [joint[k, 3] for k in range(3)], own("rod")))
        return [applied(base_of(BASE) * platform(rods, [0, 0, -200]), target_of(BASE))]

    return text + table(**BASE, **n), [[119.4, 165.2, 191.8], [211.7, 102.1, 226.1]], place


def kinematics():
    out = []
    models = {"serial mdh": serial_table("mdh"), "serial dh": serial_table("dh"), "serial poe": serial_screws(),
              "urdf": urdf(), "prexyt": prexyt(), "five_bar": five_bar(), "hexapod": hexapod(), "delta": delta(),
              "delta_linear": delta_linear()}
    for name, (text, joints, place, *more) in models.items():
        targets = [[mp.nstr(v, 24, strip_zeros=False) for p in place(q) for v in p] for q in joints]
        out.append({"model": name, "robot": text, "urdf": more[0] if more else None, "joints": joints, "targets_mm": targets})
    write("kinematics", out)


# characteristics by the formulas of ISO 9283:1998 (7.2 to 7.7, 8.2, 8.3, 8.6, 10)
def mean(values):
    return sum(values) / len(values)


def deviation(values):
    return sqrt(sum((v - mean(values)) ** 2 for v in values) / (len(values) - 1))


def middle(points):
    return [mean([p[k] for p in points]) for k in range(3)]


def closeness(points):
    radii = [norm(minus(p, middle(points))) for p in points]
    return mean(radii) + 3 * deviation(radii)


def standards():
    random.seed(9283)
    at, other = [500.0, -300.0, 800.0], [900.0, -600.0, 800.0]

    def cloud(middle, sigma, count):
        off = [random.uniform(-0.2, 0.2) for _ in range(3)]
        return [[round(m + o + random.gauss(0, s), 4) for m, o, s in zip(middle, off, sigma)] for _ in range(count)]

    sigma = [0.01, 0.03, 0.02]
    clouds = [cloud(at, sigma, 30) for _ in range(3)] + [cloud(other, sigma, 30)]
    angles = [round(0.7 + random.gauss(0.002, 0.001), 6) for _ in range(30)]
    forces = [(10.0 * i, [round(random.gauss(0, 0.002), 4), 0.0, round(-0.011 * i + random.gauss(0, 0.001), 4)])
              for i in range(1, 11)]
    command = [[20.0 * i, 0.0, 0.0] for i in range(6)]
    passes = [[[c[0], round(random.gauss(0.05, 0.02), 4), round(random.gauss(-0.03, 0.02), 4)] for c in command]
              for _ in range(10)]
    times = [[round(0.2 * i + random.gauss(0, 0.002), 6) for i in range(6)] for _ in range(10)]
    a, b, c, far = [[[number(v) for v in p] for p in points] for points in clouds]
    at_, other_ = [number(v) for v in at], [number(v) for v in other]
    turned = [number(v) for v in angles]
    lengths = [norm(minus(q, p)) for p, q in zip(a, far)]
    sets = [a[:10], a[10:20], a[20:]]
    far_from = lambda points: norm(minus(middle(points), at_))
    exact = [[[number(v) for v in p] for p in points] for points in passes]
    at_each = [[p[i] for p in exact] for i in range(6)]
    loaded = [(number(f), dot([number(v) for v in d], [0, 0, -1])) for f, d in forces]
    speeds = []
    for points, when in zip(exact, times):
        whole = [norm(minus(q, p)) / (number(t1) - number(t0))
                 for p, q, t0, t1 in zip(points, points[1:], when, when[1:])]
        speeds.append(whole)
    means = [mean(v) for v in speeds]
    expected = {
        "AP": far_from(a),
        "AP_x": middle(a)[0] - at_[0],
        "RP": closeness(a),
        "RP_y": 3 * deviation([p[1] for p in a]),
        "AP_a": mean(turned) - number(0.7),
        "RP_a": 3 * deviation(turned),
        "vAP": max(norm(minus(middle(p), middle(q))) for p, q in ((a, b), (a, c), (b, c))),
        "AD": mean(lengths) - norm(minus(other_, at_)),
        "RD": 3 * deviation(lengths),
        "AD_y": mean([abs(q[1] - p[1]) for p, q in zip(a, far)]) - abs(other_[1] - at_[1]),
        "dAP": abs(far_from(sets[2]) - far_from(sets[0])),
        "dRP": abs(closeness(sets[2]) - closeness(sets[0])),
        "E": norm(minus(middle(a), middle(b))),
        "AT": max(norm(minus(middle(p), c)) for p, c in zip(at_each, [[number(v) for v in c] for c in command])),
        "RT": max(closeness(p) for p in at_each),
        "AV": (mean(means) - 100) / 100 * 100,
        "RV": 3 * deviation(means),
        "FV": max(max(v) - min(v) for v in speeds),
        "compliance": sum(f * d for f, d in loaded) / sum(f * f for f, _ in loaded),
    }
    write("iso9283", {
        "at_mm": at, "other_mm": other, "clouds_mm": clouds, "angles_rad": angles, "commanded_rad": 0.7,
        "command_mm": command, "passes_mm": passes, "times_s": times, "commanded_mm_s": 100.0,
        "forces_n": [f for f, _ in forces], "displacements_mm": [d for _, d in forces],
        "expected": {k: mp.nstr(v, 24, strip_zeros=False) for k, v in expected.items()},
    })


def hashes():
    """SHA-256 of all files that the program embeds as reference data."""
    data, sample = "src/run/selftest/data/", "samples/prexyt-cmm/"
    names = [(f"{data}{name}.json", f"{name}.json") for name in ("fits", "iso9283", "kinematics", "published")]
    names += [(sample + name, f"prexyt-cmm/{name}") for name in
              ("campaign.toml", "encoders.csv", "robot.toml", "truth.toml", "exports/poses.txt", "exports/world.txt")]
    for folder in sorted(pathlib.Path("samples/reference").iterdir()):
        if folder.is_dir():
            names += [(str(file), f"reference/{folder.name}/{file.name}") for file in sorted(folder.iterdir())]
    with open(f"{data}sha256.txt", "w") as out:
        for path, name in names:
            with open(path, "rb") as file:
                out.write(f"{hashlib.sha256(file.read()).hexdigest()}  {name}\n")


if __name__ == "__main__":
    main()
    kinematics()
    standards()
    hashes()

"""The twelve reference campaigns: robots, poses and synthetic readings, drawn from fixed seeds."""

import math
import random

from mpmath import mp, mpf, pi

from kinematics import (
    Delta, FiveBar, Hexapod, Parameter, Prexyt, Screws, Table, Urdf, apply, inward, norm, of_vector, product, quaternion_of, radians,
    solved, sub,
)

SYNTHETIC = "made by tests/reference/campaigns/make.py from a seed; nobody measured them"
SCALE = {"mm": mpf(1), "deg": mpf(1), "1": mpf(1)}
"""Least scale of a value to which permissible errors are relative, by its unit."""
MM_DIGITS, DEG_DIGITS, QUATERNION_DIGITS = 4, 6, 9
"""Decimals of lengths, angles and quaternions in the tables: the rounded numbers are exact inputs."""


def fixed(value, digits):
    """A number with this many decimals."""
    n = int(mp.nint(mpf(value) * mpf(10) ** digits))
    sign, n = ("-" if n < 0 else ""), abs(n)
    return f"{sign}{n // 10**digits}.{n % 10**digits:0{digits}d}"


class Draw:
    """Numbers from a seed; only `random()` of Python is used, which is the same in all its versions."""

    def __init__(self, seed):
        self.source = random.Random(seed)

    def uniform(self, low, high):
        return low + (high - low) * self.source.random()

    def normal(self):
        a, b = 1.0 - self.source.random(), self.source.random()
        return mpf(math.sqrt(-2.0 * math.log(a)) * math.cos(2.0 * math.pi * b))


class Campaign:
    """A campaign: model, true values and files.

    `deviations` are half-widths of the drawn deviations of the robot's parameters from nominal by unit (mm, deg, 1);
    `stated` are true values of base, targets and fixtures, in units outside.
    """

    def __init__(self, name, title, seed, build, robot, **more):
        self.name, self.title, self.seed, self.build_model, self.robot = name, title, seed, build, robot
        self.sigma_mm, self.sigma_rad = mpf(more["sigma_mm"]), None
        self.sigma_deg = more.get("sigma_deg")
        self.calibration, self.validation = more["poses"]
        self.deviations = more.get("deviations", {"mm": 0.3, "deg": 0.1, "1": 2e-4})
        self.stated = more.get("stated", {})
        self.fixtures = more.get("fixtures", [])
        self.tolerances = more.get("tolerances", {})
        self.hold = more.get("hold", [])
        self.fixed_by_model = more.get("fixed_by_model", lambda p: False)
        self.draw_poses, self.observe = more["joints"], more["observe"]
        self.blunder = more.get("blunder")
        self.more_files = more.get("files", {})
        self.identify = more.get("identify", [])
        self.files = ["campaign.toml", "observations.csv", "robot.toml", *self.more_files]

    @property
    def left_out(self):
        return self.blunder and self.blunder[:2]

    def build(self):
        model = self.build_model()
        model.parameters += [Parameter(n, unit, "fixture", mpf(0)) for n, unit in self.fixtures]
        if self.sigma_deg:
            self.sigma_rad = radians(self.sigma_deg)
        return model

    def is_held(self, parameter):
        return parameter.name in self.hold or self.fixed_by_model(parameter)

    def priors(self):
        """Nominal value and standard uncertainty t / sqrt(3) of each parameter with a tolerance t."""
        model = self.build()
        unit = {p.name: p for p in model.parameters}
        return {n: (unit[n].nominal, inward(unit[n].unit, t) / mp.sqrt(3)) for n, t in self.tolerances.items()}

    def true_values(self):
        draw = Draw(f"{self.seed} robot")
        values = {}
        for p in self.build().parameters:
            by = fixed(draw.uniform(-1.0, 1.0) * self.deviations[p.unit], 8)
            if p.name in self.stated:
                values[p.name] = inward(p.unit, self.stated[p.name])
            elif p.role == "robot" and not self.is_held(p):
                values[p.name] = p.nominal + inward(p.unit, by)
            else:
                values[p.name] = p.nominal
        return values

    def write(self):
        """Text of each file."""
        model, truth = self.build(), self.true_values()
        draw = Draw(f"{self.seed} readings")
        rows = self.observe(self, model, truth, draw)
        columns = list(dict.fromkeys(name for row in rows for name in row))
        lines = [",".join(columns)] + [",".join(row.get(name, "") for name in columns) for row in rows]
        files = {"observations.csv": "\n".join(lines) + "\n", "robot.toml": self.robot, "campaign.toml": self.toml()}
        return files | self.more_files

    def toml(self):
        k = 2
        lines = [
            f'name = "Reference: {self.title}"',
            'robot = "robot.toml"',
            f'synthetic = "{SYNTHETIC}"',
            "",
            "[instrument]",
            'name = "simulated"',
            f"expanded_uncertainty_um = {mp.nstr(self.sigma_mm * 1000 * k, 6)}",
        ]
        if self.sigma_deg:
            lines.append(f"expanded_rotation_uncertainty_deg = {mp.nstr(mpf(self.sigma_deg) * k, 6)}")
        lines += [f"coverage_factor = {k}", "", "[observations]", 'file = "observations.csv"', "", "[identify]"]
        lines += [f'prior = "{"tolerances" if self.tolerances else "none"}"']
        if self.hold:
            lines.append("hold = [" + ", ".join(f'"{n}"' for n in self.hold) + "]")
        lines += self.identify
        lines += [f'calibration = "1-{self.calibration}"', 'validation = "rest"']
        return "\n".join(lines) + "\n"


# Readings


def joint_cells(model, joints):
    return {(f"{n}_{unit}" if unit else n): text for (n, unit), text in zip(model.joints, joints)}


def read_joints(model, joints):
    return [inward(unit, text) for (_, unit), text in zip(model.joints, joints)]


def noisy(campaign, draw, at):
    return [v + campaign.sigma_mm * draw.normal() for v in at]


def positions(campaign, model, truth, draw):
    """Every target at every pose."""
    rows = []
    for pose in range(1, campaign.calibration + campaign.validation + 1):
        joints = campaign.draw_poses(draw, pose)
        q = read_joints(model, joints)
        if model.dimension == 2:
            places = model.positions(truth, q)
        else:
            flange = model.flange(truth, q)
            places = {t: apply(flange, [truth[f"{t}_{k}"] for k in "xyz"]) for t in model.targets}
        for target, place in places.items():
            at = noisy(campaign, draw, place)
            if campaign.blunder and campaign.blunder[:2] == (pose, target):
                axis, by = campaign.blunder[2:]
                at[axis] += mpf(by)
            cells = {f"{k}_mm": fixed(v, MM_DIGITS) for k, v in zip("xyz", at)}
            rows.append({"pose": str(pose), "target": target} | joint_cells(model, joints) | cells)
    return rows


def poses_of_probe(campaign, model, truth, draw):
    """Position and orientation of a body at every pose."""
    (target,) = model.targets
    rows = []
    for pose in range(1, campaign.calibration + campaign.validation + 1):
        joints = campaign.draw_poses(draw, pose)
        flange = model.flange(truth, read_joints(model, joints))
        at = noisy(campaign, draw, apply(flange, [truth[f"{target}_{k}"] for k in "xyz"]))
        body = product(flange[0], of_vector([truth[f"{target}_r{k}"] for k in "xyz"]))
        body = product(of_vector([campaign.sigma_rad * draw.normal() for _ in range(3)]), body)
        cells = {f"{k}_mm": fixed(v, MM_DIGITS) for k, v in zip("xyz", at)}
        cells |= {f"q{k}": fixed(v, QUATERNION_DIGITS) for k, v in zip("wxyz", quaternion_of(body))}
        rows.append({"kind": "pose", "pose": str(pose), "target": target} | joint_cells(model, joints) | cells)
    return rows


KNOWN_U_MM = "0.004"


def known_distances(truth, names, draw):
    """Certificate: the distance of every pair of points."""
    rows = []
    for i, one in enumerate(names):
        for other in names[:i]:
            apart = norm(sub(*[[truth[f"{n}_{k}"] for k in "xyz"] for n in (one, other)]))
            text = fixed(apart + mpf(KNOWN_U_MM) * draw.normal(), MM_DIGITS)
            cells = {"kind": "distance", "pose": "", "target": one, "other": other, "distance_mm": text, "u_mm": KNOWN_U_MM}
            rows.append(cells)
    return rows


def wires(anchors):
    """Distances of the target from every anchor at every pose, and of the anchors from each other."""

    def observe(campaign, model, truth, draw):
        (target,) = model.targets
        rows = []
        for pose in range(1, campaign.calibration + campaign.validation + 1):
            joints = campaign.draw_poses(draw, pose)
            at = apply(model.flange(truth, read_joints(model, joints)), [truth[f"{target}_{k}"] for k in "xyz"])
            for anchor in anchors:
                (apart,) = noisy(campaign, draw, [norm(sub(at, [truth[f"{anchor}_{k}"] for k in "xyz"]))])
                cells = {"other": anchor, "distance_mm": fixed(apart, MM_DIGITS), "u_mm": ""}
                rows.append({"kind": "distance", "pose": str(pose), "target": target} | joint_cells(model, joints) | cells)
        return rows + known_distances(truth, anchors, draw)

    return observe


def contacts(sockets):
    """A ball in one socket after the other, each in many postures, and the distances of the sockets."""

    def reach(model, truth, start, place, target):
        """Joint values near `start` at which the target is at a place: Newton's method in the first three joints."""
        q, h = list(start), mpf(10) ** -20
        at = lambda q: apply(model.flange(truth, q), [truth[f"{target}_{k}"] for k in "xyz"])
        for _ in range(30):
            here = at(q)
            gap = sub(place, here)
            moved = [at(q[:j] + [q[j] + h] + q[j + 1 :]) for j in range(3)]
            step = solved([[(there[i] - here[i]) / h for there in moved] for i in range(3)], gap)
            longest = max(abs(v) for v in step)
            q[:3] = [v + s * min(1, mpf("0.3") / longest) for v, s in zip(q, step)]
            if longest < mpf(10) ** -15:
                return q if all(abs(v) < mpf("2.8") for v in q[:3]) else None
        return None

    def observe(campaign, model, truth, draw):
        (target,) = model.targets
        rows, pose = [], 0
        digits, mp.dps = mp.dps, 40
        while pose < campaign.calibration + campaign.validation:
            socket = sockets[pose % len(sockets)]
            start = read_joints(model, campaign.draw_poses(draw, pose))
            place = noisy(campaign, draw, [truth[f"{socket}_{k}"] for k in "xyz"])
            try:
                q = reach(model, truth, start, place, target)
            except ZeroDivisionError:
                q = None
            if q is None:
                continue
            pose += 1
            joints = [fixed(v * 180 / pi, DEG_DIGITS) for v in q]
            cells = {"socket": socket}
            rows.append({"kind": "contact", "pose": str(pose), "target": target} | joint_cells(model, joints) | cells)
        mp.dps = digits
        return rows + known_distances(truth, sockets, draw)

    return observe


def within(*ranges, digits=DEG_DIGITS):
    """Joint values drawn within ranges."""
    return lambda draw, pose: [fixed(draw.uniform(*r), digits) for r in ranges]


# Robots


def stated(**points):
    return {f"{name}_{k}": v for name, values in points.items() for k, v in zip(("x", "y", "z", "rx", "ry", "rz"), values)}


def nominal_toml(name, model, nominal):
    lines = [f'name = "{name}"', f'model = "{model}"', "", "[nominal]"]
    return "\n".join(lines + [f"{k} = {v}" for k, v in nominal.items()]) + "\n"


def with_tolerances(toml, tolerances):
    return toml + "\n[tolerance]\n" + "".join(f"{k} = {v}\n" for k, v in tolerances.items())


PREXYT = {
    "beta": "0.0", "gamma": "0.0", "epsilon_theta": "0.0", "s": "394.0", "d3": "0.0", "d": "116.0", "x_c": "73.0",
    "y_c": "-73.0", "x_o": "22.5", "y_o": "-30.5", "delta": "1.0", "delta2": "1.0", "delta3": "1.0", "l_kl": "146.0",
}
PREXYT_TOML = nominal_toml("PreXYT", "prexyt", PREXYT)
PREXYT_STATED = {"epsilon_theta": "0.05", "x_c": "73.21", "y_c": "-72.87", "x_o": "22.31", "y_o": "-30.72", "l_kl": "146.012"}
PREXYT_NEAR = {"epsilon_theta": "0.006", "x_c": "73.021", "y_c": "-72.987", "x_o": "22.481", "y_o": "-30.522", "l_kl": "146.009"}
PREXYT_TOLERANCES = {
    "beta": "0.01", "gamma": "0.01", "epsilon_theta": "0.02", "s": "0.05", "d3": "0.05", "d": "0.05", "x_c": "0.05", "y_c": "0.05",
    "x_o": "0.05", "y_o": "0.05", "delta": "0.0001", "delta2": "0.0001", "delta3": "0.0001", "l_kl": "0.02",
}

FIVE_BAR = {
    "l11": "230.0", "l12": "230.0", "l21": "230.0", "l22": "230.0", "d": "275.0", "l23": "230.0", "gamma": "0.0",
    "delta1": "0.0", "delta2": "0.0", "x_o": "263.0", "y_o": "75.0", "phi": "0.0",
}


def five_bar_joints(draw, pose):
    """Encoder angles of both assembly modes, with the distal links at least 25 deg from a common line."""
    while True:
        q = [fixed(draw.uniform(*r), DEG_DIGITS) for r in ((30, 150), (30, 150))]
        assembly = "1" if pose % 2 else "-1"
        angle = [math.radians(float(v)) for v in q]
        run = 230 * math.cos(angle[1]) + 275 - 230 * math.cos(angle[0])
        rise = 230 * (math.sin(angle[1]) - math.sin(angle[0]))
        apart = math.hypot(run, rise)
        if 120 < apart < 400:
            return q + [assembly]


def table_rows(*rows):
    keys = ("alpha_deg", "a_mm", "theta_deg", "d_mm", "parallel")
    return [dict(zip(keys, row)) for row in rows]


def table_toml(name, convention, rows):
    lines = [f'name = "{name}"', 'model = "serial"', f'convention = "{convention}"', "joint = ["]
    for row in rows:
        cells = ", ".join(f"{k} = {row[k]}" for k in ("alpha_deg", "a_mm", "theta_deg", "d_mm"))
        lines.append(f"    {{ {cells}{', parallel = true' if row['parallel'] else ''} }},")
    return "\n".join(lines + ["]"]) + "\n"


MDH = table_rows(
    ("0.0", "0.0", "0.0", "290.0", False), ("-90.0", "0.0", "-90.0", "0.0", False), ("0.0", "270.0", "0.0", "0.0", True),
    ("-90.0", "70.0", "0.0", "302.0", False), ("90.0", "0.0", "0.0", "0.0", False), ("-90.0", "0.0", "180.0", "72.0", False),
)
DH = table_rows(
    ("90.0", "0.0", "0.0", "160.0", False), ("0.0", "-430.0", "0.0", "0.0", True), ("0.0", "-395.0", "0.0", "0.0", True),
    ("90.0", "0.0", "0.0", "135.0", False), ("-90.0", "0.0", "0.0", "100.0", False), ("0.0", "0.0", "0.0", "98.0", False),
)
MDH_TOML = table_toml("Arm (invented), modified Denavit-Hartenberg", "mdh", MDH)
DH_TOML = table_toml("Arm (invented), standard Denavit-Hartenberg", "dh", DH)

SCREWS = [
    {"direction": d, "point_mm": p}
    for d, p in [
        (["0", "0", "1"], ["0", "0", "0"]), (["0", "1", "0"], ["40", "0", "310"]), (["0", "1", "0"], ["40", "0", "680"]),
        (["1", "0", "0"], ["0", "0", "720"]), (["0", "1", "0"], ["390", "0", "720"]), (["1", "0", "0"], ["0", "0", "720"]),
    ]
]
FLANGE_XYZ, FLANGE_RPY = ["470", "0", "720"], ["0", "90", "0"]


def screws_toml():
    numbers = lambda values: "[" + ", ".join(f"{float(v)}" for v in values) + "]"
    lines = ['name = "Arm (invented), screw axes"', 'model = "serial"', 'convention = "poe"']
    lines += [f"flange_xyz_mm = {numbers(FLANGE_XYZ)}", f"flange_rpy_deg = {numbers(FLANGE_RPY)}", "joint = ["]
    lines += [f"    {{ direction = {numbers(a['direction'])}, point_mm = {numbers(a['point_mm'])} }}," for a in SCREWS]
    return "\n".join(lines + ["]"]) + "\n"


URDF = [
    {"name": n, "xyz": xyz.split(), "rpy": rpy.split(), "axis": axis and axis.split()}
    for n, xyz, rpy, axis in [
        ("turret", "0 0 0.145", "0 0 0", "0 0 1"), ("shoulder", "0.07 0 0.21", "-1.5 0 0.1", "0 0 1"),
        ("elbow", "0.36 0.02 0", "0 0 0.3", "0 0 1"), ("forearm", "0.06 0.01 0.05", "1.4 0 -0.2", "0 0.6 0.8"),
        ("wrist", "0 -0.05 0.33", "-1.2 0.1 0", "0 0 1"), ("flange", "0 0.04 0.06", "1.3 0 0", "0 0 1"),
        ("tool", "0 0 0.09", "0 0.2 0", None),
    ]
]


def urdf_file():
    links = ["base_link"] + [f"{joint['name']}_link" for joint in URDF]
    lines = ['<?xml version="1.0"?>', '<robot name="invented">'] + [f'  <link name="{link}"/>' for link in links]
    for parent, child, joint in zip(links, links[1:], URDF):
        kind = "revolute" if joint["axis"] else "fixed"
        lines.append(f'  <joint name="{joint["name"]}" type="{kind}">')
        lines.append(f'    <parent link="{parent}"/><child link="{child}"/>')
        lines.append(f'    <origin xyz="{" ".join(joint["xyz"])}" rpy="{" ".join(joint["rpy"])}"/>')
        if joint["axis"]:
            lines.append(f'    <axis xyz="{" ".join(joint["axis"])}"/><limit lower="-3.1" upper="3.1"/>')
        lines.append("  </joint>")
    return "\n".join(lines + ["</robot>"]) + "\n"


URDF_TOML = 'name = "Arm (invented), URDF"\nmodel = "urdf"\nfile = "arm.urdf"\nbase_link = "base_link"\ntool_link = "tool_link"\n'

LEGS = [
    {"base_mm": b.split(), "platform_mm": a.split(), "length_mm": "380.0"}
    for b, a in [
        ("295.442 -52.094 0.0", "96.418 -114.907 0.0"), ("295.442 52.094 0.0", "96.418 114.907 0.0"),
        ("-102.606 281.908 0.0", "51.303 140.954 0.0"), ("-192.836 229.813 0.0", "-147.721 26.047 0.0"),
        ("-192.836 -229.813 0.0", "-147.721 -26.047 0.0"), ("-102.606 -281.908 0.0", "51.303 -140.954 0.0"),
    ]
]
HOME = ["0.0", "0.0", "400.0"]


def hexapod_toml():
    numbers = lambda values: "[" + ", ".join(values) + "]"
    lines = ['name = "Hexapod (invented)"', 'model = "hexapod"', f"home_xyz_mm = {numbers(HOME)}", "leg = ["]
    for leg in LEGS:
        ends = f"base_mm = {numbers(leg['base_mm'])}, platform_mm = {numbers(leg['platform_mm'])}"
        lines.append(f"    {{ {ends}, length_mm = {leg['length_mm']} }},")
    return "\n".join(lines + ["]"]) + "\n"


DELTA = {"base_radius_mm": "200.0", "platform_radius_mm": "45.0", "upper_arm_mm": "235.0", "rod_mm": "800.0"}
DELTA_TOML = "\n".join(['name = "Delta (invented)"', 'model = "delta"'] + [f"{k} = {v}" for k, v in DELTA.items()]) + "\n"

WORLD = ["812.5", "-340.25", "155.75", "1.2", "-0.8", "31.5"]
SIX_AXES = within((-150, 150), (-60, 60), (-70, 50), (-150, 150), (-110, 110), (-170, 170))
UR_AXES = within((-150, 150), (-150, -30), (-120, 120), (-150, 150), (-150, 150), (-170, 170))
THREE = {"T1": ["60.5", "12.25", "85.0"], "T2": ["-48.0", "55.5", "90.75"], "T3": ["-20.25", "-64.0", "70.5"]}


def gains_of_arm(parameter):
    """Gains of revolute joints of arms are 1: the encoder of a geared joint has no unknown ratio."""
    return parameter.name.startswith("gain_")


def arm_without_world(parameter):
    """Nothing is measured in a world: the base is the world."""
    return gains_of_arm(parameter) or parameter.role == "base"


def points(*names):
    return [(f"{name}_{k}", "mm") for name in names for k in "xyz"]


DH_HELD = ["theta_1", "d_1", "alpha_6", "a_6", "theta_6", "d_6"]
DH_TOLERANCES = {
    f"{n}_{i}": {"alpha": "0.012", "a": "0.06", "theta": "0.02", "beta": "0.012", "d": "0.06"}[n]
    for i, row in enumerate(DH, 1)
    for n in ("alpha", "a", "theta", "beta" if row["parallel"] else "d")
}

ALL = [
    Campaign(
        "prexyt-clean", "PreXYT, two balls, plain least squares", 4601, lambda: Prexyt(PREXYT), PREXYT_TOML,
        sigma_mm="0.0015", poses=(24, 12), observe=positions, stated=PREXYT_STATED,
        joints=within((5, 165), (5, 295), (5, 295), digits=MM_DIGITS),
    ),
    Campaign(
        "prexyt-rank-deficient", "PreXYT, slider 1 stands still: its offset and gain are not separable", 4602,
        lambda: Prexyt(PREXYT), PREXYT_TOML, sigma_mm="0.0015", poses=(20, 10), observe=positions, stated=PREXYT_STATED,
        joints=within((85, 85), (5, 295), (5, 295), digits=MM_DIGITS),
    ),
    Campaign(
        "prexyt-priors", "PreXYT, five poses and tolerances of all nominal values", 4607, lambda: Prexyt(PREXYT),
        with_tolerances(PREXYT_TOML, PREXYT_TOLERANCES), sigma_mm="0.003", poses=(5, 10), observe=positions,
        stated=PREXYT_NEAR, tolerances=PREXYT_TOLERANCES, joints=within((5, 165), (5, 295), (5, 295), digits=MM_DIGITS),
        deviations={"mm": 0.03, "deg": 0.006, "1": 6e-5},
    ),
    Campaign(
        "five-bar", "DexTAR, both assembly modes, plain least squares", 4604, lambda: FiveBar(FIVE_BAR),
        nominal_toml("DexTAR", "five_bar", FIVE_BAR), sigma_mm="0.005", poses=(40, 20), observe=positions,
        stated={"x_o": "263.31", "y_o": "74.82", "phi": "0.12"}, joints=five_bar_joints,
    ),
    Campaign(
        "serial-dh", "Six axes in standard Denavit-Hartenberg parameters, three targets", 4605, lambda: Table("dh", DH, list(THREE)),
        DH_TOML, sigma_mm="0.02", poses=(30, 15), observe=positions, stated=stated(base=WORLD, **THREE), joints=UR_AXES,
        fixed_by_model=gains_of_arm,
    ),
    Campaign(
        "serial-dh-priors", "Six axes in standard Denavit-Hartenberg parameters, one target, ten poses and tolerances", 4616,
        lambda: Table("dh", DH, ["T1"]), with_tolerances(DH_TOML, DH_TOLERANCES), sigma_mm="0.01", poses=(10, 15),
        observe=positions, stated=stated(base=WORLD, T1=THREE["T1"]), joints=UR_AXES, hold=DH_HELD,
        tolerances={n: t for n, t in DH_TOLERANCES.items() if n not in DH_HELD}, fixed_by_model=gains_of_arm,
        deviations={"mm": 0.05, "deg": 0.01, "1": 0.0},
    ),
    Campaign(
        "serial-mdh-blunder", "Six axes in modified Denavit-Hartenberg parameters, one wrong reading", 4607,
        lambda: Table("mdh", MDH, list(THREE)), MDH_TOML, sigma_mm="0.02", poses=(30, 15), observe=positions,
        stated=stated(base=WORLD, **THREE), joints=SIX_AXES, fixed_by_model=gains_of_arm,
        blunder=(17, "T2", 1, "0.85"), identify=['outliers = "exclude"'],
    ),
    Campaign(
        "serial-mdh-contacts", "Six axes in modified Denavit-Hartenberg parameters, a ball in four sockets", 4608,
        lambda: Table("mdh", MDH, ["ball"]), MDH_TOML, sigma_mm="0.03", poses=(60, 20),
        observe=contacts(["s1", "s2", "s3", "s4"]), fixtures=points("s1", "s2", "s3", "s4"), joints=SIX_AXES,
        stated=stated(
            ball=["35.5", "-22.0", "110.25"], s1=["310.0", "120.5", "95.25"], s2=["180.75", "-305.0", "160.5"],
            s3=["-60.5", "330.25", "240.0"], s4=["290.25", "-140.75", "380.5"],
        ),
        fixed_by_model=arm_without_world, hold=["alpha_1", "a_1", "theta_1", "d_1"],
    ),
    Campaign(
        "serial-poe-distances", "Six screw axes, distances from four anchors", 4609,
        lambda: Screws(SCREWS, FLANGE_XYZ, FLANGE_RPY, ["ball"]), screws_toml(), sigma_mm="0.02", poses=(40, 20),
        observe=wires(["A", "B", "C", "D"]), fixtures=points("A", "B", "C", "D"), joints=SIX_AXES,
        stated=stated(
            ball=["40.25", "-31.5", "95.75"], A=["1210.5", "-830.25", "40.0"], B=["1150.0", "905.5", "60.75"],
            C=["-940.25", "720.5", "1310.0"], D=["-300.5", "-1120.75", "1450.25"],
        ),
        fixed_by_model=arm_without_world, hold=["q1_x", "q1_y", "q1_rx", "q1_ry", "q2_z", "q2_rz"],
    ),
    Campaign(
        "urdf-poses", "Six axes of a URDF, one of them oblique, poses of a probe", 4610, lambda: Urdf(URDF, ["probe"]), URDF_TOML,
        sigma_mm="0.03", sigma_deg="0.008", poses=(30, 15), observe=poses_of_probe,
        fixtures=[(f"probe_r{k}", "deg") for k in "xyz"],
        stated=stated(base=WORLD, probe=["25.5", "-40.25", "130.0", "20.5", "-35.25", "70.0"]),
        joints=within((-150, 150), (-100, 40), (-80, 100), (-150, 150), (-110, 110), (-170, 170)), fixed_by_model=gains_of_arm,
        files={"arm.urdf": urdf_file()},
    ),
    Campaign(
        "hexapod", "Hexapod, three targets, 42 parameters", 4611, lambda: Hexapod(LEGS, HOME, list(THREE)), hexapod_toml(),
        sigma_mm="0.01", poses=(40, 20), observe=positions, stated=stated(base=WORLD, **THREE),
        joints=within(*[(20, 130)] * 6, digits=MM_DIGITS),
    ),
    Campaign(
        "delta", "Delta with rotating arms, three targets", 4612, lambda: Delta(DELTA, list(THREE)), DELTA_TOML, sigma_mm="0.01",
        poses=(40, 20), observe=positions, stated=stated(base=WORLD, **THREE | {"T1": ["0", "0", "0"]}),
        joints=within(*[(-30, 80)] * 3), hold=["T1_x", "T1_y", "T1_z"],
    ),
]
CAMPAIGNS = {campaign.name: campaign for campaign in ALL}

"""Exports kinematics, lets LinuxCNC move to poses, and compares its joint positions with those of `etalon kinematics`."""
import csv
import io
import json
import math
import os
import random
import re
import subprocess
import sys

etalon, work, drive, user = sys.argv[1:]
random.seed(19)
POSES = 10


def run(*arguments, **options):
    return subprocess.run(arguments, check=True, capture_output=True, text=True, **options).stdout


def kinematics(way, sample, columns, rows, parameters="out/parameters.json"):
    """The table that `etalon kinematics` answers, without the pose's name."""
    table = os.path.join(work, "table.csv")
    with open(table, "w") as file:
        print("pose", *columns, sep=",", file=file)
        for i, row in enumerate(rows):
            print(i + 1, *map(repr, row), sep=",", file=file)
    folder = os.path.join(work, sample)
    answer = run(etalon, "kinematics", way, "--robot", f"{folder}/robot.toml", "--parameters", f"{folder}/{parameters}", table)
    return [[float(v) for v in row[1:]] for row in list(csv.reader(io.StringIO(answer)))[1:]]


def exported(sample, form, name):
    folder = os.path.join(work, sample)
    run(etalon, "export", f"{folder}/out/parameters.json", "--robot", f"{folder}/robot.toml", "--format", form, "--to", folder)
    return open(os.path.join(folder, name)).read()


def written(sample, form):
    """Parameters with the values that a file of this format holds: it leaves some out, and the others make up for them."""
    folder = os.path.join(work, sample)
    files = json.load(open(f"{folder}/out/controllers.json"))["files"]
    values = {v["name"]: v["value"] for v in next(f for f in files if form in f["formats"])["values"]}
    document = json.load(open(f"{folder}/out/parameters.json"))
    for p in document["parameters"]:
        p["value"] = values[p["name"]]
    with open(f"{folder}/written.json", "w") as file:
        json.dump(document, file)
    return "written.json"


def product(*matrices):
    out = matrices[0]
    for m in matrices[1:]:
        out = [[sum(a * b for a, b in zip(row, column)) for column in zip(*m)] for row in out]
    return out


def matrix(xyz, r):
    return [[*r[i], xyz[i]] for i in range(3)] + [[0, 0, 0, 1]]


def inverted(m):
    r = [[m[j][i] for j in range(3)] for i in range(3)]
    return matrix([-sum(r[i][k] * m[k][3] for k in range(3)) for i in range(3)], r)


def rpy(a, b, c):
    (sa, ca), (sb, cb), (sc, cc) = [(math.sin(v), math.cos(v)) for v in (a, b, c)]
    return [[cc * cb, cc * sb * sa - sc * ca, cc * sb * ca + sc * sa], [sc * cb, sc * sb * sa + cc * ca, sc * sb * ca - cc * sa], [-sb, cb * sa, cb * ca]]


def quaternion(w, x, y, z):
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)], [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)], [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]


def world(m):
    """x, y, z, a, b, c of LinuxCNC: Rz(c) Ry(b) Rx(a), deg."""
    c = math.atan2(m[1][0], m[0][0])
    b = math.atan2(-m[2][0], math.cos(c) * m[0][0] + math.sin(c) * m[1][0])
    a = math.atan2(math.sin(c) * m[0][2] - math.cos(c) * m[1][2], math.cos(c) * m[1][1] - math.sin(c) * m[0][1])
    return [m[0][3], m[1][3], m[2][3], *map(math.degrees, (a, b, c))]


def moved(name, module, hal, poses, joints, angular, home, tolerance, compensation=None):
    """LinuxCNC with this kinematics: from `home`, a pose and its joints, to all poses."""
    folder = os.path.join(work, "run_" + re.sub(r"\W", "_", name))
    os.makedirs(folder)
    axes = "XYZABC"
    text = f"""[EMC]
VERSION = 1.1
[DISPLAY]
DISPLAY = {folder}/drive.py
[TASK]
TASK = milltask
CYCLE_TIME = 0.001
[RS274NGC]
PARAMETER_FILE = linuxcnc.var
[EMCMOT]
EMCMOT = motmod
COMM_TIMEOUT = 1.0
SERVO_PERIOD = 1000000
[EMCIO]
EMCIO = io
CYCLE_TIME = 0.1
TOOL_TABLE = tool.tbl
[HAL]
HALFILE = core.hal
HALFILE = kinematics.hal
[KINS]
KINEMATICS = {module}
JOINTS = {len(joints[0])}
[TRAJ]
COORDINATES = {axes}
HOME = {' '.join(map(repr, home[0]))}
LINEAR_UNITS = mm
ANGULAR_UNITS = degree
DEFAULT_LINEAR_VELOCITY = 500
MAX_LINEAR_VELOCITY = 500
"""
    limits = "MIN_LIMIT = -1e5\nMAX_LIMIT = 1e5\nMAX_VELOCITY = 500\nMAX_ACCELERATION = 5000\n"
    for axis in axes:
        text += f"[AXIS_{axis}]\n{limits}"
    for i, value in enumerate(home[1]):
        kind = "ANGULAR" if angular[i] else "LINEAR"
        text += f"[JOINT_{i}]\nTYPE = {kind}\nHOME = {value!r}\nHOME_OFFSET = {value!r}\nHOME_SEQUENCE = 0\nFERROR = 1000\nMIN_FERROR = 1000\n{limits}"
        if compensation and i == 0:
            text += "COMP_FILE = axis.comp\nCOMP_FILE_TYPE = 0\n"
    core = "loadrt [KINS]KINEMATICS\nloadrt [EMCMOT]EMCMOT servo_period_nsec=[EMCMOT]SERVO_PERIOD num_joints=[KINS]JOINTS\n"
    core += "addf motion-command-handler servo-thread\naddf motion-controller servo-thread\n"
    for i in range(len(home[1])):
        core += f"net j{i} joint.{i}.motor-pos-cmd => joint.{i}.motor-pos-fb\n"
    core += "net estop iocontrol.0.user-enable-out => iocontrol.0.emc-enable-in\n"
    core += "net tool-prep iocontrol.0.tool-prepare => iocontrol.0.tool-prepared\nnet tool-change iocontrol.0.tool-change => iocontrol.0.tool-changed\n"
    lines = ["G21 G90"] + ["G0 " + " ".join(f"{axis}{v:.15f}" for axis, v in zip(axes, pose)) for pose in poses]
    files = {"etalon.ini": text, "core.hal": core, "kinematics.hal": hal, "commands.json": json.dumps(lines), "tool.tbl": "", "axis.comp": compensation or "", "drive.py": open(drive).read()}
    for file, content in files.items():
        with open(os.path.join(folder, file), "w") as out:
            out.write(content)
    os.chmod(os.path.join(folder, "drive.py"), 0o755)
    run("chown", "-R", user, folder)
    command = ["runuser", "-u", user, "--", "linuxcnc", "-r", "etalon.ini"]
    with open(os.path.join(folder, "log"), "w") as log:
        subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT, timeout=120)
    try:
        reached = json.load(open(os.path.join(folder, "reached.json")))[1:]
    except FileNotFoundError:
        sys.exit(f"{name}: LinuxCNC did not reach the poses:\n{open(os.path.join(folder, 'log')).read()}")
    difference = max(abs(a - b) for one, other in zip(reached, joints) for a, b in zip(one, other))
    assert len(reached) == len(joints) == POSES
    print(f"{name}: {POSES} poses, joint positions differ by {difference:.1e} (mm, deg), allowed {tolerance:.0e}")
    return difference < tolerance


def around(centre, half):
    return [[v + random.uniform(-half, half) for v in centre] for _ in range(POSES + 1)]


def component(sample, **modes):
    """Builds and installs the component; its name with the modes as parameters of the module."""
    exported(sample, "linuxcnc-component", "etalonkins.comp")
    run("halcompile", "--install", "etalonkins.comp", cwd=os.path.join(work, sample))
    return " ".join(["etalonkins", *(f"{k}={v}" for k, v in modes.items())])


def parameter(sample, name):
    found = json.load(open(os.path.join(work, sample, "out/parameters.json")))["parameters"]
    entry = next(p for p in found if p["name"] == name)
    return math.radians(entry["value"]) if entry["unit"] == "deg" else entry["value"]


def hexapod():
    hal = exported("hexapod", "linuxcnc-hexapod", "genhexkins.hal")
    zero = [float(v) for v in re.findall(r"# joint \d: its position in LinuxCNC is the joint value \+ ([-\d.e]+)", hal)]
    poses = [[x, y, 400 + z, a / 5, b / 5, c / 5] for x, y, z, a, b, c in around([0] * 6, 30)]
    rows = [[*p[:3], *turn(p[3:])] for p in poses]
    joints = kinematics("inverse", "hexapod", "x_mm y_mm z_mm qw qx qy qz".split(), rows)
    joints = [[q + z for q, z in zip(row, zero)] for row in joints]
    return moved("hexapod, genhexkins", "genhexkins", hal, poses[1:], joints[1:], [False] * 6, (poses[0], joints[0]), 1e-9)


def turn(abc):
    """Quaternion of Rz(c) Ry(b) Rx(a), deg."""
    (sa, ca), (sb, cb), (sc, cc) = [(math.sin(math.radians(v) / 2), math.cos(math.radians(v) / 2)) for v in abc]
    return [ca * cb * cc + sa * sb * sc, sa * cb * cc - ca * sb * sc, ca * sb * cc + sa * cb * sc, ca * cb * sc - sa * sb * cc]


def arm():
    """The same joint positions by genserkins, which has first frame and flange apart, and by a component."""
    q = around([20, 30, -20, 40, 50, 30], 12)
    columns = [f"q{i}_deg" for i in range(1, 7)]
    placed = lambda *parameters: [matrix(p[:3], quaternion(*p[3:])) for p in kinematics("direct", "contacts", columns, q, *parameters)]
    hal = exported("contacts", "linuxcnc", "genserkins.hal")

    def framed(name):
        v = [float(v) for v in re.findall(r"[-\d.e]+", re.search(rf"# {name}: xyz (.*) deg", hal).group(1).replace("rpy", ""))if re.search(r"\d", v)]
        return matrix(v[:3], rpy(*map(math.radians, v[3:])))

    base, flange = inverted(framed("first frame in the base")), inverted(framed("flange in the last frame"))
    rows = re.findall(r"# joint \d: at its zero genserkins has ([-\d.e]+) deg; it moves ([-\d.e]+) times", hal)
    theta = [[float(zero) + float(gain) * v for v, (zero, gain) in zip(row, rows)] for row in q]
    inner = [world(product(base, p, flange)) for p in placed(written("contacts", "linuxcnc"))]
    ok = moved("arm, genserkins", "genserkins", hal, inner[1:], theta[1:], [True] * 6, (inner[0], theta[0]), 1e-5)
    outer = [world(p) for p in placed()]
    module = component("contacts")
    return moved("arm, component", module, "", outer[1:], q[1:], [True] * 6, (outer[0], q[0]), 1e-9) and ok


def five_bar():
    q = around([90, 80], 15)
    at = kinematics("direct", "dextar", ["theta1_deg", "theta2_deg", "assembly"], [[*row, 1] for row in q])
    x_o, y_o, phi = [parameter("dextar", name) for name in ("x_o", "y_o", "phi")]
    poses = [[x_o + math.cos(phi) * x - math.sin(phi) * y, y_o + math.sin(phi) * x + math.cos(phi) * y, 0, 0, 0, 0] for x, y, *_ in at]
    # the working mode of these joint values, by the exported Python module
    exported("dextar", "python-kinematics", "etalon_kinematics.py")
    sys.path.insert(0, os.path.join(work, "dextar"))
    import etalon_kinematics as e
    off = lambda b: sum(abs(math.degrees(v) - w) for v, w in zip(e.inverse([at[0][0], at[0][1], *b]), q[0]))
    one, two = min([(b, c) for b in (1, -1) for c in (1, -1)], key=off)
    module = component("dextar", assembly=1, branch1=one, branch2=two)
    return moved("five-bar, component of 12 parameters", module, "", poses[1:], q[1:], [True] * 2, (poses[0], q[0]), 1e-9)


def prexyt():
    rho = around([85, 150, 150], 10)
    at = kinematics("direct", "prexyt-cmm", ["rho1_mm", "rho2_mm", "rho3_mm"], rho)
    x_c, y_c, x_o, y_o, turned = [parameter("prexyt-cmm", name) for name in ("x_c", "y_c", "x_o", "y_o", "epsilon_theta")]
    poses = []
    for x, y, _, w, _, _, z in at:
        # eq. 3.17 and 3.19: ball K, and the direction to ball L
        c = 2 * math.atan2(z, w) + turned
        poses.append([x + x_o - (x_c * math.cos(c) - y_c * math.sin(c)), y + y_o - (x_c * math.sin(c) + y_c * math.cos(c)), 0, 0, 0, math.degrees(c)])
    module = component("prexyt-cmm")
    return moved("PreXYT, component of 13 parameters", module, "", poses[1:], rho[1:], [False] * 3, (poses[0], rho[0]), 1e-9)


def deviation(x, direction):
    """Of an axis, mm: a screw with a wrong lead and a wave, and backlash."""
    return 2e-4 * x + 5e-3 * math.sin(x / 7) - (0.004 if direction < 0 else 0)


def axis():
    """An axis with the table of `etalon iso230`: the motor goes where the deviation brings it to the programmed position."""
    rows = [f"{x},{x + deviation(x, d)!r},{d}" for x in range(0, 101, 10) for d in (1, -1) for _ in range(2)]
    table = os.path.join(work, "axis.csv")
    with open(table, "w") as file:
        print("position_mm,measured_mm,direction", *rows, sep="\n", file=file)
    compensation = run(etalon, "iso230", table, "--compensation", "linuxcnc")
    stops = [(20, 1), (30, 1), (60, 1), (80, 1), (90, 1), (80, -1), (60, -1), (30, -1), (20, -1), (10, -1)]
    poses = [[x, 0, 0, 0, 0, 0] for x in (10, *(x for x, _ in stops))]
    kind = [False] * 3 + [True] * 3
    ok = moved("axis, COMP_FILE", "trivkins coordinates=XYZABC", "", poses[1:], poses[1:], kind, ([0] * 6, [0] * 6), 1e-9, compensation)
    motor = json.load(open(os.path.join(work, "run_axis__COMP_FILE", "motor.json")))[1:]
    off = [m + deviation(x, d) - x for m, (x, d) in zip(motor, stops)]
    # homing leaves a constant
    spread = max(off) - min(off)
    print(f"axis, COMP_FILE: {POSES} positions, actual ones are the programmed ones to {spread:.1e} mm, uncompensated 2e-2")
    return ok and spread < 1e-6


def about(k, deg, at, p):
    """A point turned about the axis `k` (0 to 2) through `at`."""
    s, c = math.sin(math.radians(deg)), math.cos(math.radians(deg))
    i, j = (k + 1) % 3, (k + 2) % 3
    v = [a - b for a, b in zip(p, at)]
    v[i], v[j] = c * v[i] - s * v[j], s * v[i] + c * v[j]
    return [a + b for a, b in zip(v, at)]


def solved(name, values, points, *options):
    """What `etalon cell` prints for a target at these values of a rotary axis."""
    table = os.path.join(work, name)
    with open(table, "w") as file:
        print("axis_deg,x_mm,y_mm,z_mm", *(",".join(map(repr, [v, *p])) for v, p in zip(values, points)), sep="\n", file=file)
    return run(etalon, "cell", table, "--solve", "rotary-axis", *options)


def tilting_table(kins, k):
    """A rotary table on a table that tilts about the axis `k`: pivots by `etalon cell`, and a point of the part followed."""
    c_at, tilt_at = [310.25, 205.5, 0.0], [305.125, 212.75, -31.5]
    target, values = [400.0, 150.0, 60.0], [-50.0, -20.0, 0.0, 30.0, 55.0]
    answer = solved(f"{kins}-c.csv", values, [about(2, v, c_at, target) for v in values], "--json")
    with open(os.path.join(work, f"{kins}-c.json"), "w") as file:
        file.write(answer)
    tilted = [about(k, v, tilt_at, target) for v in values]
    hal = solved(f"{kins}-t.csv", values, tilted, "--with", os.path.join(work, f"{kins}-c.json"), "--controller", kins)
    poses, joints = [], []
    for x, y, z, t, c, _ in around([0] * 6, 40):
        part = [350 + x, 180 + y, 95 + z]
        poses.append([*part, *([t, 0, c] if k == 0 else [0, t, c])])
        joints.append([*about(k, t, tilt_at, about(2, c, c_at, part)), t, c])
    kind = [False] * 3 + [True] * 2
    return moved(f"tilting table, {kins}", kins, hal, poses[1:], joints[1:], kind, (poses[0], joints[0]), 1e-6)


def tilting_head():
    """A head that tilts about y: the pivot length by `etalon cell`, and the end of the tool held."""
    pivot, length, values = [120.0, -40.0, 600.0], 250.5, [-40.0, -15.0, 0.0, 20.0, 35.0]
    end = lambda b: about(1, -b, pivot, [pivot[0], pivot[1], pivot[2] - length])
    hal = solved("head.csv", values, [end(b) for b in values], "--controller", "5axiskins", "--tool-length-mm", "0")
    poses, joints = [], []
    for x, y, z, b, c, _ in around([0] * 6, 30):
        down = about(2, c, [0, 0, 0], about(1, -b, [0, 0, 0], [0, 0, -length]))
        poses.append([x, y, z, 0, b, c])
        joints.append([x - down[0], y - down[1], z - down[2] - length, b, c, 0])
    kind = [False] * 3 + [True] * 2 + [False]
    return moved("tilting head, 5axiskins", "5axiskins", hal, poses[1:], joints[1:], kind, (poses[0], joints[0]), 1e-6)


tables = [lambda: tilting_table("xyzac-trt-kins", 0), lambda: tilting_table("xyzbc-trt-kins", 1), tilting_head]
sys.exit(0 if all([axis(), hexapod(), arm(), five_bar(), prexyt(), *(table() for table in tables)]) else 1)

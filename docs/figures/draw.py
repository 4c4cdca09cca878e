"""Draw the figures of the book from numbers of the program.

python3 docs/figures/draw.py PROGRAM [FOLDER]

The script copies samples into a temporary folder, runs the program there, and writes one SVG per figure into FOLDER (this folder by
default). Python 3.9 or later, standard library alone. Numbers are rounded to a tenth of a pixel.
"""

import csv
import json
import math
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
INK, GREY, BLUE, ORANGE, GREEN, PALE = "#222", "#888", "#1f6fb2", "#d2691e", "#2e8540", "#dce9f5"
HALO = 'paint-order="stroke" stroke="#fff" stroke-opacity="0.7" stroke-width="3"'


class Svg:
    """A picture with a title, in pixels."""

    def __init__(self, name, title, width=640, height=360):
        self.name, self.size, self.title, self.parts = name, (width, height), title, []

    def line(self, points, colour=INK, width=1.5, dash="", arrow=False):
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        style = f' stroke-dasharray="{dash}"' if dash else ""
        style += f' marker-end="url(#{colour[1:]})"' if arrow else ""
        self.parts.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="{width}"{style}/>')

    def area(self, points, colour=PALE):
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        self.parts.append(f'<polygon points="{path}" fill="{colour}"/>')

    def dot(self, x, y, colour=BLUE, radius=3.5):
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{colour}"/>')

    def text(self, x, y, text, colour=INK, anchor="start", size=13):
        text = str(text).replace("&", "&amp;").replace("<", "&lt;")
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" fill="{colour}" text-anchor="{anchor}" font-size="{size}" {HALO}>{text}</text>')

    def save(self, folder):
        width, height = self.size
        colours = (INK, GREY, BLUE, ORANGE, GREEN)
        shape = '<path d="M0 0 L8 4 L0 8 z"'
        heads = "".join(
            f'<marker id="{c[1:]}" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto">{shape} fill="{c}"/></marker>'
            for c in colours
        )
        head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif">'
        body = "\n".join(self.parts)
        (folder / f"{self.name}.svg").write_text(
            f"{head}\n<title>{self.title}</title>\n<defs>{heads}</defs>\n<rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n{body}\n</svg>\n"
        )


def fitted(points, box):
    """A map of coordinates (two axes, y up) into a box of pixels, the same scale for both axes."""
    (left, top, right, bottom), xs, ys = box, [p[0] for p in points], [p[1] for p in points]
    scale = min((right - left) / max(max(xs) - min(xs), 1e-9), (bottom - top) / max(max(ys) - min(ys), 1e-9))
    middle = [(max(v) + min(v)) / 2 for v in (xs, ys)]
    return lambda p: ((left + right) / 2 + scale * (p[0] - middle[0]), (top + bottom) / 2 - scale * (p[1] - middle[1]))


def oblique(p):
    """Coordinates in space, seen from the front, the right and above."""
    a, b = math.radians(-55), math.radians(18)
    x, y = math.cos(a) * p[0] - math.sin(a) * p[1], math.sin(a) * p[0] + math.cos(a) * p[1]
    return (x, math.cos(b) * p[2] + math.sin(b) * y)


class Runs:
    """Samples of the repository, run in a temporary folder."""

    def __init__(self, program, folder):
        self.program, self.folder = str(Path(program).resolve()), Path(folder)
        self.done = set()

    def call(self, *arguments):
        ended = subprocess.run([self.program, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True)
        assert ended.returncode < 2, ended.stderr
        return ended.stdout

    def sample(self, name):
        folder = self.folder / name
        if name not in self.done:
            shutil.copytree(ROOT / "samples" / name, folder, ignore=shutil.ignore_patterns("out"))
            self.call("run", name)
            self.done.add(name)
        return folder

    def batch(self, names):
        """Run samples on all cores, without reports."""
        names = [name for name in names if name not in self.done]
        for name in names:
            shutil.copytree(ROOT / "samples" / name, self.folder / name, ignore=shutil.ignore_patterns("out"))
        self.call("batch", "--documents", "--to", "results", *names)
        self.done.update(names)

    def document(self, name, file):
        return json.loads((self.sample(name) / "out" / file).read_text())


def named(document, name):
    return next(p for p in document["parameters"] if p["name"] == name)


def sketch(runs, sample, figure, title, at=0, only=()):
    """A sketch that the program adds to parameters.json: parts, axes, lengths and directions with their names."""
    found = runs.document(sample, "parameters.json")["sketches"][at]
    flat = (lambda p: (p[0], p[1])) if found["planar"] else oblique
    strokes = [(s["kind"], s.get("name", ""), [flat(p) for p in s["points_mm"]]) for s in found["strokes"]]
    svg = Svg(figure, title, height=420)
    place = fitted([p for _, _, points in strokes for p in points], (60, 40, 580, 380))
    styles = {"part": (GREY, 4, "", False), "axis": (INK, 1, "6 4", False), "length": (BLUE, 1.8, "", False), "direction": (ORANGE, 1.5, "", True)}
    taken = []
    for kind in ("part", "axis", "length", "direction"):
        for _, name, points in (s for s in strokes if s[0] == kind):
            pixels = [place(p) for p in points]
            extent = max(math.dist(pixels[0], p) for p in pixels)
            if extent < 2:
                continue
            svg.line(pixels, *styles[kind])
            if not name or (only and not any(re.fullmatch(o, name) for o in only)):
                continue
            x, y = pixels[len(pixels) // 2] if len(pixels) > 2 else [(a + b) / 2 for a, b in zip(pixels[0], pixels[-1])]
            if kind in ("direction", "axis") and len(pixels) == 2:
                x, y = pixels[-1]
            x, y = x + 6, y - 5
            while any(abs(x - u) < 60 and abs(y - v) < 13 for u, v in taken):
                y += 13
            taken.append((x, y))
            svg.text(x, y, name, styles[kind][0] if kind != "part" else INK, size=12)
    return svg


def chain(runs):
    """The road of one point: from a row of the export to its residual."""
    folder = runs.sample("prexyt-cmm")
    row = next(line for line in (folder / "exports/poses.txt").read_text().splitlines() if line.startswith("K_9_1"))
    label, *export = row.split()[:4]
    rows = list(csv.DictReader((folder / "out/observations.csv").open()))
    seen = next(r for r in rows if r["target"] == "K" and r["pose"] == "9" and r["cycle"] == "1")
    base = [named(runs.document("prexyt-cmm", "parameters.json"), n)["value"] for n in ("x_o", "y_o")]
    world = [float(seen[f"{c}_mm"]) for c in "xy"]
    accuracy = runs.document("prexyt-cmm", "verdict.json")["limits"][0]
    svg = Svg("chain", "The road of one point through the frames, with the numbers of the sample prexyt-cmm", height=300)
    boxes = [
        ("export", f"row {label}", "  ".join(f"{float(v):.4f}" for v in export[:3]), "frame of the CMM"),
        ("world", "[frame.world]", "  ".join(f"{v:.4f}" for v in world), "frame of the rails"),
        ("base", f"x_o {base[0]:.3f}, y_o {base[1]:.3f}", "  ".join(f"{w - b:.3f}" for w, b in zip(world, base)), "frame of the robot"),
        ("joints", "encoders.csv", "  ".join(f"{float(seen[f'rho{i}_mm']):.3f}" for i in (1, 2, 3)), "of the same pose"),
    ]
    for i, (name, source, numbers, note) in enumerate(boxes):
        x, y = 20 + 205 * (i % 3), 40 if i < 3 else 180
        svg.area([(x, y), (x + 185, y), (x + 185, y + 90), (x, y + 90)])
        svg.text(x + 92, y + 20, name, BLUE, "middle", 15)
        for k, text in enumerate((source, numbers, note)):
            svg.text(x + 92, y + 40 + 18 * k, text, INK if k == 1 else GREY, "middle", 12)
        if i in (0, 1):
            svg.line([(x + 185, y + 45), (x + 203, y + 45)], arrow=True)
    svg.line([(522, 130), (522, 178)], arrow=True)
    svg.line([(205, 225), (408, 225)], arrow=True)
    svg.area([(410, 180), (615, 180), (615, 270), (410, 270)], "#fbeadd")
    for k, text in enumerate(("observation", "predicted and measured position", f"largest error {1000 * accuracy['value']:.1f} µm", "of 51 validation poses")):
        svg.text(512, 200 + 20 * k, text, ORANGE if k == 0 else INK, "middle", 15 if k == 0 else 12)
    return svg


def set_up(runs):
    """Instrument, reference targets, base and poses of the hexapod from above."""
    folder = runs.sample("hexapod")
    floor = {}
    for line in (folder / "exports/world.txt").read_text().splitlines():
        name, x, y, _ = line.split(",")
        floor[name] = (float(x), float(y))
    poses = [line.split(",") for line in (folder / "exports/poses.txt").read_text().splitlines()]
    seen = [(float(r[1]), float(r[2])) for r in poses if r[0].startswith("SMR_1_")]
    svg = Svg("set-up", "Set-up from above: tracker, reference targets on the floor, measured reflector (sample hexapod)")
    place = fitted([(0, 0), *floor.values(), *seen], (60, 40, 560, 320))
    x, y = place((0, 0))
    svg.text(x - 10, y + 24, "laser tracker")
    for name, p in floor.items():
        svg.line([(x, y), place(p)], GREY, 0.8, "4 4")
        svg.dot(*place(p), ORANGE, 5)
        svg.text(place(p)[0] + 8, place(p)[1] + 4, name, ORANGE)
    for p in seen:
        svg.dot(*place(p), BLUE, 2)
    svg.line([(x, y), place(seen[0])], BLUE, 0.8)
    svg.dot(x, y, INK, 7)
    svg.text(610, place(min(seen, key=lambda p: p[1]))[1] + 20, f"reflector SMR_1 at {len(seen)} poses", BLUE, "end")
    return svg


def world_frame(runs):
    """World frame by three reference targets, as frames.json contains it."""
    folder = runs.sample("hexapod")
    pose = runs.document("hexapod", "frames.json")["world"]["poses"][0]["export_T_world"]
    floor = {}
    for line in (folder / "exports/world.txt").read_text().splitlines():
        name, *xyz = line.split(",")
        floor.setdefault(name, [float(v) for v in xyz])
    origin = pose["translation_mm"]
    axis = lambda i, length: [o + length * pose["rotation"][k][i] for k, o in enumerate(origin)]
    points = [*floor.values(), *(axis(i, 700) for i in range(3))]
    svg = Svg("world-frame", "World frame from three balls: origin at the first, x axis to the second, third in the xy plane")
    place = fitted([oblique(p) for p in points], (70, 40, 560, 320))
    at = lambda p: place(oblique(p))
    svg.area([at(p) for p in floor.values()])
    for i, name in enumerate("xyz"):
        svg.line([at(origin), at(axis(i, 700))], BLUE, 2, arrow=True)
        svg.text(at(axis(i, 700))[0] + 6, at(axis(i, 700))[1] - 4, name, BLUE, size=16)
    for role, (name, p) in zip(("origin", "on x", "in the xy plane"), floor.items()):
        svg.dot(*at(p), ORANGE, 6)
        right = at(p)[0] > 400
        svg.text(at(p)[0] + (8 if right else 10), at(p)[1] + (24 if right else 18), f"{name}: {role}", ORANGE, "end" if right else "start")
    return svg


def sweep(runs):
    """A sweep of one joint, the fitted circle and its axis."""
    rows, radius = ["joint,target,q1_deg,x_mm,y_mm,z_mm"], (500.0, 320.0)
    for i, (name, r, z) in enumerate((("A", radius[0], 100.0), ("B", radius[1], 260.0))):
        for k in range(13):
            q = -90 + 15 * k
            # deviations of 20 µm, fixed, so that the figure is always the same
            off = [0.02 * math.sin(1.7 * k + a + i) for a in (0, 2, 4)]
            x, y = 600 + r * math.cos(math.radians(q)) + off[0], 200 + r * math.sin(math.radians(q)) + off[1]
            rows.append(f"q1,{name},{q},{x:.4f},{y:.4f},{z + off[2]:.4f}")
    (runs.folder / "sweep.csv").write_text("\n".join(rows) + "\n")
    found = json.loads(runs.call("axes", "sweep.csv", "--json"))["axes"][0]
    origin, direction = found["point_mm"], found["direction"]
    readings = [(r["target"], [float(r[f"{c}_mm"]) for c in "xyz"]) for r in csv.DictReader((runs.folder / "sweep.csv").open())]
    svg = Svg("sweep", "A sweep of one joint: two targets, their coaxial circles and the axis (etalon axes)")
    ends = [[o + t * d for o, d in zip(origin, direction)] for t in (-250, 420)]
    place = fitted([oblique(p) for p in [*(p for _, p in readings), *ends]], (60, 30, 580, 330))
    at = lambda p: place(oblique(p))
    svg.line([at(ends[0]), at(ends[1])], INK, 1.5, "8 4")
    svg.text(at(ends[1])[0] + 8, at(ends[1])[1] + 12, "axis of q1")
    for name, colour in (("A", BLUE), ("B", ORANGE)):
        own = [p for n, p in readings if n == name]
        svg.line([at(p) for p in own], colour, 1)
        for p in own:
            svg.dot(*at(p), colour)
        foot = [o + sum((a - b) * d for a, b, d in zip(own[0], origin, direction)) * v for o, v in zip(origin, direction)]
        svg.line([at(foot), at(own[-1])], GREY, 0.8)
        svg.text(at(own[0])[0] + 8, at(own[0])[1], f"target {name}, r = {math.dist(foot, own[0]):.2f} mm", colour)
    return svg


def guard_band(runs):
    """Value, uncertainty, limit and risk of a conditional verdict."""
    limit = runs.document("hexapod", "verdict.json")["limits"][0]
    bound, value, u = 1000 * limit["limit"], 1000 * limit["value"], 500 * limit["expanded_uncertainty"]
    svg = Svg("guard-band", "Guard band and risk: largest position error of the sample hexapod")
    at = lambda v: 40 + 560 * (v - (value - 4 * u)) / (8 * u)
    density = lambda v: 280 - 190 * math.exp(-0.5 * ((v - value) / u) ** 2)
    steps = [value + u * (k / 10 - 4) for k in range(81)]
    svg.area([(at(bound - 2 * u), 60), (at(bound), 60), (at(bound), 280), (at(bound - 2 * u), 280)])
    tail = [v for v in steps if v >= bound]
    svg.area([(at(bound), 280), (at(bound), density(bound)), *((at(v), density(v)) for v in tail), (at(tail[-1]), 280)], "#f4b183")
    svg.line([(at(v), density(v)) for v in steps], BLUE, 2)
    svg.line([(40, 280), (600, 280)])
    svg.line([(at(bound), 50), (at(bound), 280)], ORANGE, 2)
    svg.text(at(bound) + 5, 60, f"limit {bound:.0f} µm", ORANGE)
    svg.line([(at(value), 85), (at(value), 280)], BLUE, 1, "4 4")
    svg.text(at(value), 298, f"value {value:.1f} µm", BLUE, "middle")
    svg.line([(at(value - 2 * u), 315), (at(value + 2 * u), 315)], BLUE, 3)
    svg.text(at(value), 334, f"± U = {2 * u:.1f} µm (k = 2)", BLUE, "middle")
    svg.text(at(bound - u), 76, "guard band U", GREY, "middle", 12)
    svg.text(at(bound) + 8, 240, f"risk {100 * (1 - limit['conformity_probability']):.1f} %", "#a04000")
    return svg


def bars(name, title, rows, unit, digits):
    """Horizontal bars: label, value, colour."""
    svg = Svg(name, title, height=50 + 24 * len(rows))
    largest = max(abs(value) for _, value, _ in rows)
    for i, (label, value, colour) in enumerate(rows):
        y, width = 30 + 24 * i, 340 * abs(value) / largest
        svg.text(150, y + 13, label, INK, "end", 12)
        svg.area([(160, y), (160 + max(width, 1), y), (160 + max(width, 1), y + 16), (160, y + 16)], colour)
        svg.text(168 + width, y + 13, f"{value:.{digits}f} {unit}", GREY, size=12)
    return svg


def budget(runs):
    """Contributions to the uncertainty of the length d of the PreXYT."""
    document = runs.document("prexyt-cmm", "parameters.json")
    names = [p["name"] for p in document["parameters"] if p["standard_uncertainty"]]
    at = names.index("x_o")
    rows = [(b["source"].replace("_", " "), 1000 * b["standard_uncertainties"][at], "#9ec5e8") for b in document["budget"]]
    rows.append(("combined", 1000 * named(document, "x_o")["standard_uncertainty"], BLUE))
    return bars("budget", "Uncertainty budget of x_o of the sample prexyt-cmm: standard uncertainties", rows, "µm", 2)


def parameters(runs):
    """Identified and held parameters of the hexapod."""
    document = runs.document("hexapod", "parameters.json")
    robot = [p for p in document["parameters"] if p["role"] == "robot"]
    svg = Svg("parameters", "Identified parameters of the sample hexapod with U = 2u, and held parameters", height=380)
    identified = [p for p in robot if p["standard_uncertainty"] and p["status"] == "identified"]
    largest = max(abs(p["value"] - p["nominal"]) + 2 * p["standard_uncertainty"] for p in identified)
    y = lambda v: 180 - 130 * v / largest
    svg.line([(68, y(0)), (620, y(0))])
    for value in (-largest, largest):
        svg.text(62, y(value) + 4, f"{value:+.1f} mm", GREY, "end", 11)
    for i, p in enumerate(robot):
        x = 76 + 13 * i
        if p in identified:
            change, u = p["value"] - p["nominal"], 2 * p["standard_uncertainty"]
            svg.line([(x, y(change - u)), (x, y(change + u))], BLUE, 1.5)
            svg.dot(x, y(change), BLUE, 3)
        else:
            svg.dot(x, y(0), ORANGE, 3)
        svg.parts.append(f'<text transform="translate({x + 3:.1f},375) rotate(-90)" font-size="9" fill="#222">{p["name"]}</text>')
    svg.text(60, 24, f"{len(identified)} identified: change from nominal, with U", BLUE)
    svg.text(380, 24, f"{len(robot) - len(identified)} held: they define the frames", ORANGE)
    return svg


def field(runs):
    """Residual field: error of a joint as a function of its angle, beside the error that was simulated."""
    component = runs.document("field-arm", "field.json")["components"][0]
    scale, radius = component["inputs"][0]["scale"], component["radius"]
    low, high = component["inputs"][0]["range"]

    def error(q):
        total = 0.0
        for centre in component["centres"]:
            r = abs(q - centre["at"][0]) / (scale * radius)
            total += centre["weight"] * max(1 - r, 0.0) ** 4 * (4 * r + 1)
        return total

    steps = [low + (high - low) * k / 120 for k in range(121)]
    values = [error(q) for q in steps]
    svg = Svg("field", f"Residual field of the sample field-arm: error of {component['joint']} as a function of the joint")
    top = max(map(abs, values)) * 1.15
    x, y = lambda q: 70 + 530 * (q - low) / (high - low), lambda v: 180 - 130 * v / top
    svg.line([(70, y(0)), (600, y(0))], GREY, 1)
    svg.line([(70, 50), (70, 310)], GREY, 1)
    for value in (-top, 0, top):
        svg.text(62, y(value) + 4, f"{value:+.3f}", GREY, "end", 12)
    for q in (low, 0, high):
        svg.text(x(q), 328, f"{q:.0f}°", GREY, "middle", 12)
    svg.line([(x(q), y(v)) for q, v in zip(steps, values)], BLUE, 2)
    for centre in component["centres"]:
        svg.dot(x(centre["at"][0]), y(error(centre["at"][0])), ORANGE)
    svg.text(90, 40, "error of the joint (deg); dots: centres of the field", INK, size=12)
    return svg


def pseudo_pose(runs):
    """Target, attained position without correction, and command, from above and magnified."""
    text = "pose,x_mm,y_mm,z_mm,qw,qx,qy,qz\n1,400,0,500,0.7071067811865476,0,0.7071067811865476,0\n"
    (runs.folder / "targets.csv").write_text(text)
    examples = ROOT / "python/examples"
    identified = runs.call("identify", "--robot", examples / "arm.toml", "--observations", examples / "arm.csv", "--standard-uncertainty-um", 10, "--json")
    (runs.folder / "arm.json").write_text(identified)
    given = ["--robot", examples / "arm.toml", "--parameters", "arm.json"]
    target = json.loads(runs.call("compensate", "targets.csv", *given, "--json"))["targets"][0]
    (runs.folder / "nominal.csv").write_text(runs.call("kinematics", "inverse", "targets.csv", "--robot", examples / "arm.toml"))
    rows = list(csv.DictReader((runs.folder / "nominal.csv").open()))
    near = min(rows, key=lambda r: sum((float(r[f"q{i + 1}_deg"]) - q) ** 2 for i, q in enumerate(target["joints"])))
    head = "pose," + ",".join(f"q{i}_deg" for i in range(1, 7))
    (runs.folder / "joints.csv").write_text(head + "\n1," + ",".join(near[f"q{i}_deg"] for i in range(1, 7)) + "\n")
    attained = next(csv.DictReader(runs.call("kinematics", "direct", "joints.csv", *given).splitlines()))
    wanted, command = target["xyz_mm"], target["command_xyz_mm"]
    off = [float(attained[f"{c}_mm"]) - w for c, w in zip("xyz", wanted)]
    moved = [c - w for c, w in zip(command, wanted)]
    svg = Svg("pseudo-pose", "One target in the x-z plane, errors magnified: without correction, and with the corrected command")
    largest = max(math.hypot(off[0], off[2]), math.hypot(moved[0], moved[2]))
    at = lambda v: (320 + 150 * v[0] / largest, 180 - 110 * v[2] / largest)
    svg.line([(320, 30), (320, 330)], GREY, 0.6, "4 4")
    svg.line([(60, 180), (580, 180)], GREY, 0.6, "4 4")
    svg.line([at((0, 0, 0)), at(off)], ORANGE, 2, arrow=True)
    svg.line([at((0, 0, 0)), at(moved)], BLUE, 2, arrow=True)
    svg.line([at(moved), at((0, 0, 0))], GREEN, 2, "5 4")
    svg.dot(*at((0, 0, 0)), INK, 6)
    svg.text(330, 172, f"target {wanted[0]:.0f}, {wanted[2]:.0f} mm")
    for vector, colour, words in ((off, ORANGE, "attained without correction"), (moved, BLUE, "corrected command")):
        x, y = at(vector)
        y += 22 if y > 180 else -12
        svg.text(min(max(x, 120), 520), y, f"{words}: {vector[0]:+.3f}, {vector[2]:+.3f} mm", colour, "middle")
    svg.text(320, 350, "the robot turns the corrected command into the target", GREEN, "middle")
    return svg


def errors(runs):
    """Largest errors of the samples with validation poses before and after calibration."""
    names = """prexyt-cmm prexyt-faroarm prexyt-geometric dextar hexapod delta linear-delta column-arm rail-arm payload-arm torque-arm
        warming-arm elastic-arm field-arm probe-poses second-encoders turntable two-hands draw-wire two-arms contacts surfaces""".split()
    runs.batch(names)
    svg = Svg("errors", "Largest error at validation poses, before and after calibration (µm, logarithmic)", height=70 + 22 * len(names))
    at = lambda mm: 150 + 400 * (math.log10(1000 * mm) - 0) / 3.7
    for decade in range(4):
        x = at(10**decade / 1000)
        svg.line([(x, 30), (x, 36 + 22 * len(names))], "#ddd", 1)
        svg.text(x, 54 + 22 * len(names), f"{10**decade} µm", GREY, "middle", 12)
    for i, name in enumerate(names):
        sets = runs.document(name, "accuracy.json")["sets"]
        group = {e["quantity"]: e for e in next(s for s in sets if s["name"] == "validation")["errors"]}
        quantity = next(q for q in ("position", "distance", "contact", "surface") if q in group)
        before, after = group[quantity]["before"]["max"], group[quantity]["after"]["max"]
        y = 46 + 22 * i
        svg.text(140, y + 4, name, INK, "end")
        svg.line([(at(before), y), (at(after), y)], GREY, 1.5, arrow=True)
        svg.dot(at(before), y, ORANGE, 5)
        svg.dot(at(after), y, BLUE, 5)
        if quantity != "position":
            svg.text(at(before) + 10, y + 4, quantity, GREY, size=12)
    svg.text(160, 22, "before", ORANGE)
    svg.text(220, 22, "after", BLUE)
    return svg


def first_report(runs):
    """Result of the first page to learn from: answer of `run`, and the errors at its validation poses as its report lists them."""
    examples = ROOT / "python/examples"
    runs.call("init", "mine", "--robot", examples / "arm.toml", "--from", examples / "arm.csv")
    campaign = runs.folder / "mine/campaign.toml"
    text = re.sub(r'^name = "\?".*$', 'name = "Laser tracker"', campaign.read_text(), flags=re.M)
    campaign.write_text(re.sub(r'^expanded_uncertainty_um = "\?".*$', "expanded_uncertainty_um = 20", text, flags=re.M))
    answer = next(line for line in runs.call("run", "mine").splitlines() if line.startswith("Largest position error"))
    report = (runs.folder / "mine/out/report.html").read_text()
    shown = r"<title>pose (\d+), cycle 1, \S+ \(validation\): ([\d.]+) µm before, ([\d.]+) µm after"
    rows = sorted({(int(pose), float(before), float(after)) for pose, before, after in re.findall(shown, report)})
    assert len(rows) == 18, rows
    svg = Svg("first-report", "Errors at the 18 validation poses of the first campaign, before and after calibration")
    x, y = lambda i: 80 + 31 * i, lambda error: 310 - 80 * math.log10(error)
    svg.text(20, 24, answer, size=14)
    for decade in range(4):
        svg.line([(62, y(10**decade)), (620, y(10**decade))], "#ddd", 1)
        svg.text(56, y(10**decade) + 4, f"{10**decade} µm", GREY, "end", 12)
    for i, (pose, before, after) in enumerate(rows):
        svg.line([(x(i), y(before)), (x(i), y(after))], GREY, 1.5, arrow=True)
        svg.dot(x(i), y(before), ORANGE, 4)
        svg.dot(x(i), y(after), BLUE, 4)
        svg.text(x(i), 328, pose, GREY, "middle", 12)
    svg.text(340, 350, "validation pose", GREY, "middle", 12)
    svg.text(70, 58, "error before", ORANGE)
    svg.text(160, 58, "error after calibration", BLUE)
    return svg


def one_joint(runs):
    """Five readings of one joint, the fitted line and the residuals, from the files of the page."""
    page = (ROOT / "docs/learn/one-joint.md").read_text()
    for name, text in re.findall(r"^```\w+,file=(\S+)\n(.*?)^```$", page, re.M | re.S):
        (runs.folder / name).parent.mkdir(exist_ok=True)
        (runs.folder / name).write_text(text)
    files = ["--robot", "axis/robot.toml", "--observations", "axis/readings.csv"]
    document = json.loads(runs.call("identify", *files, "--standard-uncertainty-um", 3, "--hold", "base_rx", "--json"))
    gain, offset, u = named(document, "gain_1")["value"], named(document, "base_x")["value"], 0.003
    readings = [(float(r["q1_mm"]), float(r["x_mm"])) for r in csv.DictReader((runs.folder / "axis/readings.csv").open())]
    svg = Svg("one-joint", "Five readings of one joint: x minus q with the fitted line, and the residuals with the standard uncertainty", height=420)
    at, up, low = lambda q: 100 + 480 * q / 400, lambda v: 220 - 850 * v, lambda v: 340 - 8000 * v
    svg.text(20, 24, f"x − q (mm): readings, and the fitted line {offset:.4f} + {gain - 1:.6f} q", size=14)
    for value in (0, 0.1, 0.2):
        svg.line([(90, up(value)), (600, up(value))], "#ddd", 1)
        svg.text(82, up(value) + 4, f"{value:.1f}", GREY, "end", 12)
    svg.line([(at(q), up(offset + (gain - 1) * q)) for q in (0, 400)], BLUE, 2)
    svg.text(20, 270, "residuals (mm), with the standard uncertainty of 0.003 mm", size=14)
    for value in (-u, 0, u):
        svg.line([(90, low(value)), (600, low(value))], "#ddd" if value else GREY, 1)
        svg.text(82, low(value) + 4, f"{value:+.3f}".replace("-", "−") if value else "0", GREY, "end", 12)
    for q, x in readings:
        residual = x - offset - gain * q
        svg.dot(at(q), up(x - q), ORANGE, 5)
        svg.line([(at(q), low(residual - u)), (at(q), low(residual + u))], ORANGE, 1.5)
        svg.dot(at(q), low(residual), ORANGE, 4)
        svg.text(at(q) + 8, low(residual) + 4, f"{residual:+.4f}".replace("-", "−"), size=12)
        svg.text(at(q), 404, f"{q:.0f}", GREY, "middle", 12)
    svg.text(82, 404, "q (mm)", GREY, "end", 12)
    return svg


def crates():
    """Crates of the workspace and their dependencies, from the table of docs/architecture.md, which a test compares with cargo."""
    table = (ROOT / "docs/architecture.md").read_text()
    rows = re.findall(r"^\| `(\w+)` \| [^|]* \| ([^|]*) \| [^|]* \|$", table, re.M)
    uses = {name: re.findall(r"`(\w+)`", inside) for name, inside in rows}
    assert len(uses) > 10, uses
    reached, level = {}, {}
    for name in uses:  # the table begins with the crates that use none
        reached[name] = set(uses[name]).union(*(reached[other] for other in uses[name]))
    for name in reversed(uses):
        level[name] = 1 + max((level[user] for user in uses if name in uses[user]), default=-1)
    # columns in which no line passes behind a crate
    columns = dict(base=320, math=215, fit=150, robots=280, identify=150, standards=280, documents=200, tables=420)
    columns |= dict(formats=385, report=75, compare=190, campaign=330, controllers=450, view=570, etalon=320)
    top = max(level.values())
    svg = Svg("crates", "Crates of the workspace: each uses the crates to which its lines lead, and the crates that these use", height=60 + 62 * top)
    at = {name: (columns.get(name, 320), 30 + 62 * (top - level[name])) for name in uses}
    for name, others in uses.items():
        for other in others:
            if not any(other in reached[between] for between in others):
                (x, y), (u, v) = at[name], at[other]
                svg.line([(x, y - 12), (u, v + 14)], GREY, 1.2, arrow=True)
    for name, (x, y) in at.items():
        svg.area([(x - 52, y - 12), (x + 52, y - 12), (x + 52, y + 12), (x - 52, y + 12)])
        svg.text(x, y + 5, name, INK, "middle")
    return svg


def main():
    folder = Path(sys.argv[2]) if len(sys.argv) > 2 else Path(__file__).parent
    with tempfile.TemporaryDirectory() as work:
        runs = Runs(sys.argv[1], work)
        figures = [
            chain(runs),
            set_up(runs),
            world_frame(runs),
            sketch(runs, "rail-arm", "dh-row", "A row of Denavit-Hartenberg parameters: one link", at=1),
            sketch(runs, "rail-arm", "arm", "Axes and lengths of an arm on a rail at joint values zero"),
            sweep(runs),
            guard_band(runs),
            budget(runs),
            parameters(runs),
            field(runs),
            sketch(runs, "dextar", "five-bar", "Five-bar: links, joint angles, and the frames of base and world"),
            sketch(runs, "prexyt-cmm", "prexyt", "PreXYT from above: rails, carriages, platform and balls"),
            sketch(runs, "hexapod", "hexapod", "Hexapod: six legs, the parameters of leg 1", only=("leg1.*", "x .*")),
            sketch(runs, "linear-delta", "delta", "Delta with carriages on towers: the parameters of leg 1"),
            pseudo_pose(runs),
            errors(runs),
            first_report(runs),
            one_joint(runs),
            crates(),
        ]
        for svg in figures:
            svg.save(folder)


if __name__ == "__main__":
    main()

"""docs/benchmark.md and its figures, from the results of a run."""

import csv
import datetime
import importlib.metadata
import math
import os
import pathlib
import platform
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
DOCS = HERE.parent.parent / "docs"
COLOURS = {
    "nominal": "#8a8a8a",
    "scipy_dh": "#c2571a",
    "scipy_poe": "#7a4fa3",
    "figaroh": "#2f8f4e",
    "etalon": "#1f5fa8",
    "etalon_all": "#0a2f5c",
}
LABELS = {
    "nominal": "nominal",
    "scipy_dh": "SciPy, DH",
    "scipy_poe": "SciPy, POE",
    "figaroh": "FIGAROH",
    "etalon": "etalon",
    "etalon_all": "etalon, all effects",
}


def table(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def errors(folder, name, participant):
    """Sorted position errors (mm) of the test rows."""
    predictions = folder / "results" / name / f"{participant}.csv"
    if not predictions.is_file():
        return []
    found = {(r["pose"], r["target"]): r for r in table(predictions)}
    rows = table(folder / "hidden" / name / "test.csv")
    place = lambda r: [float(r[f"{a}_mm"]) for a in "xyz"]
    return sorted(math.dist(place(found[r["pose"], r["target"]]), place(r)) for r in rows)


def figure(folder, name, described, participants):
    """Share of test rows with a position error below a value (logarithmic), a line a participant."""
    lines = {p: errors(folder, name, p) for p in participants}
    lines = {p: e for p, e in lines.items() if e}
    low = min(e[len(e) // 20] for e in lines.values())
    high = max(e[-1] for e in lines.values())
    low, high = max(low, high / 1e4), high
    width, height, left, right, top, bottom = 640, 300, 52, 128, 34, 44
    x = lambda v: left + (width - left - right) * (math.log(max(v, low)) - math.log(low)) / (math.log(high) - math.log(low))
    y = lambda s: height - bottom - (height - top - bottom) * s
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="12">',
        f"<title>{described['title']}: share of test rows with a smaller position error</title>",
        f'<rect width="{width}" height="{height}" fill="#ffffff"/>',
        f'<text x="{left}" y="20" font-size="14">{described["title"]}</text>',
    ]
    for share in (0, 0.25, 0.5, 0.75, 0.95):
        out.append(f'<path d="M{left} {y(share):.1f}H{width - right}" stroke="#dddddd"/>')
        out.append(f'<text x="{left - 6}" y="{y(share) + 4:.1f}" text-anchor="end">{100 * share:.0f} %</text>')
    for power in range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1):
        for digit in (1, 2, 5):
            v = digit * 10.0**power
            if low <= v <= high:
                out.append(f'<path d="M{x(v):.1f} {top}V{height - bottom}" stroke="#dddddd"/>')
                out.append(f'<text x="{x(v):.1f}" y="{height - bottom + 16}" text-anchor="middle">{v:g}</text>')
    out.append(f'<text x="{(left + width - right) / 2}" y="{height - 8}" text-anchor="middle">position error (mm)</text>')
    for row, (participant, all_errors) in enumerate(lines.items()):
        step = max(1, len(all_errors) // 160)
        points = [(e, (k + 1) / len(all_errors)) for k, e in enumerate(all_errors)]
        points = points[::step] + [points[-1]]
        path = "L".join(f"{x(e):.1f} {y(s):.1f}" for e, s in points)
        out.append(f'<path d="M{path}" fill="none" stroke="{COLOURS[participant]}" stroke-width="1.8"/>')
        at = top + 12 + 18 * row
        out.append(f'<path d="M{width - right + 8} {at - 4}h18" stroke="{COLOURS[participant]}" stroke-width="2.4"/>')
        out.append(f'<text x="{width - right + 32}" y="{at}">{LABELS[participant]}</text>')
    path = DOCS / "figures" / "benchmark" / f"{name}.svg"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(out) + "\n</svg>\n")


def rms(found, participant):
    """Root-mean-square position error (mm) of a participant, if it predicted the set."""
    return found["participants"].get(participant, {}).get("position", {}).get("errors", {}).get("rms")


def compared(results, label, peers):
    """Sentence that compares etalon with the best of some participants, on the sets that both predicted."""
    least = {name: min((rms(found, p) for p in peers if rms(found, p)), default=None) for name, found in results.items()}
    ratios = {name: rms(found, "etalon") / least[name] for name, found in results.items() if least[name] and rms(found, "etalon")}
    smaller = sorted(100 * (1 - r) for r in ratios.values() if r < 0.99)
    larger = [name for name, r in ratios.items() if r > 1.01]
    span = " to ".join(dict.fromkeys(f"{share:.0f}" for share in smaller[:1] + smaller[-1:]))
    span = f" ({span} %)" if smaller else ""
    equal = len(ratios) - len(smaller) - len(larger)
    named = f"{len(larger)} ({', '.join(larger)})" if larger else "none"
    return f"Compared with {label}, etalon's error is smaller on {len(smaller)} of {len(ratios)} sets{span}. It is equal within 1 % on {equal}, and larger on {named}."


def summary(results):
    """Sentences that compare etalon with its peers, and every program with the nominal robot; errors are root mean squares."""
    fits = {name: [rms(found, p) for p in LABELS if p != "nominal" and rms(found, p)] for name, found in results.items()}
    worse = [name for name, found in results.items() if fits[name] and rms(found, "nominal") and min(fits[name]) > rms(found, "nominal")]
    out = [compared(results, "the better SciPy fit", ("scipy_dh", "scipy_poe")), compared(results, "FIGAROH", ("figaroh",))]
    return out + ([f"On {', '.join(worse)} every program is less accurate than the nominal robot."] if worse else [])


def overview(results):
    """Root-mean-square error of each set over the error of the nominal robot, a mark a participant."""
    shown = [p for p in ("scipy_dh", "scipy_poe", "figaroh", "etalon") if any(rms(found, p) for found in results.values())]
    left, top, step, width = 130, 40, 18, 640
    height = top + step * len(results) + 50
    largest = max(rms(found, p) / rms(found, "nominal") for found in results.values() for p in shown if rms(found, p))
    x = lambda v: left + (width - left - 20) * v / (1.05 * largest)
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="12">',
        "<title>Root-mean-square error at test poses over the error of the nominal robot</title>",
        f'<rect width="{width}" height="{height}" fill="#ffffff"/>',
    ]
    for k, participant in enumerate(shown):
        out.append(f'<circle cx="{left + 5 + 110 * k}" cy="16" r="4" fill="{COLOURS[participant]}"/>')
        out.append(f'<text x="{left + 14 + 110 * k}" y="20">{LABELS[participant]}</text>')
    for tenth in range(0, int(10.5 * largest) + 1, 2):
        at = x(tenth / 10)
        out.append(f'<path d="M{at:.1f} {top - 8}V{height - 44}" stroke="{"#888888" if tenth == 10 else "#dddddd"}"/>')
        out.append(f'<text x="{at:.1f}" y="{height - 28}" text-anchor="middle">{tenth / 10:g}</text>')
    out.append(f'<text x="{(left + width) / 2}" y="{height - 8}" text-anchor="middle">error over the error of the nominal robot (1: no gain)</text>')
    for row, (name, found) in enumerate(results.items()):
        y = top + step * row + 6
        out.append(f'<text x="{left - 10}" y="{y + 4}" text-anchor="end">{name}</text>')
        for k, participant in enumerate(shown):
            if rms(found, participant):
                # equal errors stay visible one above the other
                at = y + 3 * (k - (len(shown) - 1) / 2)
                out.append(f'<circle cx="{x(rms(found, participant) / rms(found, "nominal")):.1f}" cy="{at:.1f}" r="3.5" fill="{COLOURS[participant]}"/>')
    path = DOCS / "figures" / "benchmark" / "overview.svg"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(out) + "\n</svg>\n")


def number(v):
    return f"{v:.3g}" if v < 100 else f"{v:.0f}"


def cells(row):
    return "| " + " | ".join(row) + " |"


def position_table(results, participants):
    rows = [cells(["set", "poses", *(LABELS[p] for p in participants)]), cells(["---"] * (2 + len(participants)))]
    for name, found in results.items():
        line = [f"[{name}](#{name})", f"{found['calibration_poses']} + {found['test_poses']}"]
        for p in participants:
            score = found["participants"].get(p, {})
            state = "left out" if "left out" in score.get("failed", "left out") else "failed"
            line.append(number(score["position"]["errors"]["rms"]) if "position" in score else state)
        rows.append(cells(line))
    return rows


def interval_table(results, participants, quantity):
    stated = [
        p for p in participants if any((f["participants"].get(p, {}).get(quantity) or {}).get("intervals") for f in results.values())
    ]
    head = ["set", "poses"] + [f"{LABELS[p]}: {what}" for p in stated for what in ("held (%)", "exact (%)", "score")]
    rows = [cells(head), cells(["---"] * len(head))]
    for name, found in results.items():
        line = [name, str(found["test_poses"])]
        for p in stated:
            intervals = (found["participants"].get(p, {}).get(quantity) or {}).get("intervals")
            if intervals:
                u = intervals.get("coverage_standard_uncertainty", math.nan)
                low, high = (100 * v for v in intervals["coverage_interval"])
                # 95 % outside of the exact interval
                exact = f"{low:.1f} to {high:.1f}" if low <= 95 <= high else f"**{low:.1f} to {high:.1f}**"
                line += [f"{100 * intervals['coverage']:.1f} ± {100 * u:.1f}", exact, number(intervals["mean_score"])]
            else:
                line += ["", "", ""]
        if any(line[2:]):
            rows.append(cells(line))
    return rows


def left_out_table(results, participants):
    """Reasons of participants, and the sets for which they give them."""
    reasons = {}
    for p in participants:
        for name, found in results.items():
            failed = found["participants"].get(p, {}).get("failed", "")
            if failed.startswith("left out: "):
                reasons.setdefault((p, failed.removeprefix("left out: ")), []).append(name)
            elif p not in found["participants"]:
                reasons.setdefault((p, "not run for this page: a fit of hundreds of poses takes many minutes"), []).append(name)
    rows = [cells(["participant", "reason", "sets"]), cells(["---"] * 3)]
    return rows + [cells([LABELS[p], reason, ", ".join(names)]) for (p, reason), names in reasons.items()]


def section(name, described, found, participants):
    rows = [f"### {name}", "", f"{described['title']}.", ""]
    rows += [f"![Share of test rows with a smaller position error](figures/benchmark/{name}.svg)", ""]
    distance = (found.get("split") or {}).get("distance") or {}
    facts = [
        ("measured", described["measured"]),
        ("instrument", described["instrument"]),
        ("licence of the data", described["licence"]),
        ("source", described["citation"]),
    ]
    if described.get("published"):
        facts.append(("published", "; ".join(f"{p['figure']} ({p['source']})" for p in described["published"])))
    if distance.get("median") is not None:
        facts.append(("distance of the test poses", f"{distance['median']:.2g} spacings of the calibration poses (median)"))
    rows += [cells(["", ""]), cells(["---", "---"])] + [cells(list(f)) for f in facts] + [""]
    rows += [f"- {fault}" for fault in described["faults"]] + [""]
    if described.get("intervals"):
        rows += [f"Intervals: {described['intervals']}", ""]
    rows += [cells(["participant", "mean", "RMS", "95 %", "maximum", "RMS (deg)", "time (s)"]), cells(["---"] * 7)]
    for p in participants:
        score = found["participants"].get(p)
        if not score:
            continue
        if score.get("failed", "").startswith("left out"):
            continue
        if "failed" in score:
            rows.append(cells([LABELS[p], f"failed: `{score['failed'][:100].replace('|', ' ').replace('`', ' ')}`", "", "", "", "", f"{score['seconds']:.1f}"]))
            continue
        e = score["position"]["errors"]
        turned = score.get("orientation")
        rows.append(
            cells([LABELS[p], *(number(e[k]) for k in ("mean", "rms", "p95", "max")), number(turned["errors"]["rms"]) if turned else "", f"{score['seconds']:.1f}"])
        )
    return rows + [""]


def version(name):
    try:
        return importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return "not installed"


def write(folder, described, results, program):
    results = {name: results[name] for name in described if name in results and results[name].get("participants")}
    participants = [p for p in LABELS if any(p in found["participants"] for found in results.values())]
    date = os.environ.get("BENCHMARK_DATE") or datetime.date.today().isoformat()
    own = subprocess.run([program, "--version"], capture_output=True, text=True).stdout.strip()
    for name in results:
        figure(folder, name, described[name], participants)
    overview(results)
    out = [
        "# Benchmark",
        "",
        "<!-- written by `make benchmark` -->",
        "",
        f"Programs calibrate {len(results)} sets of real robots and predict test poses that they have not seen. Rules, files and participants:",
        "`tests/benchmark/README.md`.",
        "",
        *(f"- {sentence}" for sentence in summary(results)),
        "",
        "![Error of each set over the error of the nominal robot](figures/benchmark/overview.svg)",
        "",
        "    make benchmark",
        "    make benchmark REAL_SOURCE=FOLDER        # without a network",
        "",
        "`make benchmark` writes this page. To repeat one figure, run one set with one participant:",
        "",
        "    tests/benchmark/benchmark.py ETALON FOLDER --set ur10-grid --participant scipy_dh",
        "",
        f"Date: {date}. Programs: {own}; NumPy {version('numpy')}, SciPy {version('scipy')}, FIGAROH {version('figaroh')}, "
        f"Pinocchio {version('pin')}, Python {platform.python_version()}.",
        "",
        "## Position errors at test poses",
        "",
        "Root-mean-square error (mm). The numbers of poses are for calibration and test.",
        "",
        *position_table(results, participants),
        "",
        "Sets that a participant leaves out:",
        "",
        *left_out_table(results, participants),
        "",
        "## Intervals of positions",
        "",
        "Share of measured coordinates within the stated 95 % intervals, with its standard uncertainty from pose to pose. The exact 95 % interval of the",
        "share (Clopper & Pearson 1934) counts each test pose once. It is bold if it does not contain 95 %; the sections of these sets give the cause. The",
        "score is the mean interval score (mm; Gneiting & Raftery 2007): less is better.",
        "",
        *interval_table(results, participants, "position"),
        "",
        "## Intervals of orientations",
        "",
        "The same for rotations about the three axes (deg).",
        "",
        *interval_table(results, participants, "orientation"),
        "",
        "## Sets",
        "",
        "Errors in millimetres; faults of the data below the facts. No other figures are published on a stated split.",
        "",
    ]
    for name, found in results.items():
        out += section(name, described[name], found, participants)
    (DOCS / "benchmark.md").write_text("\n".join(out).rstrip() + "\n")

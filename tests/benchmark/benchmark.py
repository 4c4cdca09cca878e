#!/usr/bin/env python3
"""The benchmark of robot calibration: README.md states rules, files and participants.

    benchmark.py PROGRAM FOLDER [--source FOLDER] [--set NAME]... [--participant NAME]... [--page]

PROGRAM is the program `etalon`; FOLDER takes files and results. The files of a set are downloaded, or taken from --source, and must have the
SHA-256 of its description. A set is prepared, its split compared with the frozen one, each participant is called, and `etalon benchmark score`
compares its predictions with the hidden measurements. --page writes docs/benchmark.md and its figures from the results.

Exit code: 0 done; 1 a file cannot be had; 2 a file or a split has changed.
"""

import argparse
import csv
import hashlib
import importlib
import json
import pathlib
import shutil
import subprocess
import sys
import time
import tomllib
import urllib.request

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import chain  # noqa: E402

PARTICIPANTS = {
    "nominal": ["{python}", "{here}/participants/least_squares.py", "nominal", "{set}", "{answer}"],
    "scipy_dh": ["{python}", "{here}/participants/least_squares.py", "dh", "{set}", "{answer}"],
    "scipy_poe": ["{python}", "{here}/participants/least_squares.py", "poe", "{set}", "{answer}"],
    "figaroh": ["{python}", "{here}/participants/figaroh_peer.py", "{set}", "{answer}"],
    "etalon": ["{python}", "{here}/participants/etalon_peer.py", "{program}", "{set}", "{answer}"],
    "etalon_all": ["{python}", "{here}/participants/etalon_peer.py", "{program}", "{set}", "{answer}", "all"],
}


# seconds after which a participant is stopped
PATIENCE = 900


class Fault(Exception):
    """A message and an exit code."""


def sets(names=()):
    all_sets = {path.stem: tomllib.loads(path.read_text()) for path in sorted((HERE / "sets").glob("*.toml"))}
    for name in names:
        if name not in all_sets:
            raise Fault(f"no set {name}; sets: {', '.join(all_sets)}", 1)
    return {name: s for name, s in all_sets.items() if not names or name in names}


def fetch(entry, folder, source):
    """The file of an entry, from an earlier run, a folder or its address."""
    path = folder / "files" / entry["path"]
    right = lambda p: p.is_file() and hashlib.sha256(p.read_bytes()).hexdigest() == entry["sha256"]
    if right(path):
        return path
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(path.name + ".part")
    if source:
        if not (source / entry["path"]).is_file():
            raise Fault(f"{source / entry['path']} is missing", 1)
        shutil.copyfile(source / entry["path"], part)
    else:
        try:
            with urllib.request.urlopen(entry["address"], timeout=60) as answer, open(part, "wb") as file:
                shutil.copyfileobj(answer, file)
        except OSError as error:
            hint = "state a folder that contains the files: make benchmark REAL_SOURCE=FOLDER"
            raise Fault(f"{entry['address']} cannot be downloaded ({error})\nhint: {hint}", 1) from None
    if not right(part):
        raise Fault(f"{entry['path']}: SHA-256 differs from that of the description", 2)
    part.replace(path)
    return path


def groups(rows):
    """Number of the group of each row: poses with joint values that differ by less than 0.01 deg or 0.01 mm."""
    names, found = {}, []
    for row in rows:
        found.append(names.setdefault(row["rounded"], len(names)))
    return found


def is_test(name, split, rows):
    """Whether each row is a test row, by the frozen rule."""
    if split["rule"] == "series":
        return [row.get("series") in split["test"] for row in rows]
    # by hash: a function of the names of set and group alone
    draw = lambda group: int(hashlib.sha256(f"{name}:{group}".encode()).hexdigest()[:8], 16) % 1000
    return [draw(group) < 1000 * split["share"] for group in groups(rows)]


def rounded(columns, joints):
    step = lambda c: {"deg": 0.01, "rad": 1.7e-4, "m": 1e-5, "mm": 0.01}[c.rsplit("_", 1)[1]]
    return tuple(round(v / step(c)) for c, v in zip(columns, joints))


def write(path, head, rows):
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(head)
        writer.writerows(rows)


def prepare(name, described, folder, source):
    """Writes the files of a set; returns its counts and the hashes of the split."""
    files = [fetch(entry, folder, source) for entry in described["file"]]
    data = folder / "files" / "robots" / described["source"]
    reader = importlib.import_module(f"prepare.{described['prepare']}")
    columns, rows = reader.read(data, described.get("options", {}))
    for row in rows:
        row["rounded"] = rounded(columns, row["joints"])
    split = described["split"]
    test = is_test(name, split, rows)
    # `every` thins out large sets
    keep = lambda group, every: int(hashlib.sha256(f"keep:{name}:{group}".encode()).hexdigest()[:8], 16) % every == 0
    kept = [keep(g, split.get("test_every", 1) if t else split.get("calibration_every", 1)) for g, t in zip(groups(rows), test)]
    oriented = "q" in rows[0]
    head = ["pose", "target", *columns]
    measured = ["x_mm", "y_mm", "z_mm"] + (["qw", "qx", "qy", "qz"] if oriented else [])
    more = [("kind", "pose")] if oriented else []
    more += [(k, described["uncertainty"][k]) for k in ("u_mm", "urot_deg") if k in described.get("uncertainty", {})]
    # digits that do not hang on the machine
    line = lambda row: [row["pose"], row["target"], *(f"{v:.9f}" for v in row["joints"])]
    seen = lambda row: [f"{v:.6f}" for v in row["xyz"]] + [f"{v:.9f}" for v in row.get("q", [])]
    place = folder / "sets" / name
    calibration = [row for row, t, k in zip(rows, test, kept) if k and not t]
    hidden = [row for row, t, k in zip(rows, test, kept) if k and t]
    write(
        place / "calibration.csv",
        [*head, *measured, *(k for k, _ in more)],
        [[*line(r), *seen(r), *(v for _, v in more)] for r in calibration],
    )
    write(place / "test_joints.csv", head, [line(r) for r in hidden])
    write(folder / "hidden" / name / "test.csv", [*head, *measured], [[*line(r), *seen(r)] for r in hidden])
    robot = HERE / "robots" / described["robot"]
    shutil.copyfile(robot, place / "robot.toml")
    for path in files:
        if path.suffix == ".urdf":
            shutil.copyfile(path, place / path.name)
    (place / "chain.json").write_text(json.dumps(chain.chain(place / "robot.toml"), indent=1) + "\n")
    shared = {r["rounded"] for r in calibration} & {r["rounded"] for r in hidden}
    if shared:
        raise Fault(f"{name}: {len(shared)} joint rows are in both parts of the split", 2)
    frozen = {
        "calibration_sha256": hashlib.sha256((place / "calibration.csv").read_bytes()).hexdigest(),
        "test_sha256": hashlib.sha256((folder / "hidden" / name / "test.csv").read_bytes()).hexdigest(),
    }
    counts = {
        "calibration_poses": len({r["pose"] for r in calibration}),
        "test_poses": len({r["pose"] for r in hidden}),
        "calibration_rows": len(calibration),
        "test_rows": len(hidden),
        "oriented": oriented,
    }
    wrong = [k for k in frozen if split.get(k, frozen[k]) != frozen[k]]
    if wrong:
        raise Fault(f"{name}: the split has changed ({', '.join(wrong)})", 2)
    missing = [k for k in frozen if k not in split]
    if missing:
        print(f"{name}: not frozen yet: " + ", ".join(f'{k} = "{frozen[k]}"' for k in missing))
    return counts


def repeats(program, name, folder):
    """Messages of etalon about the split: distance of the test poses from the calibration poses."""
    place, hidden = folder / "sets" / name, folder / "hidden" / name / "campaign"
    hidden.mkdir(parents=True, exist_ok=True)
    with open(place / "calibration.csv", newline="") as file:
        calibration = list(csv.DictReader(file))
    with open(folder / "hidden" / name / "test.csv", newline="") as file:
        test = list(csv.DictReader(file))
    head = list(calibration[0])
    same = {k: calibration[0][k] for k in ("kind", "u_mm", "urot_deg") if k in head}
    write(hidden / "observations.csv", head, [[row[c] for c in head] for row in calibration + [{**r, **same} for r in test]])
    for path in place.iterdir():
        if path.name == "robot.toml" or path.suffix == ".urdf":
            shutil.copyfile(path, hidden / path.name)
    poses = lambda rows: json.dumps(", ".join(dict.fromkeys(r["pose"] for r in rows)))
    (hidden / "campaign.toml").write_text(
        f'name = "{name}"\nrobot = "robot.toml"\n[instrument]\nname = "of the set"\nexpanded_uncertainty_um = 100\n'
        'expanded_rotation_uncertainty_deg = 0.04\ncoverage_factor = 2\n[[observations]]\nfile = "observations.csv"\n[identify]\n'
        f'calibration = {poses(calibration)}\nvalidation = "rest"\n'
    )
    done = subprocess.run([program, "run", hidden], capture_output=True, text=True)
    accuracy = hidden / "out" / "accuracy.json"
    if not accuracy.is_file():
        return {"code": done.returncode, "error": done.stderr.strip()[:400]}
    document = json.loads(accuracy.read_text())
    validation = next((s for s in document["sets"] if s["name"] == "validation"), None)
    return {
        "code": done.returncode,
        "repeats": "repeats the calibration" in done.stderr,
        "distance": document.get("validation_distance"),
        "validation": validation,
    }


def take_part(program, name, participant, folder):
    """Calls a participant, and scores its predictions."""
    results = folder / "results" / name
    results.mkdir(parents=True, exist_ok=True)
    answer = results / f"{participant}.csv"
    answer.unlink(missing_ok=True)
    place = {"python": sys.executable, "here": HERE, "program": program, "set": folder / "sets" / name, "answer": answer}
    words = [word.format(**place) for word in PARTICIPANTS[participant]]
    began = time.perf_counter()
    try:
        done = subprocess.run(words, capture_output=True, text=True, timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        return {"failed": f"stopped after {PATIENCE} s", "seconds": time.perf_counter() - began}
    seconds = time.perf_counter() - began
    (results / f"{participant}.log").write_text(done.stdout + done.stderr)
    if not answer.is_file():
        lines = [line for line in done.stderr.strip().splitlines() if line.strip()]
        return {"failed": lines[-1] if lines else f"exit code {done.returncode}", "seconds": seconds}
    truth = folder / "hidden" / name / "test.csv"
    words = [program, "benchmark", "score", answer, "--truth", truth, "--json"]
    scored = subprocess.run(words, capture_output=True, text=True)
    if not scored.stdout:
        return {"failed": scored.stderr.strip(), "seconds": seconds}
    return {**json.loads(scored.stdout), "seconds": seconds}


def line(name, participant, score):
    if "failed" in score:
        return f"{name:22} {participant:14} failed: {score['failed'][:120]}"
    p = score["position"]
    text = f"{name:22} {participant:14} {p['errors']['mean']:8.4f} {p['errors']['rms']:8.4f} {p['errors']['p95']:8.4f} {p['errors']['max']:8.4f}"
    if p.get("intervals"):
        i = p["intervals"]
        text += f"  {100 * i['coverage']:6.1f} {i['mean_width']:8.4f} {i['mean_score']:8.4f}"
    if o := score.get("orientation"):
        text += f"  | {o['errors']['rms']:8.5f} deg"
        if o.get("intervals"):
            text += f" {100 * o['intervals']['coverage']:6.1f}"
    return text + f"  {score['seconds']:.1f} s"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--source", type=pathlib.Path)
    parser.add_argument("--set", action="append", default=[], dest="sets")
    parser.add_argument("--participant", action="append", default=[], choices=list(PARTICIPANTS))
    parser.add_argument("--prepare", action="store_true", help="stop after the split")
    parser.add_argument("--page", action="store_true")
    arguments = parser.parse_args()
    program, folder = pathlib.Path(shutil.which(arguments.program) or arguments.program).resolve(), arguments.folder.resolve()
    store = folder / "results.json"
    results = json.loads(store.read_text()) if store.is_file() else {}
    print(f"{'set':22} {'participant':14} {'mean':>8} {'RMS':>8} {'95 %':>8} {'max':>8}  {'cover':>6} {'width':>8} {'score':>8}")
    for name, described in sets(arguments.sets).items():
        entry = results.setdefault(name, {"participants": {}})
        entry.update(prepare(name, described, folder, arguments.source))
        if arguments.prepare:
            print(f"{name:22} {entry['calibration_poses']} + {entry['test_poses']} poses")
            continue
        if not arguments.participant or "split" not in entry:
            entry["split"] = repeats(program, name, folder)
            if entry["split"].get("repeats"):
                raise Fault(f"{name}: the test poses repeat calibration poses", 2)
        for participant in arguments.participant or PARTICIPANTS:
            entry["participants"][participant] = take_part(program, name, participant, folder)
            print(line(name, participant, entry["participants"][participant]), flush=True)
        store.write_text(json.dumps(results, indent=1) + "\n")
    if arguments.page:
        import page

        page.write(folder, sets(), results, program)


if __name__ == "__main__":
    try:
        main()
    except Fault as fault:
        print(f"error: {fault.args[0]}", file=sys.stderr)
        sys.exit(fault.args[1])

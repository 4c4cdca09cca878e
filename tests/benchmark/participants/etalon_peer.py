"""etalon by its command line: `identify` on the calibration rows, `benchmark predict` at the joint values of the test rows.

    etalon_peer.py PROGRAM FOLDER PREDICTIONS [EFFECTS]
"""

import pathlib
import subprocess
import sys


def main(program, folder, answer, effects=None):
    folder = pathlib.Path(folder)
    robot, found = folder / "robot.toml", pathlib.Path(answer).with_suffix(".parameters.json")
    words = [program, "identify", "--robot", robot, "--observations", folder / "calibration.csv", "--json"]
    words += ["--effects", effects] if effects else []
    done = subprocess.run(words, capture_output=True, text=True)
    sys.stderr.write(done.stderr)
    if done.returncode > 1:
        return done.returncode
    found.write_text(done.stdout)
    words = [program, "benchmark", "predict", folder / "test_joints.csv", "--robot", robot, "--parameters", found]
    done = subprocess.run(words, capture_output=True, text=True)
    sys.stderr.write(done.stderr)
    if done.returncode == 0:
        pathlib.Path(answer).write_text(done.stdout)
    return done.returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

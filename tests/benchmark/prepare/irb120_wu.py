"""An archive of MATLAB files: three reflectors at 36 poses, a fourth at 10 and a fifth at 30 test poses (mm, deg); the readings of all five at the
home position are in a script of the archive."""

import io
import re
import zipfile

from scipy.io import loadmat


def read(folder, options):
    archive = zipfile.ZipFile(folder / "MinimalPositionCalibrationSourceCode.zip")
    inside = {name.rsplit("/", 1)[-1]: name for name in archive.namelist()}
    array = lambda name: loadmat(io.BytesIO(archive.read(inside[f"{name}.mat"])))[name]
    script = archive.read(inside["Experiment.m"]).decode("latin-1")
    numbers = lambda name: [float(v) for v in re.findall(r"-?\d+\.\d+", re.search(rf"\b{name}=\[(.*?)\]", script, re.S)[1])]
    home = numbers("CaliPoint_Meas") + numbers("TestPoint_Meas") + numbers("TestPoint_Meas2")
    names = ["A", "B", "C", "D", "E"]
    rows = [
        {"pose": "home", "target": t, "joints": [0.0] * 6, "xyz": home[3 * k : 3 * k + 3]} for k, t in enumerate(names)
    ]
    joints, xyz = array("CaliJointAngles"), array("CaliPosition")
    for k in range(len(xyz)):
        rows.append({"pose": str(k // 3 + 1), "target": names[k % 3], "joints": joints[k // 3].tolist(), "xyz": xyz[k].tolist()})
    for target, more in (("D", ""), ("E", "2")):
        for k, (q, p) in enumerate(zip(array(f"TestJointAngles{more}"), array(f"TestPosition{more}")), 1):
            rows.append({"pose": f"test{target}{k}", "target": target, "joints": q.tolist(), "xyz": p.tolist(), "series": "test"})
    return [f"q{k}_deg" for k in range(1, 7)], rows

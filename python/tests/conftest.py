"""Samples of the repository, and an arm whose errors are known."""

import shutil
from pathlib import Path

import numpy as np
import pytest

import etalon

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def sample(tmp_path):
    """Copy a sample campaign."""

    def copy(name):
        to = tmp_path / name
        shutil.copytree(ROOT / "samples" / name, to, ignore=shutil.ignore_patterns("out"))
        return to

    return copy


def dh(joints_deg, alpha, a, theta, d):
    """Forward kinematics by modified Denavit-Hartenberg parameters (Craig), in NumPy alone: poses (n, 4, 4), mm and deg."""
    poses = np.tile(np.eye(4), (len(joints_deg), 1, 1))
    for i in range(len(a)):
        angle = np.radians(joints_deg[:, i] + theta[i])
        ca, sa, ct, st = np.cos(np.radians(alpha[i])), np.sin(np.radians(alpha[i])), np.cos(angle), np.sin(angle)
        step = np.zeros((len(joints_deg), 4, 4))
        step[:, 0] = np.stack([ct, -st, 0 * ct, 0 * ct + a[i]], axis=1)
        step[:, 1] = np.stack([st * ca, ct * ca, 0 * ct - sa, 0 * ct - sa * d[i]], axis=1)
        step[:, 2] = np.stack([st * sa, ct * sa, 0 * ct + ca, 0 * ct + ca * d[i]], axis=1)
        step[:, 3, 3] = 1.0
        poses = poses @ step
    return poses


#: IRB 120 by modified Denavit-Hartenberg parameters: alpha (deg), a (mm), theta (deg), d (mm).
IRB120 = (
    np.array([0.0, -90.0, 0.0, -90.0, 90.0, -90.0]),
    np.array([0.0, 0.0, 270.0, 70.0, 0.0, 0.0]),
    np.array([0.0, -90.0, 0.0, 0.0, 0.0, 180.0]),
    np.array([290.0, 0.0, 0.0, 302.0, 0.0, 72.0]),
)


def toml(parameters):
    """Return the robot.toml of such an arm."""
    rows = (f"{{ alpha_deg = {al}, a_mm = {a}, theta_deg = {th}, d_mm = {d} }}," for al, a, th, d in zip(*parameters))
    return 'model = "serial"\nconvention = "mdh"\njoint = [\n' + "\n".join(rows) + "\n]\n"


@pytest.fixture(scope="session")
def arm():
    """A nominal arm, observations of one with known errors (synthetic, noise 10 um), and these errors."""
    noise = np.random.default_rng(1)
    joints = noise.uniform([-150, -80, -80, -150, -100, -170], [150, 80, 60, 150, 100, 170], (60, 6))
    alpha, a, theta, d = (values.copy() for values in IRB120)
    a[2] += 0.35
    theta[1] += 0.05
    theta[2] -= 0.08
    poses = dh(joints, alpha, a, theta, d)
    target = np.array([30.0, 10.0, 60.0, 1.0])
    measured = (poses @ target)[:, :3] + noise.normal(0.0, 0.010, (60, 3))
    table = {"pose": np.arange(1, 61), "cycle": np.ones(60, dtype=int), "target": ["SMR"] * 60}
    table |= {f"q{i + 1}_deg": joints[:, i] for i in range(6)}
    table |= {name: measured[:, k] for k, name in enumerate(["x_mm", "y_mm", "z_mm"])}
    return etalon.Robot.from_toml(toml(IRB120)), table, {"a_3": 0.35, "theta_2": 0.05, "theta_3": -0.08}

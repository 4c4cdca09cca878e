"""A test to ISO 9283 from a recording: the robot visits two poses thirty times while a tracker records (synthetic data)."""

# %%
import numpy as np

import etalon

noise = np.random.default_rng(2)
poses = np.array([[800.0, 0.0, 500.0], [1000.0, 300.0, 700.0]])
commanded = {"pose": [1, 2], "x_mm": poses[:, 0], "y_mm": poses[:, 1], "z_mm": poses[:, 2]}
path = []
for _ in range(30):
    for start, end in ((1, 0), (0, 1)):
        move = np.linspace(poses[start], poses[end], 50)[1:]
        attained = poses[end] + [0.05, -0.02, 0.01] + noise.normal(0, 0.01, 3)
        path += [move, np.tile(attained, (50, 1))]
points = np.concatenate(path)
points += noise.normal(0, 0.003, points.shape)
recording = {"time_s": np.arange(len(points)) / 100, "x_mm": points[:, 0], "y_mm": points[:, 1], "z_mm": points[:, 2]}

# %% standstills at the commanded poses
motion = etalon.iso9283_path(recording, commanded)
visits = [stop for stop in motion.standstills if stop.pose is not None]
print(len(visits), "visits")

# %% accuracy AP and repeatability RP of each pose
means = np.array([v.mean_mm for v in visits])
attained = {"pose": [v.pose for v in visits], "cycle": [v.cycle for v in visits], "x_mm": means[:, 0], "y_mm": means[:, 1], "z_mm": means[:, 2]}
tested = etalon.iso9283(attained, commanded, expanded_uncertainty_um=6)
for pose in tested.poses:
    print(f"pose {pose.pose}: AP {1000 * (pose.ap_mm or 0):.1f} µm, RP {1000 * (pose.rp_mm or 0):.1f} µm")

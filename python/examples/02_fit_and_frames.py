"""Fit elements, and carry points from one frame into another (synthetic data)."""

# %%
import numpy as np

import etalon

noise = np.random.default_rng(1)
angle, height = noise.uniform(0, 2 * np.pi, 500), noise.uniform(0, 80, 500)
shaft = np.column_stack([20 * np.cos(angle), 20 * np.sin(angle), height]) + noise.normal(0, 0.003, (500, 3))

# %% a cylinder: axis, radius, form
cylinder = etalon.fit.cylinder(shaft)
u = cylinder.standard_uncertainty
print(f"radius {cylinder.radius_mm:.4f} mm ± {2 * u.radius_mm:.4f} mm (k = 2), form {cylinder.form_mm:.4f} mm")

# %% the largest residuals
worst = np.argsort(np.abs(cylinder.residuals_mm))[-3:]
print("worst points:", worst, cylinder.residuals_mm[worst])

# %% targets in two frames: the pose of one in the other
here = noise.normal(size=(5, 3)) * 300
turn = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]])
there = here @ turn.T + [1000, 200, 0] + noise.normal(0, 0.01, (5, 3))
frame = etalon.frames.rigid(here, onto=there)
print(frame.matrix.round(3), f"RMS {frame.rms_mm * 1000:.1f} µm", sep="\n")

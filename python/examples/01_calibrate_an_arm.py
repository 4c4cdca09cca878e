"""Calibrate an arm from a CSV: sixty poses of one reflector, read by a laser tracker (synthetic data)."""

# %%
import etalon

robot = etalon.Robot("arm.toml")
found = etalon.identify(robot, "arm.csv", standard_uncertainty_um=10)
for p in found.parameters:
    if p.standard_uncertainty and abs(p.value - p.nominal) > 2 * p.standard_uncertainty:
        print(f"{p.name:10} {p.nominal:10.4f} -> {p.value:10.4f} ± {2 * p.standard_uncertainty:.4f} {p.unit} (k = 2)")

# %% the file that `etalon export` makes controller files of
with open("parameters.json", "w") as file:
    file.write(found.to_json(indent=2))

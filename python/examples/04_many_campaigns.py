"""Many campaigns: on all cores of one machine, then by a function that pools and clusters take as it is (synthetic data)."""

# %%
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import etalon

folders = [f"robot-{i}" for i in range(4)]
for folder in folders:
    for command in (["init", folder, "--synthetic"], ["simulate", folder]):
        subprocess.run([sys.executable, "-m", "etalon", *command], check=True, capture_output=True)

# %% one process, all cores; campaigns that have not changed are read back
found = etalon.batch(folders, progress=lambda done, whole: print(done, "of", whole))
print([(campaign.campaign, campaign.ended) for campaign in found.campaigns])


# %% one campaign a task: process pools, joblib, Dask and Ray take this function as it is
def calibrate(folder: str) -> dict[str, object]:
    run = etalon.run(folder, reports=False)
    return {"folder": folder, "met": run.met, "s_mm": next(p.value for p in run.parameters.parameters if p.name == "s")}


# threads are enough, since etalon releases the GIL
with ThreadPoolExecutor(2) as pool:
    print(list(pool.map(calibrate, folders)))

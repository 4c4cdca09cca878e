"""Many campaigns: on all cores of one machine, then by the same call on a cluster (synthetic data)."""

# %%
import subprocess
import sys

import etalon

folders = [f"robot-{i}" for i in range(4)]
for folder in folders:
    for command in (["init", folder, "--synthetic"], ["simulate", folder]):
        subprocess.run([sys.executable, "-m", "etalon", *command], check=True, capture_output=True)

# %% one process, all cores; campaigns that have not changed are read back
found = etalon.batch(folders, progress=lambda done, whole: print(done, "of", whole))
print([(campaign.campaign, campaign.ended) for campaign in found.campaigns])


# %% one campaign a task: Dask and Ray take this function as it is
def calibrate(folder: str) -> dict:
    run = etalon.run(folder, reports=False)
    return {"folder": folder, "met": run.met, "s_mm": next(p.value for p in run.parameters.parameters if p.name == "s")}


try:
    from distributed import Client
except ImportError:
    print([calibrate(folder) for folder in folders])
else:
    # a cluster in this process, since etalon releases the GIL; Client("SCHEDULER:8786") is a real one
    with Client(processes=False, n_workers=2, threads_per_worker=1, dashboard_address=None) as client:
        print(client.gather(client.map(calibrate, folders)))

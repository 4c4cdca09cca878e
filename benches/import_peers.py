"""Reads `name x y z` with polars or pandas and prints seconds, rows a second and the peak of memory."""

import resource
import sys
import time

peer, path = sys.argv[1:]
names = ["label", "x", "y", "z"]
if peer == "polars":
    import polars

    before = time.perf_counter()
    schema = {"label": polars.Categorical, "x": polars.Float64, "y": polars.Float64, "z": polars.Float64}
    table = polars.read_csv(path, separator=" ", has_header=False, schema=schema)
    seconds = time.perf_counter() - before
    labels = table["label"].n_unique()
else:
    import pandas

    before = time.perf_counter()
    table = pandas.read_csv(path, sep=" ", header=None, names=names, dtype={"label": "category"}, engine="c")
    seconds = time.perf_counter() - before
    labels = table["label"].nunique()
rows = len(table)
peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 / 1e6
sums = " ".join(f"{table[name].sum():.6f}" for name in names[1:])
print(f"{seconds:6.2f} s, {rows / seconds / 1e6:5.1f} million rows/s, peak {peak:.0f} MB, {labels} labels, sums {sums}")

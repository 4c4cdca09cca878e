#!/usr/bin/env python3
"""Compares results with certified values, relative to their maximum permissible errors: compare.py certified.json found.json

found.json holds what another program found, in the words of certified.json: `parameters` (name, value, before),
`covariance` (parameters, lower_triangle), `residuals`, `errors`. Output folders of etalon are taken as they are.
"""

import json
import sys
from decimal import Decimal
from pathlib import Path


def of_etalon(folder):
    """Documents of etalon in the words of certified.json."""
    found = json.loads((folder / "parameters.json").read_text(), parse_float=Decimal)
    accuracy = json.loads((folder / "accuracy.json").read_text(), parse_float=Decimal)
    names = [p["name"] for p in found["parameters"] if p["status"] == "identified"]
    errors = [e | {"set": s["name"]} for s in accuracy["sets"] for e in s["errors"]]
    lower = [row[: i + 1] for i, row in enumerate(found["covariance"])]
    residuals = {"rms_mm": found["residuals"]["rms"], "chi_square": found["residuals"]["chi_square"]}
    covariance = {"parameters": names, "lower_triangle": lower}
    return {"parameters": found["parameters"], "covariance": covariance, "errors": errors, "residuals": residuals}


def compare(certified, found):
    """Yields the name of each value, its error over the permissible one."""
    values = {p["name"]: p for p in found["parameters"]}
    for p in certified["parameters"]:
        for key in ("value", "before"):
            if key in p and key in values[p["name"]]:
                yield f"{p['name']} {key}", abs(Decimal(values[p["name"]][key]) - Decimal(p[key])) / Decimal(p["mpe"])
    matrix = lambda c: {
        (a, b): Decimal(v)
        for a, row in zip(c["parameters"], c["lower_triangle"])
        for b, v in zip(c["parameters"], row)
    }
    expected, other = matrix(certified["covariance"]), matrix(found["covariance"])
    other |= {(b, a): v for (a, b), v in other.items()}
    for (a, b), v in expected.items():
        scale = (expected[a, a] * expected[b, b]).sqrt()
        yield f"covariance {a} {b}", abs(other[a, b] - v) / scale / Decimal(certified["covariance"]["mpe_relative"])
    for key in ("rms_mm", "chi_square"):
        expected = Decimal(certified["residuals"][key])
        yield key, abs(Decimal(found["residuals"][key]) / expected - 1) / Decimal(certified["residuals"]["mpe_relative"])
    entries = {(e["set"], e["quantity"]): e for e in found["errors"]}
    for e in certified["errors"]:
        other = entries[e["set"], e["quantity"]]
        for side in ("before", "after"):
            for key, v in e.get(side, {}).items():
                yield f"{e['set']} {e['quantity']} {side} {key}", abs(Decimal(other[side][key]) - Decimal(v)) / Decimal(e["mpe"])


def main(certified, found):
    expected = json.loads(Path(certified).read_text(), parse_float=Decimal)
    found = Path(found)
    other = of_etalon(found) if found.is_dir() else json.loads(found.read_text(), parse_float=Decimal)
    ratios = sorted(compare(expected, other), key=lambda entry: -entry[1])
    beyond = [entry for entry in ratios if not entry[1] <= 1]
    print(f"{expected['campaign']}: {len(ratios)} values, {len(beyond)} beyond the permissible error; largest share:")
    for name, ratio in beyond[:20] or ratios[:1]:
        print(f"  {ratio:.3g}  {name}")
    return 1 if beyond else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) if len(sys.argv) == 3 else __doc__)

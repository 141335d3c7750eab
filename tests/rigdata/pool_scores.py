#!/usr/bin/env python3
"""The scores of several suites of blind sets, pooled, and every set as a line of CSV.

    pool_scores.py [--csv FILE] NAME=SUITE [NAME=SUITE ...]

SUITE is a folder that has been scored (blind_sets.py), NAME what its column is called. Right first: of the
accepted effects the strongest is a hidden one, and none of the hidden is only said to explain as much (a set that
ends as `undecidable` is wrong). Exact: the accepted are the hidden. No answer is wrong, on a clean set a false
alarm. Error: root mean square over the channels of the error after over that of the true model, validation window.
"""
import csv
import math
import os
import sys

from blind_sets import read, scored_sets, share_text

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../scripts"))
from docfigures import blind


def error_ratio(truth, result):
    levels = truth["validation_rmse"]["true_model"]
    ratios = [result["channels"][c]["after"]["rmse"] / level
              for c, level in levels.items() if c in result["channels"]]
    return math.sqrt(sum(r * r for r in ratios) / len(ratios))


def describe(suite, name, kind, truth, result):
    hidden = [e["name"] for e in truth["effects"]]
    row = {"suite": suite, "set": name, "kind": kind,
           "hidden": "+".join(e["name"] + (" (weak)" if e["grade"] == "weak" else "")
                              for e in truth["effects"]) or "nothing",
           "form": "; ".join(e["form"] for e in truth["effects"]),
           "size_over_noise": "+".join(f"{e['size_over_noise']:.1f}" for e in truth["effects"])}
    if result is None:
        return {**row, "accepted": "no answer", "verdict": "", "error_ratio": "", "right": "0", "exact": "0",
                "formula": ""}
    accepted = [e["name"] for e in result["effects"]]
    formulas = [" ".join([e["formula"], *e.get("on", [])]) for e in result["effects"] if e.get("formula")]
    decided = result["verdict"] != "undecidable"
    return {**row, "accepted": "+".join(accepted) or "nothing", "verdict": result["verdict"],
            "error_ratio": f"{error_ratio(truth, result):.3f}",
            "right": str(int(bool(accepted) and accepted[0] in hidden and decided)),
            "exact": str(int(sorted(accepted) == sorted(hidden) and decided)),
            "formula": "; ".join(formulas)}


def summary(rows):
    """(measure, share with its interval) of each measure that the documentation prints."""
    parted = blind.parted(rows)
    return [(what, share_text(*blind.of(parted, kind, good))) for what, _, kind, good in blind.MEASURES]


def main():
    words = sys.argv[1:]
    table = words[1] if words[:1] == ["--csv"] and len(words) > 1 else None
    suites = [w.split("=", 1) for w in (words[2:] if table else words)]
    if not suites or any(len(s) != 2 for s in suites):
        print(__doc__.split("\n\n")[1].strip(), file=sys.stderr)
        return 2
    rows = []
    for name, suite in suites:
        for entry, kind, truth, result in scored_sets(suite):
            row = describe(name, entry, kind, truth, result)
            row["seconds"] = round(read(os.path.join(suite, "results", entry + ".run.json"))["seconds"])
            rows.append(row)
    if not rows:
        print("pool_scores: no set of these suites has been scored", file=sys.stderr)
        return 3
    columns = [summary([r for r in rows if r["suite"] == name]) for name, _ in suites]
    print("| | " + " | ".join(name for name, _ in suites) + " | pooled |")
    print("|" + "---|" * (len(suites) + 2))
    for k, (what, pooled) in enumerate(summary(rows)):
        print(f"| {what} | " + " | ".join(column[k][1] for column in columns) + f" | {pooled} |")
    if table:
        with open(table, "w", newline="") as file:
            writer = csv.DictWriter(file, fieldnames=list(rows[0]), lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())

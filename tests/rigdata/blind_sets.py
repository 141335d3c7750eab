"""Blind sets that have been scored: what was hidden, what was said, and how sure a share of them is.

A suite is a folder with the truth in `truth`, the results in `results` (`scripts/make_test_data --score SUITE`).
"""
import json
import math
import os


def read(path):
    with open(path) as file:
        return json.load(file)


def scored_sets(suite):
    """(set, kind, truth, result or None) of each set that has been tried."""
    for entry in read(os.path.join(suite, "truth", "index.json")):
        results = os.path.join(suite, "results")
        if not os.path.exists(os.path.join(results, entry["set"] + ".run.json")):
            continue
        truth = read(os.path.join(suite, "truth", entry["truth"]))
        path = os.path.join(results, entry["set"], "result.json")
        yield entry["set"], entry["kind"], truth, read(path) if os.path.exists(path) else None


def _at_least(k, n, p):
    return sum(math.comb(n, i) * p**i * (1 - p) ** (n - i) for i in range(k, n + 1))


def share_interval(good, of):
    """Exact 95 % interval of a share (Clopper and Pearson 1934), of > 0."""

    def last_where(holds):
        low, high = 0.0, 1.0
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if holds(middle) else (low, middle)
        return low

    lower = 0.0 if good == 0 else last_where(lambda p: _at_least(good, of, p) < 0.025)
    upper = 1.0 if good == of else last_where(lambda p: 1 - _at_least(good + 1, of, p) > 0.025)
    return lower, upper


def share_text(good, of):
    if of == 0:
        return "none"
    low, high = share_interval(good, of)
    return f"{good} of {of} ({100 * low:.0f} … {100 * high:.0f} %)"

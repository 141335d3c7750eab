#!/usr/bin/env python3
"""Do the 95 % intervals of `phs identify` hold the truth as often as they say?

    interval_coverage.py SUITE [SUITE ...]

SUITE is a folder of blind sets that has been scored (`scripts/make_test_data --score SUITE`): the truth in
SUITE/truth, the results in SUITE/results. Counted are the five numbers of the declared quarter rig whose truth is
known in every set (oil and gas of both lines, scale of friction), in sets whose hidden effects were found exactly,
clean ones included: an interval says nothing where the model is another. Nor is a number counted beside an effect of its
own kind (a line's gas beside a diaphragm that stops, the scale of friction beside Stribeck's): what is left of it then is
a matter of the effect's form, which differs between generator and catalogue. Where the truth has a little of something that is on no
list (coverage_suite.py), a number of its kind is counted apart: what it is then is a matter of words. Of the effects' own amounts those count
whose form generator and catalogue write alike (effect_truth.py). Prints how many hold the truth, for each
number and for sets without and with effects, with the exact binomial interval (Clopper and Pearson 1934), and of
what misses, by how many of its own half widths. Exit: 0 counted, 2 wrong usage, 3 nothing to count.
"""
import math
import sys

from blind_sets import scored_sets, share_interval
from effect_truth import true_amounts

# The declared numbers of quarter_setup2 and the name of their factor in the truth.
NUMBERS = {
    "L2.oil_volume_m3": (1.1e-3, "oil_compliance_bore"),
    "L1.oil_volume_m3": (1.1e-3, "oil_compliance_rod"),
    "L2.gas_volume_m3": (16.16e-6, "gas_volume_bore"),
    "L1.gas_volume_m3": (16.16e-6, "gas_volume_rod"),
    "friction.scale": (1.0, "friction"),
}

SHARED = "of the kind of the little that is on no list"

# Effects of a kind of their own: neither oil and gas nor the level of friction follow from them.
FRICTION = {"stribeck", "presliding", "pressure_friction", "position_friction", "dwell_friction", "viscous_friction",
            "asymmetric_friction", "temperature_friction"}
HYDRAULIC = {"piston_leakage", "external_leakage", "line_resistance", "line_inertance", "check_restriction",
             "entrained_air", "hose_expansion", "gas_thermal", "accumulator_precharge", "diaphragm_stop", "cavitation",
             "temperature_drift", "pressure_area"}
# The same of what is on no list (generate_rig_data --list).
FRICTION |= {"friction_heating", "acceleration_friction", "seal_swelling", "load_cell_hysteresis"}
HYDRAULIC |= {"piston_area_error", "relief_valve", "pressure_crosstalk", "oil_stiffening"}


def is_touched(number, hidden):
    return bool(set(hidden) & (FRICTION if number.startswith("friction") else HYDRAULIC))


def numbers_of(truth, result, hidden):
    """(row of the table, number, its true value, what was said) of all that counts."""
    little = [e["name"] for e in truth.get("discrepancy", [])]
    for number, (declared, factor) in NUMBERS.items():
        if number in result["fitted"] and not is_touched(number, hidden):
            row = SHARED if is_touched(number, little) else number
            yield row, number, declared * truth["factors_on_declared"][factor], result["fitted"][number]
    found = {effect["name"]: effect["parameters"] for effect in result["effects"]}
    for effect in truth["effects"]:
        for number, value in true_amounts(effect).items():
            if number in found[effect["name"]]:
                yield "effects' amounts", f"{effect['name']}.{number}", value, found[effect["name"]][number]


def in_half_widths(value, fit):
    """How far beyond the fitted value the truth lies; logarithmic where all is positive, as the intervals are."""
    side = fit["high"] if value > fit["value"] else fit["low"]
    if min(value, fit["value"], side) <= 0:
        return (value - fit["value"]) / (side - fit["value"])
    return math.log(value / fit["value"]) / math.log(side / fit["value"])


def main():
    suites = sys.argv[1:]
    if not suites or any(s.startswith("-") for s in suites):
        print(__doc__.split("\n\n")[1].strip(), file=sys.stderr)
        return 2
    held, misses = {}, []
    for suite in suites:
        for name, _, truth, result in scored_sets(suite):
            hidden = sorted(e["name"] for e in truth["effects"])
            if result is None or hidden != sorted(e["name"] for e in result["effects"]):
                continue
            kind = "with effects" if hidden else "clean"
            for row, number, value, fit in numbers_of(truth, result, hidden):
                good = fit["low"] <= value <= fit["high"]
                for of in (row,) if row not in NUMBERS else (row, f"all, {kind}", "all"):
                    count = held.setdefault(of, [0, 0])
                    count[0] += good
                    count[1] += 1
                if not good:
                    misses.append((f"{suite}/{name}", number, in_half_widths(value, fit), ", ".join(hidden) or "clean"))
    if not held:
        print("interval_coverage: no scored set whose effects were found exactly", file=sys.stderr)
        return 3
    print("| number | intervals that hold the truth | 95 % interval |\n|---|---|---|")
    for row, (good, of) in sorted(held.items()):
        low, high = share_interval(good, of)
        print(f"| {row} | {good} of {of} ({100 * good / of:.0f} %) | {100 * low:.0f} … {100 * high:.0f} % |")
    print("\nMisses, in half widths of the interval:")
    for place, number, off, hidden in sorted(misses, key=lambda m: -m[2]):
        print(f"  {place} {number}: {off:.1f} ({hidden})")
    return 0


if __name__ == "__main__":
    sys.exit(main())

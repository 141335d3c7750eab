#!/usr/bin/env python3
"""Do the 95 % intervals of `phs identify` hold the truth on a bogie in a curve?

    bogie_coverage.py GENERATOR PHS DATA FOLDER [--records 36] [--seed 1] [--clean] [--jobs 2] [--csv FILE]

GENERATOR is generate_bogie_curve, the independent multibody program; DATA the folder that holds models. Record k has
seed + k, a curve of 550, 250 or 300 m and, in turn, nothing hidden, a seal, the cant, a leak, the springs of a box or
the gas of a line, of an amount drawn by its seed; --clean: nothing in any, the curves in turn. Counted are the
declared numbers (scale of friction, gas) where what was accepted is what is hidden, and then the amount, too. Prints
how many hold the truth, with the exact binomial interval, and of what misses by how many half widths; writes a row for
each interval. Results that are there are kept.
"""
import argparse
import csv
import json
import math
import os
import random
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

from blind_sets import share_text

# Curve: speed, windows of fit and score, as docs/identify_bogie.md has them.
CURVES = {"r550": (80, "[0.2, 13]", "[13, 24.5]"), "r250": (50, "[0.2, 16]", "[16, 30.8]"),
          "r300": (55, "[0.2, 15]", "[15, 28]")}
# What can be hidden: range (drawn evenly in the logarithm, the cant with either sign), effect, its number, its place.
HIDDEN = [None, ("seal_1", (0.4, 3), "seal_friction", "factor", "1"), ("cant", (0.008, 0.025), "cant_error", "cant_m", ""),
          ("leak_L2", (1e-12, 6e-12), "external_leakage", "conductance_m3_per_Pas", "L2"),
          ("box_spring", (0.5, 2), "box_spring", "factor", "lead_left"), ("gas_L3", (0.5, 2.5), "gas_volume", "factor", "L3")]
NUMBERS = {"friction.scale": 1.0, "lines.gas_volume_m3": 16.16e-6}


def drawn(seed, place):
    hidden = HIDDEN[place % len(HIDDEN)]
    if hidden is None:
        return None, 0.0
    source = random.Random(seed)
    low, high = hidden[1]
    amount = math.exp(source.uniform(math.log(low), math.log(high)))
    return hidden, amount * (source.choice((-1, 1)) if hidden[0] == "cant" else 1)


def identified(args, k):
    """(name of the curve, what is hidden, its amount, truth, result) of record k."""
    seed = args.seed + k
    curve = list(CURVES)[(k if args.clean else k // len(HIDDEN)) % len(CURVES)]
    hidden, amount = (None, 0.0) if args.clean else drawn(seed, k)
    folder = os.path.join(args.folder, f"record_{seed}")
    said = os.path.join(folder, "out", "result.json")
    if not os.path.exists(said):
        os.makedirs(folder, exist_ok=True)
        hide = ["--hide", f"{hidden[0]}={amount!r}"] if hidden else []
        subprocess.run([args.generator, "--curve", curve, "--seed", str(seed), "--profiles",
                        os.path.join(args.data, "models", "profiles"), "--out", os.path.join(folder, "run.csv"),
                        "--truth", os.path.join(folder, "truth.json"), *hide], check=True, stdout=subprocess.DEVNULL)
        speed, fit, score = CURVES[curve]
        with open(os.path.join(args.data, "models", "scenarios", "measured_r550.yaml")) as file:
            scenario = file.read().replace("curve_r550", "curve_" + curve).replace("speed_km_h: 80", f"speed_km_h: {speed}")
        with open(os.path.join(folder, "scenario.yaml"), "w") as file:
            file.write(scenario)
        with open(os.path.join(folder, "manifest.yaml"), "w") as file:
            file.write(f"rig: bogie\nmodel: scenario.yaml\ndata: run.csv\nestimation: {fit}\nvalidation: {score}\n")
        subprocess.run([args.phs, "identify", os.path.join(folder, "manifest.yaml"), "--out", os.path.join(folder, "out"),
                        "--force", "--quiet", "--threads", "1", "--max-effects", "1"], check=True, stdout=subprocess.DEVNULL)
    with open(os.path.join(folder, "truth.json")) as truth, open(said) as result:
        return curve, hidden, amount, json.load(truth), json.load(result)


def rows_of(seed, curve, hidden, amount, truth, result):
    """(seed, curve, hidden, verdict, number, its truth, value, low, high) of each interval; none where it is not found."""
    found = [(e["name"], "".join(e.get("on", []))) for e in result["effects"]]
    wanted = [(hidden[2], hidden[4])] if hidden else []
    head = [seed, curve, f"{hidden[0]}={amount:.4g}" if hidden else "nothing", result["verdict"]]
    if found != wanted:
        return [head + ["nothing counted", "", "", "", ""]]
    said = [(n, declared * truth["factors_on_declared"][n], result["fitted"][n]) for n, declared in NUMBERS.items()]
    if hidden:
        said.append((f"{hidden[2]}.{hidden[3]}", amount, result["effects"][0]["parameters"][hidden[3]]))
    return [head + [number] + [f"{v:.6g}" for v in (true, s["value"], s["low"], s["high"])] for number, true, s in said]


def count(rows):
    counted = [r for r in rows if r[5] != ""]
    for number in sorted({r[4] for r in counted}, key=lambda n: (n not in NUMBERS, n)):
        mine = [[float(v) for v in r[5:9]] for r in counted if r[4] == number]
        held = sum(low <= true <= high for true, _, low, high in mine)
        off = [abs(true - value) / ((high if true > value else low) - value) * (1 if true > value else -1)
               for true, value, low, high in mine if not low <= true <= high]
        print(f"{number}: {share_text(held, len(mine))} hold the truth"
              + (f"; missed by {', '.join(f'{x:.1f}' for x in sorted(off))} half widths" if off else ""))
    same = sum(r[4] != "nothing counted" for r in rows if r[4] in ("nothing counted", "friction.scale"))
    print(f"{same} of {len({r[0] for r in rows})} records accepted as hidden")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name in ("generator", "phs", "data", "folder"):
        parser.add_argument(name)
    parser.add_argument("--records", type=int, default=36)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--clean", action="store_true")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--csv")
    args = parser.parse_args()
    with ThreadPoolExecutor(args.jobs) as pool:
        done = list(pool.map(lambda k: identified(args, k), range(args.records)))
    rows = [row for k, one in enumerate(done) for row in rows_of(args.seed + k, *one)]
    if args.csv:
        with open(args.csv, "w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["seed", "curve", "hidden", "verdict", "number", "truth", "value", "low", "high"])
            writer.writerows(rows)
    count(rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())

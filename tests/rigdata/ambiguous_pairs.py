#!/usr/bin/env python3
"""Effects that a poor record does not name, and the test that `phs identify --between` designs for them.

    ambiguous_pairs.py GENERATOR PHS FOLDER [--seeds N] [--only A/B] [--over-noise X] [--keep]

Of each pair and seed, either effect is hidden in a rig that makes one small motion, so weak that the best
declared model leaves it X times its floor there; a rig where no size of the effect does that is left out.
`phs identify --between A,B` of that record designs a test; the same rig makes it, and a random motion of the
same length and within the same limits, both by the equations of the independent generator. Each is
identified anew, with the whole catalogue. Right: the effect that is there is named first, and the other is
not said to explain as much. FOLDER is made anew; --keep: what is there is kept and not made again.
"""
import argparse
import json
import math
import os
import random
import shutil
import subprocess
import sys

STEP = 0.005
SECONDS = 60
LIMITS = {"low": -2.2e-3, "high": 3.2e-3, "speed": 0.03, "force": 9e4}
# One, other, amplitude [mm] and frequency [Hz] of the small motion.
PAIRS = [
    ("external_leakage", "hose_expansion", 0.6, 0.1),
    ("backlash", "mount_compliance", 0.3, 0.25),
    ("line_resistance", "check_restriction", 0.8, 0.5),
    ("stribeck", "viscous_friction", 0.5, 0.25),
    ("mount_compliance", "bush_viscoelastic", 0.6, 0.25),
    ("entrained_air", "hose_expansion", 0.6, 0.25),
    ("piston_leakage", "external_leakage", 0.6, 0.1),
]


def fade(u):
    u = min(max(u, 0.0), 1.0)
    return u * u * u * (10 + u * (6 * u - 15))


def write_motion(path, x):
    with open(path, "w") as file:
        file.write("t_s,actuator_m\n")
        for i, value in enumerate(x):
            file.write(f"{i * STEP:.3f},{value:.9f}\n")


def small_motion(path, amplitude_mm, frequency):
    count = int(SECONDS / STEP)
    write_motion(path, [1e-3 * amplitude_mm * math.sin(2 * math.pi * frequency * i * STEP) *
                        fade(i * STEP - 3) * fade(SECONDS - 3 - i * STEP) for i in range(count)])


def random_motion(path, seed):
    draw = random.Random(seed)
    terms = [(10 ** draw.uniform(-1.3, 0.5), draw.uniform(0, 2 * math.pi)) for _ in range(30)]
    raw = [sum(math.sin(2 * math.pi * f * i * STEP + p) / math.sqrt(f) for f, p in terms)
           for i in range(int(SECONDS / STEP))]
    peak = max(map(abs, raw))
    middle, half = (LIMITS["low"] + LIMITS["high"]) / 2, (LIMITS["high"] - LIMITS["low"]) / 2
    x = [(middle + half * r / peak) * fade((i * STEP - 3) / 2) * fade((SECONDS - 3 - i * STEP) / 2)
         for i, r in enumerate(raw)]
    top = max(abs(b - a) for a, b in zip(x, x[1:])) / STEP
    factor = min(1.0, LIMITS["speed"] / top)
    write_motion(path, [factor * v for v in x])


def generate(args, effect, seed, small, motion, folder):
    """The effect is scaled on the small motion, the record made on `motion`."""
    if os.path.exists(folder + "/truth.json"):
        return
    then = [] if motion == small else ["--then", motion]
    subprocess.run([args.generator, "--effect", effect, "--over-noise", str(args.over_noise), "--seed",
                    str(seed), "--motion", small, *then, "--out", folder], check=True)
    with open(folder + "/MANIFEST.yaml", "a") as file:
        file.write("limits: {{stroke_m: [{low}, {high}], speed_m_s: {speed}, force_N: {force}}}\n"
                   .format(**LIMITS))


def identify(args, folder, more=()):
    out = folder + "/result"
    if not os.path.exists(out + "/result.json"):
        subprocess.run([args.phs, "identify", folder + "/MANIFEST.yaml", "--out", out, "--force",
                        "--quiet", *more], check=True, stdout=subprocess.DEVNULL)
    with open(out + "/result.json") as file:
        return json.load(file)


def named(result):
    return [(e["name"], e["confusable_with"]) for e in result["effects"]]


def is_right(result, truth, other):
    effects = named(result)
    return bool(effects) and effects[0][0] == truth and other not in effects[0][1]


def run_case(args, pair, truth, seed):
    one, other, amplitude, frequency = pair
    rival = other if truth == one else one
    base = f"{args.folder}/{one}-{other}/{truth}-{seed}"
    os.makedirs(base, exist_ok=True)
    small = base + "/small.csv"
    small_motion(small, amplitude, frequency)
    random_motion(base + "/random.csv", seed)
    generate(args, truth, seed, small, small, base + "/small")
    with open(base + "/small/truth.json") as file:
        size = json.load(file)["effects"][0]["size_over_noise"]
    if not 0.5 < size / args.over_noise < 2:
        # The declared numbers swallow it, or its largest size is too small.
        print(json.dumps({"pair": f"{one} / {other}", "truth": truth, "seed": seed,
                          "left_out": f"leaves {size:.3g} times its floor"}), flush=True)
        return None
    first = identify(args, base + "/small", ["--between", f"{one},{other}"])
    design = first.get("test_design", {})
    row = {"pair": f"{one} / {other}", "truth": truth, "seed": seed, "small": first["verdict"],
           "small_named": named(first), "told_by_small": is_right(first, truth, rival),
           "motion": design.get("motion"), "question": (design.get("questions") or [None])[0],
           "next_test": first["next_test"]}
    for kind, motion in (("designed", base + "/small/result/next_test.csv"), ("random", base + "/random.csv")):
        if not os.path.exists(motion):
            row[kind + "_right"] = False
            continue
        generate(args, truth, seed, small, motion, f"{base}/{kind}")
        result = identify(args, f"{base}/{kind}")
        row[kind], row[kind + "_verdict"] = named(result), result["verdict"]
        row[kind + "_right"] = is_right(result, truth, rival)
    print(json.dumps(row), flush=True)
    return row


def table(rows):
    lines = ["| pair | records | told by the small motion | by the designed test | by a random test | expected |",
             "|---|---|---|---|---|---|"]
    for name in dict.fromkeys(r["pair"] for r in rows):
        of = [r for r in rows if r["pair"] == name]
        sure = [next(p["probability_right"] for p in r["question"]["if_true"] if p["name"] == r["truth"])
                for r in of if r["question"]]
        expected = f"{100 * sum(sure) / len(sure):.0f} %" if sure else "–"
        told = [sum(r[k] for r in of) for k in ("told_by_small", "designed_right", "random_right")]
        lines.append(f"| {name} | {len(of)} | {told[0]} | {told[1]} | {told[2]} | {expected} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("generator")
    parser.add_argument("phs")
    parser.add_argument("folder")
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--first-seed", type=int, default=501)
    parser.add_argument("--over-noise", type=float, default=0.5)
    parser.add_argument("--only", default="")
    parser.add_argument("--keep", action="store_true")
    parser.add_argument("--least", type=float, default=0.0, help="share that must be right")
    args = parser.parse_args()
    if not args.keep:
        shutil.rmtree(args.folder, ignore_errors=True)
    rows = []
    for pair in PAIRS:
        if args.only and f"{pair[0]}/{pair[1]}" not in args.only.split(","):
            continue
        for seed in range(args.first_seed, args.first_seed + args.seeds):
            for truth in pair[:2]:
                rows.append(run_case(args, pair, truth, seed))
    rows = [r for r in rows if r]
    print(table(rows))
    asked = [r for r in rows if not r["told_by_small"]]
    right = sum(r["designed_right"] for r in asked)
    print(f"{right} of {len(asked)} designed tests name what the small motion did not; "
          f"a random test {sum(r['random_right'] for r in asked)}")
    return 0 if asked and right >= args.least * len(asked) else 1


if __name__ == "__main__":
    sys.exit(main())

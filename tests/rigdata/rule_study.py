#!/usr/bin/env python3
"""What each part and each number of the rule of acceptance is worth: one left out or moved at a time.

    rule_study.py PHS OUT.csv SETS[:NAME,NAME…] [SETS[:…]…] [--seconds 40] [--jobs 2] [--only VARIANT,…]

SETS is a folder with records in SETS/NAME and the truth in SETS/truth (tests/rigdata/suite.h). Of every record the
first seconds are kept, three quarters of them for the fit. Written is a row for each set and variant: what was
accepted and the verdict, beside what is hidden. Rows that are there already are kept.
"""
import argparse
import csv
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

from blind_sets import read

NUMBERS = {"false_alarms": 0.01, "least_share": 0.33, "noise_known": 0.1}
FACTORS = {"quartered": 0.25, "halved": 0.5, "doubled": 2, "quadrupled": 4}
PARTS = ("cross_validation", "beyond_zero", "structures", "plain_first", "superfluous", "bends", "elsewhere",
         "challenge", "names", "formula", "options")
FIELDS = ("suite", "set", "kind", "hidden", "variant", "accepted", "verdict", "processor_s")


def variants():
    """{name: further arguments of phs identify}."""
    all_of = {"as it is": [], "without share": ["--rule", "least_share=0"]}
    all_of.update({f"without {part}": ["--without", part] for part in PARTS})
    for name, value in NUMBERS.items():
        for words, factor in FACTORS.items():
            if name != "least_share" or factor * value < 1:
                all_of[f"{name} {words}"] = ["--rule", f"{name}={factor * value:g}"]
    return all_of


def cut(source, folder, seconds):
    """The first `seconds` of a record, in a folder of its own."""
    with open(os.path.join(source, "run.csv")) as file:
        lines = file.readlines()
    kept = lines[:1] + [line for line in lines[1:] if float(line.split(",", 1)[0]) <= seconds]
    with open(os.path.join(folder, "run.csv"), "w") as file:
        file.writelines(kept)
    with open(os.path.join(source, "MANIFEST.yaml")) as file:
        manifest = [line for line in file if not line.startswith(("data:", "estimation:", "validation:"))]
    manifest += ["data: run.csv\n", f"estimation: [0, {0.75 * seconds:g}]\n",
                 f"validation: [{0.75 * seconds:g}, {seconds:g}]\n"]
    with open(os.path.join(folder, "MANIFEST.yaml"), "w") as file:
        file.writelines(manifest)


def try_one(phs, suite, entry, variant, words, seconds):
    truth = read(os.path.join(suite, "truth", entry["truth"]))
    with tempfile.TemporaryDirectory(prefix="rule_") as folder:
        cut(os.path.join(suite, entry["set"]), folder, seconds)
        out = os.path.join(folder, "out")
        process = subprocess.Popen([phs, "identify", os.path.join(folder, "MANIFEST.yaml"), "--out", out, "--quiet",
                                    "--threads", "1"] + words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        result = read(os.path.join(out, "result.json")) if process.returncode == 0 else None
    return {"suite": os.path.basename(os.path.normpath(suite)), "set": entry["set"], "kind": entry["kind"],
            "hidden": "+".join(sorted(e["name"] for e in truth["effects"])) or "nothing", "variant": variant,
            "accepted": "+".join(e["name"] for e in result["effects"]) or "nothing" if result else "no answer",
            "verdict": result["verdict"] if result else "", "processor_s": f"{used.ru_utime + used.ru_stime:.1f}"}


def tasks(args):
    for suite in args.sets:
        folder, _, names = suite.partition(":")
        for entry in read(os.path.join(folder, "truth", "index.json")):
            if not names or entry["set"] in names.split(","):
                yield folder, entry


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("phs")
    parser.add_argument("out")
    parser.add_argument("sets", nargs="+")
    parser.add_argument("--seconds", type=float, default=40)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="")
    args = parser.parse_args()
    made = set()
    if os.path.exists(args.out):
        with open(args.out, newline="") as file:
            made = {(row["suite"], row["set"], row["variant"]) for row in csv.DictReader(file)}
    else:
        with open(args.out, "w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerow(FIELDS)
    asked = [(folder, entry, variant, words) for variant, words in variants().items()
             if not args.only or variant in args.only.split(",")
             for folder, entry in tasks(args)
             if (os.path.basename(os.path.normpath(folder)), entry["set"], variant) not in made]
    with ThreadPoolExecutor(args.jobs) as pool:
        for row in pool.map(lambda task: try_one(args.phs, *task, args.seconds), asked):
            with open(args.out, "a", newline="") as file:
                csv.DictWriter(file, FIELDS, lineterminator="\n").writerow(row)
    return 0


if __name__ == "__main__":
    sys.exit(main())

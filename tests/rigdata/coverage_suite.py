#!/usr/bin/env python3
"""Rig records on which the intervals of the declared numbers are counted: nothing listed in them, and a little that is on no list.

    coverage_suite.py GENERATOR PHS FOLDER [--records 200] [--seed 1] [--over-noise 0.3] [--seconds 60] [--jobs 2]

Record k hides the k-th effect on no list, so weak that the best declared model leaves X times its floor
(`generate_rig_data --over-noise`); noise has a colour, the actuator's reading is noisy too. Of each record the first
seconds are kept, three quarters of them for the fit. FOLDER then is a suite that interval_coverage.py counts:
the little is no hidden effect there, and a record where something was accepted is left out. Sets that are there are kept.
"""
import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

from blind_sets import read
from rule_study import cut


def off_list(generator):
    out = subprocess.run([generator, "--list"], check=True, capture_output=True, text=True).stdout
    return [line.split()[0] for line in out.splitlines() if line.endswith("(off list)")]


def write(path, value):
    with open(path + ".part", "w") as file:
        json.dump(value, file, indent=1)
    os.replace(path + ".part", path)


def make(args, name, effect, seed):
    """The record and its truth, in which the little stands apart."""
    truth_path = os.path.join(args.folder, "truth", name + ".json")
    if os.path.exists(truth_path):
        return
    with tempfile.TemporaryDirectory(prefix="coverage_") as whole:
        hidden = ["--effect", effect, "--over-noise", str(args.over_noise)] if args.over_noise > 0 else ["--effect", "none"]
        subprocess.run([args.generator, *hidden, "--seed", str(seed), "--out", whole], check=True,
                       stdout=subprocess.DEVNULL)
        folder = os.path.join(args.folder, name)
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        cut(whole, folder, args.seconds)
        truth = read(os.path.join(whole, "truth.json"))
    truth["discrepancy"], truth["effects"] = truth["effects"], []
    write(truth_path, truth)


def identify(args, name):
    out = os.path.join(args.folder, "results", name)
    if os.path.exists(out + ".run.json"):
        return
    shutil.rmtree(out, ignore_errors=True)
    done = subprocess.run([args.phs, "identify", os.path.join(args.folder, name, "MANIFEST.yaml"), "--out", out,
                           "--quiet", "--threads", "1"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    write(out + ".run.json", {"exit": done.returncode, "said": done.stderr.strip()})


def main():
    words = argparse.ArgumentParser()
    words.add_argument("generator")
    words.add_argument("phs")
    words.add_argument("folder")
    words.add_argument("--records", type=int, default=200)
    words.add_argument("--seed", type=int, default=1)
    words.add_argument("--over-noise", type=float, default=0.3)
    words.add_argument("--seconds", type=float, default=60)
    words.add_argument("--jobs", type=int, default=2)
    args = words.parse_args()
    for part in ("truth", "results"):
        os.makedirs(os.path.join(args.folder, part), exist_ok=True)
    effects = off_list(args.generator)
    names = [f"set_{k + 1:03d}" for k in range(args.records)]

    def one(k):
        make(args, names[k], effects[k % len(effects)], args.seed + k)
        identify(args, names[k])

    write(os.path.join(args.folder, "truth", "index.json"),
          [{"set": name, "kind": "clean", "truth": name + ".json"} for name in names])
    with ThreadPoolExecutor(args.jobs) as pool:
        list(pool.map(one, range(args.records)))
    results = [read(os.path.join(args.folder, "results", n, "result.json")) for n in names
               if os.path.exists(os.path.join(args.folder, "results", n, "result.json"))]
    kinds = {}
    for result in results:
        word = result["verdict"] + (" with " + "+".join(e["name"] for e in result["effects"]) if result["effects"] else "")
        kinds[word] = kinds.get(word, 0) + 1
    print(f"{len(results)} of {len(names)} records answered")
    for word, count in sorted(kinds.items(), key=lambda item: -item[1]):
        print(f"  {count} {word}")
    return 0


if __name__ == "__main__":
    sys.exit(main())

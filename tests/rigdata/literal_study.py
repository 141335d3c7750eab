#!/usr/bin/env python3
"""Which literals of the search decide: each doubled and halved in turn, the records identified anew.

    literal_study.py FOLDER OUT.csv [SETS[:NAME,NAME…] …] [--draw N] [--seed 1] [--seconds 40] [--jobs 2]
    literal_study.py --list

FOLDER is made: the last commit as `source`, its own `build`. SETS as for rule_study.py, which cuts and runs the
records. Taken is every number but 0 and 1 in the code of src/identify and src/measurement and in the effects' rows
(src/effects, src/vehicle/running_effects.cc), or N of them drawn at random: all of them times forty records are days.
Written is a row for each literal, factor and record; what is there already is kept. In the end the literals are printed
that change the accepted effects or the verdict of more than a twentieth of the records, 2 of 40: such a number
belongs to the rule of acceptance (docs/identify_rule.md).
"""
import argparse
import csv
import glob
import os
import random
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

from rule_study import tasks, try_one

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
FIELDS = ("literal", "factor", "suite", "set", "accepted", "verdict")
FOLDERS = ("src/identify/*/*", "src/measurement/*", "src/effects/*", "src/vehicle/running_effects.cc")
NUMBER = re.compile(r"(?<![\w.])(\d+\.?\d*(?:[eE][+-]?\d+)?)(?![\w.])")
SHARE = 0.05  # of the records
BASE = ("as it is", "1")


def code_only(line):
    """The line with what is no code blanked, so that columns stay."""
    blank = lambda m: " " * len(m[0])  # noqa: E731
    line = re.sub(r'"(\\.|[^"\\])*"', blank, line)
    line = re.sub(r"'(\\.|[^'\\])'", blank, line)
    line = re.sub(r"//.*", blank, line)
    return "" if line.lstrip().startswith("#") else line


def rows_of(lines):
    """(number, line) of the code that counts: of a file of effects the static tables of its rows alone."""
    inside = False
    for k, line in enumerate(lines):
        inside = inside or bool(re.search(r"EffectInfo(\{| info =)", line))
        if inside:
            yield k, line
        if line.startswith("  };") or line.endswith("});"):
            inside = False


def literals(root):
    """(file, line, column, text) of every literal."""
    for pattern in FOLDERS:
        for path in sorted(glob.glob(os.path.join(root, pattern))):
            if not path.endswith((".cc", ".h")):
                continue
            with open(path) as file:
                lines = file.read().split("\n")
            of_effects = "/effects/" in path or path.endswith("running_effects.cc")
            for k, line in rows_of(lines) if of_effects else enumerate(lines):
                for m in NUMBER.finditer(code_only(line)):
                    if float(m[1]) not in (0, 1):
                        yield os.path.relpath(path, root), k, m.start(1), m[1]


def name_of(literal):
    file, line, column, text = literal
    return f"{file}:{line + 1}:{column + 1} {text}"


def moved(text, factor):
    value = float(text) * factor
    return repr(value) if re.search(r"[.eE]", text) else str(max(1, round(value)))


class Tree:
    """A copy of the last commit that can be changed and built."""

    def __init__(self, folder):
        self.source, self.build_folder = os.path.join(folder, "source"), os.path.join(folder, "build")
        if not os.path.exists(self.source):
            os.makedirs(self.source)
            archive = subprocess.run(["git", "-C", ROOT, "archive", "HEAD"], check=True, stdout=subprocess.PIPE)
            subprocess.run(["tar", "-x", "-C", self.source], input=archive.stdout, check=True)
        subprocess.run(["cmake", "-S", self.source, "-B", self.build_folder, "-G", "Ninja",
                        "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=OFF"], check=True, stdout=subprocess.DEVNULL)

    def build(self):
        """The program, or None: it does not compile."""
        done = subprocess.run(["cmake", "--build", self.build_folder, "--target", "phs"], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL)
        return os.path.join(self.build_folder, "src/cli/phs") if done.returncode == 0 else None

    def with_literal(self, literal, factor, work):
        """`work(program)` with one literal moved; the file is as before in the end."""
        file, line, column, text = literal
        path = os.path.join(self.source, file)
        with open(path) as read_from:
            whole = read_from.read()
        lines = whole.split("\n")
        lines[line] = lines[line][:column] + moved(text, factor) + lines[line][column + len(text):]
        try:
            with open(path, "w") as out:
                out.write("\n".join(lines))
            return work(self.build())
        finally:
            with open(path, "w") as out:
                out.write(whole)


def try_all(program, args, key, made):
    records = [task for task in tasks(args) if (*key, os.path.basename(os.path.normpath(task[0])), task[1]["set"]) not in made]

    def one(task):
        folder, entry = task
        row = try_one(program, folder, entry, "", [], args.seconds) if program else {
            "suite": os.path.basename(os.path.normpath(folder)), "set": entry["set"], "accepted": "does not compile",
            "verdict": ""}
        return {"literal": key[0], "factor": key[1], **{k: row[k] for k in FIELDS[2:]}}

    with ThreadPoolExecutor(args.jobs) as pool:
        for row in pool.map(one, records):
            with open(args.out, "a", newline="") as file:
                csv.DictWriter(file, FIELDS, lineterminator="\n").writerow(row)


def deciding(rows):
    """[(literal, factor, records that end otherwise, records)], those that decide."""
    base = {(r["suite"], r["set"]): r for r in rows if (r["literal"], r["factor"]) == BASE}
    counts = {}
    for row in rows:
        key = (row["literal"], row["factor"])
        whole = base.get((row["suite"], row["set"]))
        if key == BASE or whole is None or row["accepted"] == "does not compile":
            continue
        other, of = counts.get(key, (0, 0))
        differs = (row["accepted"], row["verdict"]) != (whole["accepted"], whole["verdict"])
        counts[key] = (other + differs, of + 1)
    return [(*key, other, of) for key, (other, of) in counts.items() if other > SHARE * of]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", nargs="?")
    parser.add_argument("out", nargs="?")
    parser.add_argument("sets", nargs="*")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--draw", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=40)
    parser.add_argument("--jobs", type=int, default=2)
    args = parser.parse_args()
    if args.list:
        print("\n".join(map(name_of, literals(ROOT))))
        return 0
    if not args.folder or not args.out or not args.sets:
        print(__doc__.split("\n\n")[1], file=sys.stderr)
        return 2
    tree = Tree(args.folder)
    rows = []
    if os.path.exists(args.out):
        with open(args.out, newline="") as file:
            rows = list(csv.DictReader(file))
    else:
        with open(args.out, "w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerow(FIELDS)
    made = {tuple(row[k] for k in FIELDS[:4]) for row in rows}
    chosen = list(literals(tree.source))
    if args.draw:
        chosen = random.Random(args.seed).sample(chosen, args.draw)
    try_all(tree.build(), args, BASE, made)
    for literal in chosen:
        for factor in (2, 0.5):
            key = (name_of(literal), f"{factor:g}")
            tree.with_literal(literal, factor, lambda program, key=key: try_all(program, args, key, made))
    with open(args.out, newline="") as file:
        for literal, factor, other, of in deciding(list(csv.DictReader(file))):
            print(f"{literal} times {factor}: {other} of {of} records end otherwise")
    return 0


if __name__ == "__main__":
    sys.exit(main())

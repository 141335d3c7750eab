#!/usr/bin/env python3
"""Mutation test: breaks single statements of a folder and looks whether a test fails.

scripts/mutation/mutate.py [--folders hydraulics,rail] [--count 30] [--seed 1] [--jobs 2] [--out FILE]

For each folder COUNT statements are drawn by the seed among those that compute with numbers (sums, products,
quotients, comparisons, functions); each is changed in one way. A copy of the tree in build/mutation is built
once for each folder with all its mutants in it: `PHS_MUTANT=7` picks one. Only the folder's own tests and
tests/laws run. A mutant is killed by the first test that fails, crashes or takes five times as long as
without it. Survivors are printed with place and change; docs/testing.md says of each why it is harmless.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
PLACES = {"hydraulics": "src/hydraulics", "effects": "src/effects", "rail": "src/rail",
          "plugin": "plugin", "vehicle": "src/vehicle"}
PRELUDE = """#pragma once
#include <cstdlib>
/// The mutant that runs; none without PHS_MUTANT.
inline bool PhsMutant(int number) {
  static const int chosen = std::getenv("PHS_MUTANT") ? std::atoi(std::getenv("PHS_MUTANT")) : 0;
  return chosen == number;
}
"""
# What does not compute a force, flow, pressure, position or rate.
OTHER = re.compile(r'"|fmt::|Error|Json|json|std::string|static_assert|constexpr|template|size\(\)|'
                   r'push_back|reserve|resize|#|\bfor\b|\bwhile\b|lambda|\[&|\[=|\[this|using |'
                   r'unique_ptr|shared_ptr|vector<|auto&|int |size_t|bool |index|count|\?')
ASSIGNED = re.compile(r'^(\s*)((?:const )?double (\w+)|[\w.\->\[\]*()]+?)\s*(=|\+=|-=|\*=)\s+(.+);$',
                      re.S)
RETURNED = re.compile(r'^(\s*)return (.+);$', re.S)


def changes(expression):
    """Every single change of `expression`: (text, what was done)."""
    found = []

    def swap(pattern, new, words):
        for m in re.finditer(pattern, expression):
            found.append((expression[:m.start()] + new + expression[m.end():], words))

    swap(r' \+ ', ' - ', '+ to -')
    swap(r' - ', ' + ', '- to +')
    swap(r' \* ', ' / ', '* to /')
    swap(r' / ', ' * ', '/ to *')
    swap(r'\bstd::max\b', 'std::min', 'max to min')
    swap(r'\bstd::min\b', 'std::max', 'min to max')
    swap(r'\bstd::sin\b', 'std::cos', 'sin to cos')
    swap(r'\bstd::cos\b', 'std::sin', 'cos to sin')
    swap(r'\b0\.5\b', '0.6', '0.5 to 0.6')
    swap(r'\b2 \*', '3 *', '2 to 3')
    if re.match(r'^-\w', expression):
        found.append((expression[1:], 'sign turned'))
    return found


def statements(text):
    """(begin, end) of statements that stand on lines of their own, up to four lines long."""
    lines = text.split("\n")
    at = 0
    i = 0
    while i < len(lines):
        begin, joined, n = at, lines[i], 1
        if re.match(r'^\s{2,}[\w*(]', joined) and not OTHER.search(joined):
            while not joined.rstrip().endswith((";", "{", "}", ":", ",")) and n < 4 and i + n < len(lines):
                joined += "\n" + lines[i + n]
                n += 1
            if joined.endswith(";") and joined.count("(") == joined.count(")") and \
                    joined.count(";") == 1 and not OTHER.search(joined):
                yield begin, begin + len(joined)
        at += len(lines[i]) + 1
        i += 1


def has_own_comma(expression):
    """True for `a, b = c`: more than one expression outside brackets."""
    depth = 0
    for letter in expression:
        depth += (letter in "([{") - (letter in ")]}")
        if letter == "," and depth == 0:
            return True
    return False


def mutable_places(text):
    """(begin, end, function number -> new statement, words, line) for everything that can be changed."""
    places = []
    for begin, end in statements(text):
        statement = text[begin:end]
        if has_own_comma(statement):
            continue
        m = ASSIGNED.match(statement)
        r = RETURNED.match(statement)
        if m and re.match(r'^\s*(else|if|case|default|break)', statement) is None:
            indent, target, declared, operator, value = m.groups()
            for new, words in changes(value):
                def make(k, i=indent, t=target, o=operator, v=value, w=new):
                    return f"{i}{t} {o} PhsMutant({k}) ? ({w}) : ({v});"
                places.append((begin, end, make, words))
            if declared is None and operator in ("+=", "-="):
                other = "-=" if operator == "+=" else "+="
                def make(k, i=indent, t=target, o=operator, v=value, w=other):
                    return f"{i}if (PhsMutant({k})) {{ {t} {w} {v}; }} else {{ {t} {o} {v}; }}"
                places.append((begin, end, make, f"{operator} to {other}"))
        elif r and not r.group(2).startswith("{"):
            indent, value = r.groups()
            for new, words in changes(value):
                def make(k, i=indent, v=value, w=new):
                    return f"{i}return PhsMutant({k}) ? ({w}) : ({v});"
                places.append((begin, end, make, words))
    return places


def draw(folder, count, seed):
    """file -> [(begin, end, make, words, line)], one change per statement, `count` in all."""
    chosen = []
    for file in sorted((ROOT / PLACES[folder]).glob("*.cc")):
        text = file.read_text()
        by_statement = {}
        for begin, end, make, words in mutable_places(text):
            by_statement.setdefault((begin, end), []).append((make, words))
        for (begin, end), options in by_statement.items():
            chosen.append((file.relative_to(ROOT), begin, end, options, text[:begin].count("\n") + 1))
    rng = random.Random(f"{seed} {folder}")
    rng.shuffle(chosen)
    drawn = []
    for file, begin, end, options, line in chosen[:count]:
        make, words = rng.choice(options)
        drawn.append({"file": str(file), "begin": begin, "end": end, "make": make, "words": words,
                      "line": line})
    return drawn


def write_tree(tree, mutants):
    """A copy of the sources with all mutants in it; unchanged files keep their times."""
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT, check=True,
                            capture_output=True, text=True).stdout
    names = [name for name in listed.split("\0") if name]
    for name in [n for n in names if (ROOT / n).is_symlink() and not (tree / n).is_symlink()]:
        (tree / name).parent.mkdir(parents=True, exist_ok=True)
        (tree / name).symlink_to(os.readlink(ROOT / name))
    wanted = {n: (ROOT / n).read_bytes() for n in names if not (ROOT / n).is_symlink()}
    wanted["src/mutants.h"] = PRELUDE.encode()
    by_file = {}
    for number, mutant in enumerate(mutants, 1):
        mutant["number"] = number
        by_file.setdefault(mutant["file"], []).append(mutant)
    for file, of_file in by_file.items():
        text = (ROOT / file).read_text()
        for mutant in sorted(of_file, key=lambda m: -m["begin"]):
            mutant["before"] = " ".join(text[mutant["begin"]:mutant["end"]].split())
            new = mutant["make"](mutant["number"])
            text = text[:mutant["begin"]] + new + text[mutant["end"]:]
        wanted[file] = ('#include "mutants.h"\n' + text).encode()
    for name, content in wanted.items():
        path = tree / name
        if path.is_file() and path.read_bytes() == content:
            continue
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
        shutil.copymode(ROOT / name, path) if (ROOT / name).exists() else None


def build(tree, folder):
    """Builds the tests of the folder; statements that do not compile are given back by number."""
    binary = tree / "build/release"
    if not (binary / "build.ninja").exists():
        subprocess.run(["cmake", "-S", str(tree), "-B", str(binary), "-G", "Ninja",
                        "-DCMAKE_BUILD_TYPE=Release", "-DPHS_BENCHMARKS=OFF",
                        "-DCMAKE_CXX_COMPILER_LAUNCHER=ccache", "-DCMAKE_C_COMPILER_LAUNCHER=ccache"],
                       check=True, stdout=subprocess.DEVNULL)
    run = subprocess.run(["cmake", "--build", str(binary), "--target", f"test_{folder}", "test_laws",
                          "--",
                          "-k", "0"], capture_output=True, text=True)
    broken = set()
    if run.returncode != 0:
        for m in re.finditer(r"([\w/.\-]+\.cc):(\d+):\d+: error", run.stdout):
            name = pathlib.Path(m.group(1)).name
            files = [f for f in tree.rglob(name) if "build" not in f.relative_to(tree).parts]
            for file in files:
                lines = file.read_text().split("\n")
                near = "\n".join(lines[max(0, int(m.group(2)) - 4):int(m.group(2)) + 3])
                broken |= {int(n) for n in re.findall(r"PhsMutant\((\d+)\)", near)}
        if not broken:
            sys.exit(run.stdout[-4000:])
    return broken


def run_tests(tree, folder, number, limit):
    """True if a test notices the mutant; `limit`: seconds per program without it, or None to measure."""
    times = {}
    for program in dict.fromkeys([f"test_{folder}", "test_laws"]):
        environment = dict(os.environ, PHS_MUTANT=str(number), RC_PARAMS="seed=20260",
                           GTEST_FAIL_FAST="1")
        begin = time.monotonic()
        try:
            run = subprocess.run([str(tree / "build/release/tests" / program)], cwd=tree, env=environment,
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                 timeout=None if limit is None else 5 * limit[program] + 5)
        except subprocess.TimeoutExpired:
            return True, times
        times[program] = time.monotonic() - begin
        if run.returncode != 0:
            return True, times
    return False, times


def test_folder(folder, arguments):
    mutants = draw(folder, arguments.count, arguments.seed)
    tree = ROOT / "build/mutation"
    while True:
        write_tree(tree, mutants)
        broken = build(tree, folder)
        if not broken:
            break
        mutants = [m for m in mutants if m["number"] not in broken]
    noticed, limit = run_tests(tree, folder, 0, None)
    if noticed:
        sys.exit(f"{folder}: its tests fail without a mutant")
    survivors = []
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        results = pool.map(lambda m: run_tests(tree, folder, m["number"], limit)[0], mutants)
        for mutant, killed in zip(mutants, results):
            place = f'{mutant["file"]}:{mutant["line"]}: {mutant["words"]}: {mutant["before"]}'
            print(("killed   " if killed else "SURVIVED ") + place, flush=True)
            if not killed:
                survivors.append(place)
    return {"mutants": len(mutants), "killed": len(mutants) - len(survivors), "survivors": survivors}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--folders", default=",".join(PLACES))
    parser.add_argument("--count", type=int, default=30)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="mutants at a time")
    parser.add_argument("--list", action="store_true", help="print the mutants, build nothing")
    parser.add_argument("--out", help="JSON with score and survivors of each folder")
    arguments = parser.parse_args()
    results = {}
    for folder in arguments.folders.split(","):
        if folder not in PLACES:
            sys.exit(f"mutate.py: no folder {folder}; allowed: {', '.join(PLACES)}")
        if arguments.list:
            for m in draw(folder, arguments.count, arguments.seed):
                print(f'{m["file"]}:{m["line"]}: {m["words"]}')
            continue
        results[folder] = test_folder(folder, arguments)
        r = results[folder]
        print(f'{folder}: {r["killed"]} of {r["mutants"]} killed', flush=True)
        if arguments.out:
            pathlib.Path(arguments.out).write_text(json.dumps(results, indent=1) + "\n")


if __name__ == "__main__":
    main()

"""scripts/figures: fills or checks the places of documents."""
import argparse
import datetime
import importlib
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from docfigures import places
from docfigures.runs import Phs, RunFailed, Skipped

WRITING = threading.Lock()
HERE = Path(__file__).resolve().parent
SOURCE = HERE.parent.parent


def all_lists():
    return [importlib.import_module("docfigures." + path.stem)
            for path in sorted(HERE.glob("list_*.py"))]


def is_slow(a_list):
    return a_list.__name__.endswith("_nightly") or is_of_machine(a_list)


def is_of_machine(a_list):
    return a_list.__name__.endswith("_machine")


def prefix(a_list):
    """Of the names of its places; PART tells two slow lists of one document apart."""
    kind = places.MACHINE if is_of_machine(a_list) else places.NIGHTLY if is_slow(a_list) else ""
    return kind + getattr(a_list, "PART", "")


def made():
    """Date and commit, as they stand beside nightly figures."""
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=SOURCE, text=True,
                            capture_output=True, check=False).stdout.strip() or "unknown"
    return f"{datetime.date.today()}, commit {commit}"


def computed(a_list, phs):
    figures = a_list.figures(phs)
    if is_slow(a_list):
        figures["made"] = made()
    return {prefix(a_list) + name: text for name, text in figures.items()}


def work(a_list, phs, check):
    """Fills or checks one document; lines that say what is wrong. Raises Skipped."""
    path = SOURCE / a_list.DOCUMENT
    try:
        figures = computed(a_list, phs)
    except RunFailed as failed:
        return [str(failed)]
    with WRITING:
        text = path.read_text()
        wrong = places.differences(text, figures, prefix(a_list))
        if check:
            return wrong
        path.write_text(places.filled(text, figures))
    return [line for line in wrong if "no such place" in line or "no list fills" in line]


def options(arguments):
    parser = argparse.ArgumentParser(prog="scripts/figures", description=__doc__)
    parser.add_argument("documents", nargs="*", help="README.md, docs/curving.md …; all without")
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    parser.add_argument("--nightly", action="store_true", help="the slow lists")
    parser.add_argument("--machine", action="store_true", help="times of this machine")
    parser.add_argument("--all", action="store_true", help="fast and nightly lists")
    parser.add_argument("--phs", default=str(SOURCE / "build/release/src/cli/phs"))
    parser.add_argument("--keep", default=str(SOURCE / "build/figures"),
                        help="where answers of phs are kept")
    parser.add_argument("--jobs", type=int, default=1, help="documents at a time")
    return parser.parse_args(arguments)


def wanted(a_list, asked):
    if is_of_machine(a_list):
        return asked.machine and not asked.check
    return asked.all or asked.nightly == is_slow(a_list) and not asked.machine


def chosen(asked):
    known = {one.DOCUMENT for one in all_lists()}
    for document in asked.documents:
        if document not in known:
            raise SystemExit(f"scripts/figures: {document}: no list fills it; "
                             f"known: {', '.join(sorted(known))}")
    return [one for one in all_lists()
            if wanted(one, asked) and (not asked.documents or one.DOCUMENT in asked.documents)]


def main(arguments):
    asked = options(arguments)
    if not Path(asked.phs).exists():
        print(f"scripts/figures: {asked.phs} is not built: scripts/build release phs",
              file=sys.stderr)
        return 3
    phs = Phs(asked.phs, SOURCE, asked.keep)
    lists = chosen(asked)
    failed = False
    with ThreadPoolExecutor(max_workers=max(1, asked.jobs)) as pool:
        # Two lists of one document take turns: each reads and writes the file at its end.
        waiting = [(one, pool.submit(work, one, phs, asked.check)) for one in lists]
        for one, done in waiting:
            name = one.__name__.rpartition("list_")[2]
            try:
                wrong = done.result()
            except Skipped as why:
                print(f"{one.DOCUMENT} ({name}): skipped: {why}")
                continue
            print(f"{one.DOCUMENT} ({name}): {'as printed' if asked.check else 'filled'}"
                  if not wrong else f"{one.DOCUMENT} ({name}):")
            for line in wrong:
                print("  " + line)
                failed = True
    return 1 if failed else 0

"""scripts/figures: fills or checks the places of documents."""
import argparse
import datetime
import importlib
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from docfigures import places
from docfigures.runs import Phs, RunFailed

HERE = Path(__file__).resolve().parent
SOURCE = HERE.parent.parent


def all_lists():
    return [importlib.import_module("docfigures." + path.stem)
            for path in sorted(HERE.glob("list_*.py"))]


def is_nightly(a_list):
    return getattr(a_list, "NIGHTLY", False)


def is_checked(a_list):
    return getattr(a_list, "CHECKED", True)


def made():
    """Date and commit, as they stand beside nightly figures."""
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=SOURCE, text=True,
                            capture_output=True, check=False).stdout.strip() or "unknown"
    return f"{datetime.date.today()}, commit {commit}"


def computed(a_list, phs):
    figures = a_list.figures(phs)
    if is_nightly(a_list):
        figures = {places.NIGHTLY + name: text for name, text in figures.items()}
        figures[places.NIGHTLY + "made"] = made()
    return figures


def work(a_list, phs, check):
    """Fills or checks one document; lines that say what is wrong."""
    path = SOURCE / a_list.DOCUMENT
    try:
        figures = computed(a_list, phs)
    except RunFailed as failed:
        return [str(failed)]
    text = path.read_text()
    if check:
        return places.differences(text, figures, is_nightly(a_list))
    lost = [line for line in places.differences(text, figures, is_nightly(a_list))
            if "no such place" in line or "no list fills" in line]
    path.write_text(places.filled(text, figures))
    return lost


def options(arguments):
    parser = argparse.ArgumentParser(prog="scripts/figures", description=__doc__)
    parser.add_argument("documents", nargs="*", help="README.md, docs/curving.md …; all without")
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    parser.add_argument("--nightly", action="store_true", help="the slow lists")
    parser.add_argument("--all", action="store_true", help="fast and slow lists")
    parser.add_argument("--phs", default=str(SOURCE / "build/release/src/cli/phs"))
    parser.add_argument("--keep", default=str(SOURCE / "build/figures"),
                        help="where answers of phs are kept")
    parser.add_argument("--jobs", type=int, default=1, help="documents at a time")
    return parser.parse_args(arguments)


def chosen(asked):
    lists = [one for one in all_lists() if asked.all or is_nightly(one) == asked.nightly]
    if asked.check:
        lists = [one for one in lists if is_checked(one)]
    if asked.documents:
        known = {one.DOCUMENT for one in all_lists()}
        for document in asked.documents:
            if document not in known:
                raise SystemExit(f"scripts/figures: {document}: no list fills it; "
                                 f"known: {', '.join(sorted(known))}")
        lists = [one for one in lists if one.DOCUMENT in asked.documents]
    return lists


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
            wrong = done.result()
            name = one.__name__.rpartition("list_")[2]
            print(f"{one.DOCUMENT} ({name}): {'as printed' if asked.check else 'filled'}"
                  if not wrong else f"{one.DOCUMENT} ({name}):")
            for line in wrong:
                print("  " + line)
                failed = True
    return 1 if failed else 0

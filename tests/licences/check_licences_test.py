#!/usr/bin/env python3
"""The check of licences finds what it must: one fault of each kind in a copy of the tree.

check_licences_test.py ROOT PROGRAM"""
import pathlib
import shutil
import sys
import tempfile

import check_licences


def faults(root, program):
    check = check_licences.Check(root)
    check.licences()
    check.headers()
    check.imports()
    check.packages()
    check.data()
    check.libraries(program)
    return check.faults


def changed(file, old, new):
    text = file.read_text()
    assert old in text, f"{file.name} does not hold '{old}'"
    file.write_text(text.replace(old, new, 1))


def turned_to_gpl(lock, package):
    head, own = lock.read_text().split(f'"node_modules/{package}"')
    assert '"license": "MIT"' in own
    lock.write_text(f'{head}"node_modules/{package}"' + own.replace('"MIT"', '"GPL-3.0"', 1))


def drop_row(notice, start):
    lines = notice.read_text().splitlines(keepends=True)
    kept = [line for line in lines if not line.startswith(start)]
    assert len(kept) == len(lines) - 1, start
    notice.write_text("".join(kept))


CASES = [
    ("links libfmt.so", lambda t: drop_row(t / "NOTICE", "| fmt |")),
    ("includes <boost/", lambda t: drop_row(t / "NOTICE", "| Boost |")),
    ("includes <csv.h>", lambda t: drop_row(t / "NOTICE", "| libcsv |")),
    ("uplot is part of the reports", lambda t: drop_row(t / "NOTICE", "| uplot |")),
    ("NOTICE says MIT", lambda t: turned_to_gpl(t / "src/report/package-lock.json", "uplot")),
    ("without a reason", lambda t: changed(
        t / "NOTICE", "LGPL-2.1-or-later | a shared library that the user can exchange |",
        "LGPL-2.1-or-later | |")),
    ("fmt has no licence", lambda t: changed(t / "NOTICE", "| phs, plugin | MIT |",
                                             "| phs, plugin | |")),
    ("new.csv is named in no README", lambda t: (t / "models/reference/new.csv").write_text("a")),
    ("includes <pybind11/", lambda t: drop_row(t / "NOTICE", "| pybind11 |")),
    ("imports h5py", lambda t: drop_row(t / "NOTICE", "| h5py |")),
    ("includes <gsl/", lambda t: (t / "src/base/new.cc").write_text("#include <gsl/gsl_rng.h>\n")),
]


def main(arguments):
    root, program = pathlib.Path(arguments[0]), arguments[1]
    failed = 0
    for expected, change in CASES:
        with tempfile.TemporaryDirectory() as scratch:
            tree = pathlib.Path(scratch)
            shutil.copy(root / "NOTICE", tree)
            for folder in ("src", "plugin", "python", "models"):
                shutil.copytree(root / folder, tree / folder)
            assert not faults(tree, program), faults(tree, program)
            change(tree)
            found = faults(tree, program)
            if not any(expected in fault for fault in found):
                print(f"not found: {expected}; found: {found}")
                failed = 1
    return failed


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

#!/usr/bin/env python3
"""Doctests of the package phs and of docs/python.md. run_doctests.py ROOT"""
import doctest
import importlib
import pathlib
import pkgutil
import sys

import phs

names = {"phs": phs}
options = doctest.ELLIPSIS
doctest.ELLIPSIS_MARKER = r"\u2026"  # …, as doctest compares it; "..." goes on with a block
failed = tried = 0
for info in [None, *pkgutil.iter_modules(phs.__path__)]:
    module = phs if info is None else importlib.import_module(f"phs.{info.name}")
    result = doctest.testmod(module, extraglobs=names, optionflags=options)
    failed, tried = failed + result.failed, tried + result.attempted
result = doctest.testfile(str(pathlib.Path(sys.argv[1]) / "docs/python.md"), module_relative=False,
                          globs=dict(names), optionflags=options)
failed, tried = failed + result.failed, tried + result.attempted
print(f"{tried} examples, {failed} failed")
sys.exit(1 if failed or tried < 20 else 0)

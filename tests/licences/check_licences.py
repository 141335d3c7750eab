#!/usr/bin/env python3
"""Holds NOTICE against the product: every library that a program links, every header that the
sources include from outside and every npm package of the reports has a row with its licence; every
copyleft licence has a reason; data of others are named with a licence in the README of their folder.

check_licences.py ROOT COMPILER EIGEN [PROGRAM …]: EIGEN is the folder of Eigen's headers. Prints what
is missing; exit code 1 if anything is."""
import json
import pathlib
import re
import subprocess
import sys

# Of the operating system and the language: every C program on Debian has them.
SYSTEM_HEADERS = {"dlfcn.h", "errno.h", "fcntl.h", "poll.h", "pthread.h", "signal.h", "spawn.h",
                  "stddef.h", "stdint.h", "stdio.h", "stdlib.h", "string.h", "unistd.h"}
# Under the GPL without an exception: must not come in unseen through another library either.
GPL_LIBRARIES = {"libgsl", "libgslcblas", "libfftw3", "libcholmod", "libspqr", "libumfpack",
                 "libklu", "libreadline", "libglpk"}
DATA_ENDINGS = {".csv", ".prw", ".prr", ".inp", ".mat", ".h5"}


def read_rows(notice):
    """The rows of NOTICE's tables: {library name: row} with the column names of the head line."""
    rows, head = [], None
    for line in notice.splitlines():
        if not line.startswith("|"):
            head = None
            continue
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if head is None:
            head = cells
            continue
        rows.append(dict(zip(head, cells)))
    return rows


def soname_stem(soname):
    return re.sub(r"\.so.*$", "", soname)


def linked(program):
    out = subprocess.run(["readelf", "-d", program], check=True, capture_output=True, text=True)
    return re.findall(r"\(NEEDED\).*\[(.+)\]", out.stdout)


def loaded(program):
    out = subprocess.run(["ldd", program], check=True, capture_output=True, text=True)
    return re.findall(r"^\s*(lib\S+)", out.stdout, re.M)


class Check:
    def __init__(self, root):
        self.root = root
        self.rows = read_rows((root / "NOTICE").read_text())
        self.found_as = {}
        for row in self.rows:
            for mark in row.get("found as", "").split(","):
                self.found_as[mark.strip()] = row
        self.faults = []
        self.eigen = set()

    def libraries(self, program):
        name = pathlib.Path(program).name
        for soname in linked(program):
            if soname_stem(soname) + ".so" not in self.found_as:
                self.faults.append(f"{name} links {soname}, which has no row in NOTICE")
        for soname in loaded(program):
            if soname_stem(soname) in GPL_LIBRARIES and \
                    soname_stem(soname) + ".so" not in self.found_as:
                self.faults.append(f"{name} loads {soname} (GPL), which has no row in NOTICE")

    def headers(self):
        for folder in ("src", "plugin", "python"):
            for file in sorted((self.root / folder).rglob("*")):
                if file.suffix not in {".h", ".cc", ".c"}:
                    continue
                for header in re.findall(r"^#include <(.+)>", file.read_text(), re.M):
                    of_the_language = "/" not in header and "." not in header
                    if of_the_language or header in SYSTEM_HEADERS or header.startswith("sys/"):
                        continue
                    self.eigen.update([header] if "Eigen/" in header else [])
                    mark = f"<{header.rsplit('/', 1)[0]}/" if "/" in header else f"<{header}>"
                    if not any(mark == known or (known.endswith("/") and mark.startswith(known))
                               for known in self.found_as):
                        self.faults.append(f"{file.relative_to(self.root)} includes <{header}>, "
                                           "which has no row in NOTICE")

    def imports(self):
        """What the Python package imports beside the language's own library."""
        for file in sorted((self.root / "python").rglob("*.py")):
            for module in re.findall(r"^\s*(?:import|from) (\w+)", file.read_text(), re.M):
                if module in sys.stdlib_module_names or module == "phs":
                    continue
                if f"import {module}" not in self.found_as:
                    self.faults.append(f"{file.relative_to(self.root)} imports {module}, which has "
                                       "no row in NOTICE")

    def eigen_is_mpl2(self, compiler, include):
        """Some of Eigen's modules have other licences; with EIGEN_MPL2_ONLY they do not compile."""
        source = "".join(f"#include <{header}>\n" for header in sorted(self.eigen))
        run = subprocess.run([compiler, "-std=c++20", "-fsyntax-only", "-DEIGEN_MPL2_ONLY",
                              "-isystem", include, "-x", "c++", "-"], input=source, text=True,
                             capture_output=True)
        if run.returncode != 0:
            self.faults.append("Eigen: a header is not under MPL-2.0: " + run.stderr)

    def packages(self):
        lock = json.loads((self.root / "src/report/package-lock.json").read_text())
        for place, package in lock["packages"].items():
            name = place.removeprefix("node_modules/")
            if not place or package.get("dev"):
                continue
            row = next((row for row in self.rows if row.get("name") == name), None)
            if row is None:
                self.faults.append(f"npm package {name} is part of the reports and has no row")
            elif row["licence"] != package.get("license"):
                self.faults.append(f"npm package {name} has the licence {package.get('license')}, "
                                   f"NOTICE says {row['licence']}")

    def data(self):
        """Tables in models/ stand with their source in the README of their folder."""
        for file in sorted((self.root / "models").rglob("*")):
            if file.suffix not in DATA_ENDINGS:
                continue
            readme = file.parent / "README.md"
            text = readme.read_text() if readme.is_file() else ""
            text += (file.parent.parent / "README.md").read_text() \
                if (file.parent.parent / "README.md").is_file() else ""
            if file.name not in text and file.parent.name + "/" not in text:
                self.faults.append(f"{file.relative_to(self.root)} is named in no README beside it")

    def licences(self):
        for row in self.rows:
            name = row.get("library") or row.get("name") or row.get("place")
            if not row.get("licence"):
                self.faults.append(f"NOTICE: {name} has no licence")
            if re.search(r"GPL", row.get("licence", "")) and not row.get("why it may be"):
                self.faults.append(f"NOTICE: {name} is under the GPL or LGPL without a reason")


def main(arguments):
    check = Check(pathlib.Path(arguments[0]))
    check.licences()
    check.headers()
    check.imports()
    check.packages()
    check.data()
    check.eigen_is_mpl2(*arguments[1:3])
    for program in arguments[3:]:
        check.libraries(program)
    print("\n".join(check.faults) or "every library, package and table has its licence")
    return 1 if check.faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

#!/usr/bin/env python3
"""Functions of one folder that a call could confuse when its files are compiled together.

The release preset compiles several files of a folder as one (scripts/cmake/PhsTargets.cmake). A call then sees the
anonymous namespaces of its neighbours: a function there of the same name that takes as many arguments might be
taken for its own. So a folder has one such name once, in its files and headers.
"""
import collections
import os
import re
import sys
import tempfile

DEFINITION = re.compile(r"^(?:inline |constexpr |static |template<.*> )*[\w:<>,&*\[\] ]+?[ &*](\w+)\((.*)$")
WORDS = {"if", "for", "while", "switch", "return", "static_assert"}
FOUND_BY_TYPE = {"PrintTo"}  # GoogleTest calls it with its own type


def parameters(text):
    """Least and most arguments of a parameter list that begins `text` (after its open bracket), or None."""
    depth, angle, count, defaults, some = 0, 0, 1, 0, False
    for k, c in enumerate(text):
        if c == "<":
            angle += 1
        elif c == ">" and text[k - 1] != "-":
            angle -= 1
        elif c in "([{":
            depth += 1
        elif c in ")]}":
            if depth == 0:
                return (count - defaults, count) if some else (0, 0)
            depth -= 1
        elif depth == 0 and angle == 0:
            count += c == ","
            defaults += c == "="
        some |= not c.isspace()
    return None


def functions(path, anonymous_only):
    """(name, least, most) of the functions at the first column."""
    lines = open(path).read().split("\n")
    inside = not anonymous_only
    for i, line in enumerate(lines):
        if anonymous_only and line.startswith("namespace {"):
            inside = True
        elif anonymous_only and line.strip() == "}  // namespace":
            inside = False
        if not inside or not line or line[0] in " }/#*":
            continue
        found = DEFINITION.match(line)
        if not found or found.group(1) in WORDS | FOUND_BY_TYPE or found.group(1).isupper() or found.group(1).startswith("TEST"):
            continue
        args = parameters("\n".join([found.group(2)] + lines[i + 1:i + 8]))
        if args:
            yield found.group(1), *args


def alone(folder):
    """The names of the files that are compiled by themselves; True: all of them."""
    path = os.path.join(folder, "CMakeLists.txt")
    words = open(path).read() if os.path.exists(path) else ""
    lists = re.findall(r"\b(?:ROWS|EXCLUDE) ([a-z_0-9.\s]*)", words)
    return True if " SEPARATE " in words else {name for names in lists for name in names.split()}


def confused(folder):
    """(name, files) that a call could confuse."""
    seen = collections.defaultdict(set)
    apart = alone(folder)
    if apart is True:
        return
    for name in sorted(os.listdir(folder)):
        if name.endswith((".cc", ".h")) and name not in apart:
            for function, least, most in functions(os.path.join(folder, name), name.endswith(".cc")):
                seen[function].add((name, least, most))
    for function, places in sorted(seen.items()):
        for a in sorted(places):
            for b in sorted(places):
                sources = a[0].endswith(".cc") or b[0].endswith(".cc")
                if a[0] < b[0] and sources and a[1] <= b[2] and b[1] <= a[2]:
                    yield function, a[0], b[0]


def main(root, *tops):
    found = []
    for top in tops:
        for folder, _, _ in os.walk(os.path.join(root, top)):
            found += [(os.path.relpath(folder, root), *c) for c in confused(folder)]
    for folder, function, a, b in found:
        print(f"{folder}: {function} is in {a} and in {b}; one of them needs a name of its own")
    return 1 if found else 0


def test():
    """Finds what it should find, and no more."""
    with tempfile.TemporaryDirectory() as folder:
        files = {"a.cc": "namespace {\nint Twice(int a) { return 2 * a; }\nint Far(int a) { return a; }\n}  // namespace\n",
                 "b.cc": "namespace {\nint Twice(int a,\n          int b = 0) {\n  return a + b;\n}\n}  // namespace\n",
                 "c.cc": "namespace {\nint Far(std::map<int, int> a, int b) { return b; }\n}  // namespace\n",
                 "d.h": "int Near(int a);\n", "d.cc": "int Near(int a) { return a; }\n"}
        for name, text in files.items():
            with open(os.path.join(folder, name), "w") as file:
                file.write(text)
        found = [list(confused(folder))]
        for options in ("ROWS b.cc", "SEPARATE DEPENDS x"):
            with open(os.path.join(folder, "CMakeLists.txt"), "w") as file:
                file.write(f"phs_folder(this {options})\n")
            found.append(list(confused(folder)))
    print(found)
    return 0 if found == [[("Twice", "a.cc", "b.cc")], [], []] else 1


if __name__ == "__main__":
    sys.exit(test() if sys.argv[1:] == ["--try"] else main(*sys.argv[1:]))

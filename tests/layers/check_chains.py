#!/usr/bin/env python3
"""Files of a folder include each other in one direction (docs/design.md).

check_chains.py [--table] [ROOT]: a header, its source file and its X_impl.h count as one part; parts of a folder that
include each other in a circle are printed, exit code 1. --table prints the longest chain of each folder.
"""
import collections
import pathlib
import re
import sys

# Folders whose circles are still to be mended.
OPEN = set()


def read_parts(root):
    """part -> parts of the same folder that it includes."""
    includes = {}
    for folder in sorted([*(root / "src").iterdir(), root / "plugin"]):
        if not folder.is_dir():
            continue
        for file in sorted(folder.rglob("*.h")) + sorted(folder.rglob("*.cc")):
            part = f"{folder.name}/{file.relative_to(folder).with_suffix('')}".removesuffix("_impl")
            of_part = includes.setdefault(part, set())
            for name in re.findall(r'#include "([^"]+)\.h"', file.read_text()):
                name = name.removesuffix("_impl")
                if name != part and name.startswith(folder.name + "/"):
                    of_part.add(name)
    return includes


def find_circles(includes):
    """Tarjan's strongly connected components with more than one part."""
    index, low, stack, circles = {}, {}, [], []

    def visit(part):
        index[part] = low[part] = len(index)
        stack.append(part)
        for other in sorted(includes.get(part, ())):
            if other not in index:
                visit(other)
                low[part] = min(low[part], low[other])
            elif other in stack:
                low[part] = min(low[part], index[other])
        if low[part] == index[part]:
            at = stack.index(part)
            if len(stack) - at > 1:
                circles.append(sorted(stack[at:]))
            del stack[at:]

    for part in sorted(includes):
        if part not in index:
            visit(part)
    return circles


def longest_chains(includes, circles):
    """folder -> number of parts in its longest chain of includes; a circle counts as one."""
    of_circle = {part: circle[0] for circle in circles for part in circle}
    graph = collections.defaultdict(set)
    for part, others in includes.items():
        for other in others:
            a, b = of_circle.get(part, part), of_circle.get(other, other)
            if a != b:
                graph[a].add(b)
    length = {}

    def chain(part):
        if part not in length:
            length[part] = 1 + max((chain(other) for other in graph[part]), default=0)
        return length[part]

    longest = collections.Counter()
    for part in includes:
        folder = part.split("/")[0]
        longest[folder] = max(longest[folder], chain(of_circle.get(part, part)))
    return longest


def main():
    arguments = [a for a in sys.argv[1:] if a != "--table"]
    root = pathlib.Path(arguments[0] if arguments else ".")
    sys.setrecursionlimit(10000)
    includes = read_parts(root)
    circles = find_circles(includes)
    if "--table" in sys.argv:
        for folder, length in sorted(longest_chains(includes, circles).items()):
            print(f"{folder:12} {length}")
    found = [c for c in circles if c[0].split("/")[0] not in OPEN]
    for circle in found:
        print("these include each other: " + ", ".join(circle))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

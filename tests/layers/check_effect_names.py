#!/usr/bin/env python3
"""No effect is known by name to what searches for effects: check_effect_names.py ROOT.

Prints every string of src/identify and src/measurement that names an effect of src/effects or of
src/vehicle/running_effects.cc; exit code 1 if there is one. --try: finds faults in a made-up tree.
"""
import pathlib
import re
import sys
import tempfile

# The formula that stands for what no list has: one place asks whether it went.
KNOWN = {("src/identify/select/effect_search.cc", "unlisted")}


def effect_names(root):
    files = sorted((root / "src/effects").glob("*.cc"))
    files.append(root / "src/vehicle/running_effects.cc")
    names = set()
    for file in files:
        if file.exists():
            found = re.findall(r'EffectInfo(?: info = )?\{\s*"([a-z_]+)"', file.read_text())
            # In the catalogue a row stands in the file of its name.
            names.update(n for n in found if n == file.stem or file.parent.name != "effects")
    return names


def strings(text):
    """(line, string) of every string literal outside comments."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|"((?:[^"\\\n]|\\.)*)"', re.DOTALL)
    for found in pattern.finditer(text):
        if found.group(1) is not None:
            yield text.count("\n", 0, found.start()) + 1, found.group(1)


def complaints(root):
    names = effect_names(root)
    if not names:
        return ["src/effects: no row of an effect found"]
    word = re.compile(r"\b(" + "|".join(sorted(names)) + r")\b")
    out = []
    for folder in ("src/identify", "src/measurement"):
        for file in sorted((root / folder).rglob("*.[ch]*")):
            where = str(file.relative_to(root))
            text = re.sub(r"^#include.*$", "", file.read_text(), flags=re.MULTILINE)
            for line, string in strings(text):
                for name in word.findall(string):
                    if (where, name) not in KNOWN:
                        out.append(f"{where}:{line}: names the effect {name}: say it in its row")
    return out


def try_it():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for path, text in {
            "src/effects/play.cc": 'static const EffectInfo info = {\n "play", "mounting"};',
            "src/identify/select/a.cc": '#include "effects/play.h"\n// "play"\nif (name == "play") x();',
            "src/measurement/b.h": 'Find("effects.play.gap_m"); Find("display");',
        }.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(text)
        found = complaints(root)
    assert [c.split(": ")[0] for c in found] == ["src/identify/select/a.cc:3", "src/measurement/b.h:1"], found


if __name__ == "__main__":
    if sys.argv[1] == "--try":
        try_it()
        sys.exit(0)
    faults = complaints(pathlib.Path(sys.argv[1]))
    print("\n".join(faults))
    sys.exit(1 if faults else 0)

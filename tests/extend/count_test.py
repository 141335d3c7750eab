#!/usr/bin/env python3
"""The count of files finds an example that needs too many, a file that the page does not name, and a lost anchor."""
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True

import examples  # noqa: E402

PAGE = "\n## A bogie\nAt most 2 files. `bogie_xml/NAME.xml`, a line in `docs/bogies.md`.\n\n## A verb\n"


def example(new_files, rows):
    folder = pathlib.Path(tempfile.mkdtemp()) / "bogie" / "some"
    for path in new_files:
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text("<mujoco/>\n")
    (folder / "rows").write_text(rows)
    return examples.Example("bogie", folder)


def refused(action):
    try:
        action()
    except ValueError:
        return True
    return False


ROWS = "file: docs/bogies.md\nafter: | a |\n| | b |\n"
good = example(["bogie_xml/some.xml"], ROWS)
assert examples.check_count(good, PAGE) == []
tree = {"docs/bogies.md": b"| x |\n| a |\n| c |\n"}
examples.apply(good, tree)
assert tree["docs/bogies.md"] == b"| x |\n| a |\n| b |\n| c |\n", tree
assert refused(lambda: examples.apply(good, tree)), "its file is there already"
assert refused(lambda: examples.apply(good, {"docs/bogies.md": b"| x |\n"})), "no anchor"
assert refused(lambda: examples.apply(good, {"docs/bogies.md": b"| a |\n| a |\n"})), "two anchors"
third = example(["bogie_xml/some.xml", "bogie_xml/other.xml"], ROWS)
assert any("3 files, at most 2" in fault for fault in examples.check_count(third, PAGE))
elsewhere = example(["models/some.xml"], ROWS)
assert any("does not name models/some.xml" in fault for fault in examples.check_count(elsewhere, PAGE))
assert any("does not say" in fault for fault in examples.check_count(good, PAGE.replace("2", "3")))
assert examples.missing_paths("`src/a/b.cc` and `src/NAME.cc`", pathlib.Path("/nowhere")) == ["src/a/b.cc"]

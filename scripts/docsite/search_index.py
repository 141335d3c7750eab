#!/usr/bin/env python3
"""The index of the search as a script: a page from the disk may load it. search_index.py SITE"""
import json
import pathlib
import re
import sys

# An equation, as written; nobody reads that in what was found.
EQUATION = re.compile(r"\\\[.*?\\\]|\\\(.*?\\\)", re.S)

folder = pathlib.Path(sys.argv[1]) / "search"
index = json.loads((folder / "search_index.json").read_text(encoding="utf-8"))
for part in index["docs"]:
    part["text"] = EQUATION.sub("…", part["text"])
index = json.dumps(index, ensure_ascii=False)
(folder / "search_index.json").write_text(index, encoding="utf-8")
index = index.replace("\u2028", " ").replace("\u2029", " ")
(folder / "search_index.js").write_text(
    f"var __search = {{index: Promise.resolve({index})}};\n", encoding="utf-8")

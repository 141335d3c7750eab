#!/usr/bin/env python3
"""What MkDocs would pass over in silence: Markdown that it reads otherwise than GitHub, pages without a place.

check_pages.py ROOT SITE: prints what is wrong, exit code 1 if there is any."""
import html.parser
import pathlib
import re
import sys

# Text where Markdown was not read as such.
RAW = {"a row of a table": re.compile(r"\|\s*-{3}"),
       "a fence": re.compile(r"```"),
       "an item of a list": re.compile(r"(?m)^[-*] \S"),
       "a link": re.compile(r"\]\([a-z_./#]+\)"),
       "an equation": re.compile(r"\$`|\\\("),
       "bold type": re.compile(r"\*\*\S")}


class Text(html.parser.HTMLParser):
    """What a reader sees in the article, without code and equations."""

    def __init__(self, text):
        super().__init__()
        self.text, self.depth, self.skip = [], 0, []
        self.tables = self.equations = 0
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        if tag == "article":
            self.depth = 1
        classes = dict(attributes).get("class") or ""
        self.tables += self.depth and tag == "table"
        if "equation" in classes.split():
            self.equations += 1
        if self.skip or tag in ("code", "pre") or "equation" in classes.split():
            if tag not in ("br", "img", "hr", "input", "link", "meta", "path", "use"):
                self.skip.append(tag)

    def handle_endtag(self, tag):
        if tag == "article":
            self.depth = 0
        if self.skip and tag in self.skip:
            while self.skip.pop() != tag:
                pass

    def handle_data(self, data):
        if self.depth and not self.skip:
            self.text.append(data)


def faults_of(page):
    text = "".join(page.text)
    return [f"{what} is shown as it was written: {found[0]!r}"
            for what, pattern in RAW.items() if (found := pattern.search(text))]


def main():
    root, site = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    faults = []
    nav = (root / "scripts/docsite/mkdocs.yml").read_text(encoding="utf-8")
    for source in sorted((root / "docs").rglob("*.md")):
        name = source.relative_to(root / "docs")
        built = site / name.with_suffix(".html")
        if f"- {name}\n" not in nav:
            faults.append(f"{name}: has no place in the navigation (scripts/docsite/mkdocs.yml)")
        if not built.is_file():
            faults.append(f"{name}: was not built")
            continue
        page = Text(built.read_text(encoding="utf-8"))
        faults += [f"{name}: {fault}" for fault in faults_of(page)]
        text = source.read_text(encoding="utf-8")
        code = re.sub(r"```.*?\n```", "", text, flags=re.S)
        tables = len(re.findall(r"(?m)^\s*\|[\s:|-]*---[\s:|-]*\|\s*$", code))
        if tables != page.tables:
            faults.append(f"{name}: {tables} tables are written, {page.tables} shown")
        equations = len(re.findall(r"(?m)^\s*```math$", text)) + len(re.findall(r"\$`", code))
        if equations != page.equations:
            faults.append(f"{name}: {equations} equations are written, {page.equations} shown")
    print("\n".join(faults + [f"{len(faults)} faults"]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

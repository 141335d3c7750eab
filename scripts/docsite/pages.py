#!/usr/bin/env python3
"""Lays out the pages of the site for MkDocs. pages.py ROOT TO"""
import os
import pathlib
import re
import shutil
import sys

import code_pages
from markdown_of_github import to_mkdocs

HERE = pathlib.Path(__file__).resolve().parent
# Files of the repository that are pages; all of docs/ is, under its own name.
PAGES = {"README.md": "index.md", "plugin/README.md": "plugin.md", "CONTRIBUTING.md": "contributing.md",
         "CHANGELOG.md": "changelog.md", "scripts/docfigures/README.md": "figures.md"}
FILE_AS_TEXT = re.compile(r"\[((?:[\w./]+/)?\w+\.md)\]\(([^)\s#]+\.md)(?=[)#])")
BARE = re.compile(r"(?<![\[\w/])docs/(\w+\.md)(?!\w|\]|[^(]*\]\()")
LINK = re.compile(r"(\]\()([^)\s#]+)((?:#[^)\s]*)?\))")


class Layout:
    """Where each file of the repository stands in the site."""

    def __init__(self, root, to):
        self.root, self.to = root, to
        self.places = {root / source: page for source, page in PAGES.items()}
        for file in sorted((root / "docs").rglob("*")):
            if file.is_file():
                self.places[file] = str(file.relative_to(root / "docs"))

    def make(self):
        pages = [file for file in self.places if file.suffix == ".md"]
        for file in self.places:
            if file.suffix != ".md":
                self.copy(file)
        for file in pages:
            self.write(self.places[file], self.page(file))

    def page(self, file):
        """Its text with links as they are in the site."""
        name = self.places[file]

        def link(match):
            begin, target, end = match.groups()
            if re.match(r"[a-z]+:", target):
                return match[0]
            there = (file.parent / target).resolve()
            if not there.exists():
                raise SystemExit(f"{file.relative_to(self.root)}: {target} is not there")
            return begin + relative(name, self.place(there)) + end

        def titled(match):
            """A link that shows a file's name shows the title of its page."""
            there = (file.parent / match[2]).resolve()
            return f"[{title(there)}]({match[2]}" if there in self.places else match[0]

        def links(text):
            return LINK.sub(link, FILE_AS_TEXT.sub(titled, self.named(text, file.parent)))

        # The navigation shows a title as it is written: without marks of code.
        head = f"---\ntitle: \"{title(file)}\"\n---\n"
        return head + to_mkdocs(file.read_text(encoding="utf-8"), links)

    def named(self, text, folder):
        """Pages that a text names without a link, `docs/x.md`, linked as seen from `folder`."""
        def link(match):
            there = self.root / "docs" / match[1]
            if there not in self.places or match.string[:match.start()].endswith("]("):
                return match[0]
            return f"[{title(there)}]({os.path.relpath(there, folder)})"

        return BARE.sub(link, text)

    def place(self, file):
        """Where that file stands; one that stands nowhere yet is laid down."""
        if file not in self.places:
            within = file.relative_to(self.root)
            if file.is_dir():
                self.places[file] = f"files/{within}/index.md"
                self.write(self.places[file], code_pages.folder(file, within))
            else:
                # A page of its text: a browser would offer it for download.
                self.places[file] = f"files/{within}.md"
                self.write(self.places[file], code_pages.file(file, within))
        return self.places[file]

    def copy(self, file):
        there = self.to / self.places[file]
        there.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, there)

    def write(self, place, text):
        there = self.to / place
        there.parent.mkdir(parents=True, exist_ok=True)
        there.write_text(text, encoding="utf-8")


def title(file):
    """The first heading, without marks."""
    for line in file.read_text(encoding="utf-8").splitlines():
        if line.startswith("# "):
            return line[2:].replace("`", "")
    raise SystemExit(f"{file}: has no heading")


def relative(page, target):
    up = page.count("/")
    return "../" * up + target


def main():
    root, to = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    layout = Layout(root, to / "pages")
    layout.make()
    for name, text in code_pages.reference(root).items():
        # As if it stood in a folder of docs/.
        layout.write(name, to_mkdocs(text, lambda t: layout.named(t, root / "docs/reference")))
    shutil.copytree(HERE / "theme", to / "theme")
    shutil.copyfile(HERE / "mkdocs.yml", to / "mkdocs.yml")


main()

#!/usr/bin/env python3
"""Every link of a built site leads to a page that is there and to a place on it; nothing is fetched from outside.

check_links.py SITE: prints what is wrong, exit code 1 if there is any."""
import html.parser
import pathlib
import re
import sys
import urllib.parse

# Attributes by which a page fetches something when it is opened.
FETCHED = {("img", "src"), ("script", "src"), ("iframe", "src"), ("source", "src"), ("video", "src")}


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.ids, self.links, self.fetched = set(), [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        for name in ("id", "name"):
            if values.get(name):
                self.ids.add(values[name])
        if tag == "a" and values.get("href"):
            self.links.append(values["href"])
        if tag == "link" and values.get("rel") not in ("canonical", "prev", "next"):
            self.fetched.append(values.get("href", ""))
        for attribute in ("src", "srcset", "poster"):
            if (tag, attribute) in FETCHED and values.get(attribute):
                self.fetched.append(values[attribute])

    handle_startendtag = handle_starttag


def is_outside(address):
    return bool(re.match(r"[a-z]+:|//", address))


def check(site):
    """What is wrong, one line each; and how many links were followed."""
    pages = {file: Page(file.read_text(encoding="utf-8")) for file in site.rglob("*.html")}
    faults, count = [], 0
    for file, page in sorted(pages.items()):
        name = file.relative_to(site)
        for address in page.fetched:
            if address.startswith("data:"):
                continue
            if is_outside(address):
                faults.append(f"{name}: fetches {address}")
            elif not target(site, file, address)[0].is_file():
                faults.append(f"{name}: {address} is not there")
        for address in page.links:
            if is_outside(address):
                continue
            count += 1
            there, anchor = target(site, file, address)
            if there not in pages and not there.is_file():
                faults.append(f"{name}: {address} is not there")
            elif anchor and there in pages and anchor not in pages[there].ids:
                faults.append(f"{name}: {address}: no such place on the page")
    for file in sorted(site.rglob("*.css")):
        for address in re.findall(r"url\(\s*['\"]?([^'\")]+)", file.read_text(encoding="utf-8")):
            if is_outside(address) and not address.startswith("data:"):
                faults.append(f"{file.relative_to(site)}: fetches {address}")
    return faults, count


def target(site, page, address):
    parts = urllib.parse.urlsplit(address)
    path = urllib.parse.unquote(parts.path)
    # MkDocs writes the page of what is not found for a server's root.
    base = site if path.startswith("/") else page.parent
    there = (base / path.lstrip("/")).resolve() if path else page
    if there.is_dir():
        there /= "index.html"
    return there, urllib.parse.unquote(parts.fragment)


def main():
    site = pathlib.Path(sys.argv[1]).resolve()
    faults, count = check(site)
    print("\n".join(faults + [f"{count} links followed, {len(faults)} faults"]))
    return 1 if faults or count < 100 else 0


if __name__ == "__main__":
    sys.exit(main())

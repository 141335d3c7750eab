#!/usr/bin/env python3
"""The checks of the site find what they are there for."""
import pathlib
import tempfile
import unittest

import check_links
import check_pages


class Links(unittest.TestCase):
    def faults(self, body, head=""):
        with tempfile.TemporaryDirectory() as folder:
            site = pathlib.Path(folder).resolve()
            (site / "other").mkdir()
            (site / "other/b.html").write_text('<h2 id="here">b</h2>')
            (site / "pic.png").write_bytes(b"")
            (site / "a.html").write_text(f"<head>{head}</head><body>{body}</body>")
            return check_links.check(site)[0]

    def test_good_ones(self):
        self.assertEqual(self.faults(
            '<a href="other/b.html#here">b</a><a href="https://example.org">far</a><a href="#x" id="x">x</a>'
            '<img src="pic.png"><img src="data:image/png;base64,AAAA">'), [])

    def test_a_page_that_is_not_there(self):
        self.assertIn("c.html is not there", self.faults('<a href="other/c.html">c</a>')[0])

    def test_a_place_that_is_not_there(self):
        self.assertIn("no such place", self.faults('<a href="other/b.html#there">b</a>')[0])

    def test_a_picture_that_is_not_there(self):
        self.assertIn("is not there", self.faults('<img src="none.png">')[0])

    def test_what_is_fetched_from_outside(self):
        for body, head in (('<img src="https://example.org/p.png">', ""), ("", '<script src="//cdn/x.js"></script>'),
                           ("", '<link rel="stylesheet" href="https://fonts.example.org/css">')):
            self.assertIn("fetches", self.faults(body, head)[0])


class Pages(unittest.TestCase):
    def faults(self, body):
        return check_pages.faults_of(check_pages.Text(f"<article>{body}</article>"))

    def test_good_ones(self):
        self.assertEqual(self.faults("<p>a <code>| --- |</code> <b>x</b></p><pre><code>```\n- x</code></pre>"), [])

    def test_markdown_that_was_not_read(self):
        for text in ("<p>| a |\n|---|</p>", "<p>text\n- item</p>", "<p>see [x](y.md)</p>", "<p>**bold**</p>",
                     "<p>$`x`$</p>", "<p>```yaml</p>"):
            self.assertEqual(len(self.faults(text)), 1, text)


unittest.main()

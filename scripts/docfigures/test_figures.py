"""What scripts/figures promises of places and numbers."""
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from docfigures import command, places  # noqa: E402
from docfigures.form import attack, attack_words, number, short, table  # noqa: E402


class Same(unittest.TestCase):
    def test_last_digit_may_be_off_by_one_and_no_more(self):
        self.assertTrue(places.same("37.2", "37.3"))
        self.assertFalse(places.same("37.2", "37.4"))
        self.assertTrue(places.same("1200", "1201"))
        self.assertFalse(places.same("1200", "1202"))
        self.assertTrue(places.same("4e-5", "5e-5"))
        self.assertFalse(places.same("4e-5", "6e-5"))

    def test_sign_and_words_count(self):
        self.assertFalse(places.same("0.09 mrad to the outer rail", "0.09 mrad to the inner rail"))
        self.assertFalse(places.same("−0.25", "0.25"))
        self.assertTrue(places.same("−0.25", "−0.24"))
        self.assertFalse(places.same("1 and 2", "1 and 2 and 3"))

    def test_a_table_is_compared_number_by_number(self):
        self.assertTrue(places.same(table(["a"], [["1.0"], ["2.0"]]), table(["a"], [["1.1"], ["2.0"]])))
        self.assertFalse(places.same(table(["a"], [["1.0"]]), table(["a"], [["1.0"], ["2.0"]])))


class Places(unittest.TestCase):
    TEXT = "a <!--=x-->1<!--/--> b <!--=nightly.y-->2\n3<!--/--> <!--=nightly.made-->?<!--/-->"

    def test_fills_what_it_knows_and_leaves_the_rest(self):
        self.assertEqual(places.filled(self.TEXT, {"x": "7"}), self.TEXT.replace(">1<", ">7<"))

    def test_fast_and_nightly_places_are_told_apart(self):
        self.assertEqual(places.names(self.TEXT, ""), ["x"])
        self.assertEqual(places.names(self.TEXT, "nightly."), ["nightly.y", "nightly.made"])

    def test_every_difference_is_named(self):
        wrong = places.differences(self.TEXT, {"x": "3", "z": "1"}, "")
        self.assertEqual(len(wrong), 2)
        self.assertIn("no such place", wrong[0])
        self.assertIn("printed", wrong[1])
        self.assertIn("no list fills", places.differences(self.TEXT, {}, "")[0])
        good = {"nightly.y": "2 4", "nightly.made": "another day"}
        self.assertEqual(places.differences(self.TEXT, good, "nightly."), [])


class Form(unittest.TestCase):
    def test_numbers(self):
        self.assertEqual(number(-0.251, 2), "−0.25")
        self.assertEqual(number(-0.001, 2), "0.00")
        self.assertEqual(number(None), "–")
        self.assertEqual(short(0.012345, 2), "0.012")
        self.assertEqual(short(123.4, 2), "123")

    def test_an_axle_turned_right_in_a_left_curve_points_to_the_outer_rail(self):
        self.assertEqual(attack(-4.61e-3), "4.61 outer")
        self.assertEqual(attack(-4.61e-3, hand=-1), "4.61 inner")
        self.assertEqual(attack_words(9e-5), "0.09 mrad to the inner rail")
        self.assertEqual(attack(1e-7), "0.00")


class Documents(unittest.TestCase):
    """README.md and docs/*.md as they stand, without running anything."""

    OTHERS = ("docs/convergence.md",)  # scripts/convergence writes it

    def setUp(self):
        paths = [command.SOURCE / "README.md", *sorted((command.SOURCE / "docs").glob("*.md"))]
        self.texts = {str(p.relative_to(command.SOURCE)): p.read_text() for p in paths}

    def test_every_list_has_a_document_and_every_place_a_list(self):
        prefixes = {}
        for a_list in command.all_lists():
            self.assertIn(a_list.DOCUMENT, self.texts)
            prefixes.setdefault(a_list.DOCUMENT, []).append(command.prefix(a_list))
        for document, text in self.texts.items():
            if document in self.OTHERS:
                continue
            of_lists = sum(len(places.names(text, p)) for p in prefixes.get(document, []))
            self.assertEqual(of_lists, len(places.PLACE.findall(text)), document)

    def test_no_place_is_empty(self):
        for document, text in self.texts.items():
            if document in self.OTHERS:
                continue
            for name, content in places.PLACE.findall(text):
                self.assertTrue(content.strip(), f"{document}: {name} was never filled")

    def test_no_figure_of_a_sentence_begins_a_line(self):
        """A line that begins with a comment is raw HTML to Markdown, and ends the paragraph before it."""
        for document, text in self.texts.items():
            for number_, line in enumerate(text.splitlines(), 1):
                begins = line.startswith("<!--=") and "<!--/-->" in line
                self.assertFalse(begins, f"{document}:{number_}: put a word before the figure")


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
"""oil_temperature_cut.py PHS KEEP: the three temperature studies as shipped, cut to two reservoirs and two
temperatures, through the list that writes docs/oil_temperature.md; every cell must stand there."""
import re
import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "scripts"))
sys.dont_write_bytecode = True

from docfigures import list_oil_temperature_nightly as oil  # noqa: E402
from docfigures.runs import Phs  # noqa: E402

CUTS = (("[quarter_setup1, quarter_setup2, quarter_setup3, quarter_setup4]",
         "[quarter_setup1, quarter_setup2]"),
        ("from: 253.15, to: 323.15, count: 8", "values: [263.15, 293.15]"))


class CutPhs:
    """A phs that makes a shipped study small."""

    def __init__(self, phs):
        self.phs, self.studies = phs, []

    def result_text(self, command, name, codes):
        verb, study = command.split()
        text = (SOURCE / "models/sweeps" / (study + ".yaml")).read_text()
        for whole, part in CUTS:
            assert text.count(whole) == 1, f"{study}: no '{whole}'"
            text = text.replace(whole, part)
        self.studies.append(study)
        return self.phs.result_text(f"{verb} {self.phs.file(text)}", name, codes)


def cells(table):
    """{(row, column): cell} of a Markdown table."""
    lines = [[c.strip() for c in line.strip("|").split("|")]
             for line in table.strip().splitlines()]
    return {(line[0], head): cell for line in lines[2:] for head, cell in zip(lines[0], line)}


def close(a, b):
    """The same words, or numbers that differ by one in the last digit."""
    try:
        x, y = (float(t.replace("−", "-")) for t in (a, b))
    except ValueError:
        return a == b
    decimals = len(a.partition(".")[2])
    return abs(x - y) < 1.5 * 10 ** -decimals


def main(program, keep):
    page = (SOURCE / oil.DOCUMENT).read_text()
    phs = CutPhs(Phs(program, SOURCE, keep))
    made = oil.figures(phs)
    assert len(phs.studies) == 3, phs.studies
    wrong, numbers = [], 0
    for place, table in made.items():
        said = re.search(rf"<!--=nightly\.{place}-->(.*?)<!--/-->", page, re.S)
        assert said, f"{oil.DOCUMENT} has no place nightly.{place}"
        there = cells(said.group(1))
        for (row, column), cell in cells(table).items():
            if column == "largest / least":
                continue  # of all temperatures
            numbers += cell not in (row, "–")
            if not close(cell, there[row, column]):
                wrong.append(f"{place}: {row}, {column}: {cell}, the page says {there[row, column]}")
    # Setup 1 lives at 20 °C and not at -10 °C, setup 2 at both: three numbers in each table.
    assert numbers == 3 * len(made), f"{numbers} numbers in {len(made)} tables"
    print("\n".join(wrong) or f"{numbers} numbers as on the page")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

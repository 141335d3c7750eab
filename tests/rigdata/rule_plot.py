#!/usr/bin/env python3
"""What moving a number of the rule of acceptance does, as a picture: docs/pictures/identify_rule.svg.

    rule_plot.py TABLE.csv OUT.svg

TABLE is that of rule_study.py. A panel for each number, over the factor that it was moved by: on how many records the
right thing is accepted, on how many another thing than by the rule as it is, and false alarms.
"""
import csv
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../scripts"))
from docfigures.blind import parted  # noqa: E402
from docfigures.list_identify_rule import WHOLE, is_right  # noqa: E402
from rule_study import FACTORS, NUMBERS  # noqa: E402

CURVES = (("right", "#1f5fa8"), ("accepts otherwise", "#c8641e"), ("false alarms", "#a01f3c"))
TICKS = {0.25: "¼", 0.5: "½", 1: "1", 2: "2", 4: "4"}
PANEL, HEIGHT, LEFT, TOP, GAP = 200, 150, 46, 44, 34


def read_table(path):
    """{variant: {(suite, set): row}} of the variants that have all records."""
    all_of = {}
    with open(path, newline="") as file:
        for row in parted(csv.DictReader(file)):
            all_of.setdefault(row["variant"], {})[row["suite"], row["set"]] = row
    return {variant: of for variant, of in all_of.items() if len(of) == len(all_of[WHOLE])}


def counts(of, whole):
    """Right, accepted otherwise, false alarms."""
    return (sum(map(is_right, of.values())), sum(of[key]["accepted"] != whole[key]["accepted"] for key in of),
            sum(bool(row["accepted"]) for row in of.values() if row["kind"] == "clean"))


def curves_of(table, number):
    """[(factor, (right, otherwise, false alarms))] in the order of the factors."""
    moved = [(factor, f"{number} {words}") for words, factor in FACTORS.items()] + [(1, WHOLE)]
    return [(factor, counts(table[name], table[WHOLE])) for factor, name in sorted(moved) if name in table]


def panel(x0, number, points, most):
    across = {factor: x0 + PANEL * (k + 0.5) / len(points) for k, (factor, _) in enumerate(points)}
    up = lambda n: TOP + HEIGHT * (1 - n / most)  # noqa: E731
    out = [f'<rect x="{x0}" y="{TOP}" width="{PANEL}" height="{HEIGHT}" fill="none" stroke="#999"/>',
           f'<text x="{x0 + PANEL / 2}" y="{TOP - 8}" text-anchor="middle">{number} = {NUMBERS[number]:g}</text>']
    for n in range(0, most + 1, 10):
        out.append(f'<path d="M{x0} {up(n):.1f}h{PANEL}" stroke="#e4e4e4"/>')
        if x0 == LEFT:
            out.append(f'<text x="{x0 - 6}" y="{up(n) + 4:.1f}" text-anchor="end">{n}</text>')
    for factor, _ in points:
        out.append(f'<text x="{across[factor]:.1f}" y="{TOP + HEIGHT + 16}" text-anchor="middle">× {TICKS[factor]}</text>')
    for k, (_, colour) in enumerate(CURVES):
        line = " ".join(f"{across[factor]:.1f},{up(of[k]):.1f}" for factor, of in points)
        out.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="2"/>')
        out += [f'<circle cx="{across[f]:.1f}" cy="{up(of[k]):.1f}" r="3" fill="{colour}"/>' for f, of in points]
    return out


def draw(table):
    most = len(table[WHOLE])
    width = LEFT + len(NUMBERS) * (PANEL + GAP)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{TOP + HEIGHT + 50}" '
           'font-family="sans-serif" font-size="12">', '<rect width="100%" height="100%" fill="white"/>']
    for k, number in enumerate(NUMBERS):
        out += panel(LEFT + k * (PANEL + GAP), number, curves_of(table, number), most)
    for k, (name, colour) in enumerate(CURVES):
        x, y = LEFT + 235 * k, TOP + HEIGHT + 38
        out.append(f'<path d="M{x} {y - 4}h22" stroke="{colour}" stroke-width="2"/>'
                   f'<text x="{x + 28}" y="{y}">{name}, of {most} records</text>')
    return "\n".join(out + ["</svg>"]) + "\n"


def main():
    if len(sys.argv) != 3:
        print(__doc__.split("\n\n")[1].strip(), file=sys.stderr)
        return 2
    with open(sys.argv[2], "w") as file:
        file.write(draw(read_table(sys.argv[1])))
    return 0


if __name__ == "__main__":
    sys.exit(main())

"""Scores on blind sets, counted anew from the tables of every set in tests/rigdata."""
import csv

from docfigures.form import number, table

COLUMNS = {"holdout": "`holdout`", "first_hand": "first hand", "second_hand": "second hand",
           "third_hand": "third hand", "fourth_hand": "fourth hand", "fifth_hand": "fifth hand",
           "sixth_hand": "sixth hand, after mends", "seventh_hand": "seventh hand",
           "eighth_hand": "eighth hand, after mends", "ninth_hand": "ninth hand, after mends",
           "tenth_hand": "tenth hand, after mends", "eleventh_hand": "eleventh hand, after mends",
           "twelfth_hand": "twelfth hand, after mends", "thirteenth_hand": "thirteenth hand, after mends",
           "fourteenth_hand": "fourteenth hand, after mends", "sixteenth_hand": "sixteenth hand, after mends",
           "seventeenth_hand": "seventeenth hand, after mends"}
VERDICTS = ("sufficient", "explained", "not_described", "undecidable")


def parted(rows):
    """The rows with `hidden` and `accepted` as sets of names."""
    return [{**row, "hidden": {name.replace(" (weak)", "") for name in row["hidden"].split("+")} - {"nothing"},
             "accepted": set(row["accepted"].split("+")) - {"nothing"}} for row in rows]


def sets(phs, name="score_blind.csv"):
    with open(phs.source / "tests/rigdata" / name, newline="") as file:
        return parted(csv.DictReader(file))


def outcome(row):
    """What an answer was worth: one word for each set."""
    hidden, accepted = row["hidden"], row["accepted"]
    if row["kind"] == "off_list":
        return "formula" if "unlisted" in accepted else "other" if accepted else "nothing"
    if accepted == hidden:
        return "exact"
    return "one more" if hidden < accepted else "other" if accepted else "nothing"


def of(rows, kind, good):
    """(right, all) of the sets of a kind."""
    chosen = [row for row in rows if row["kind"] == kind]
    return sum(map(good, chosen)), len(chosen)


MEASURES = (
    ("right effect first, single effects", "92 %", "single", lambda row: row["right"] == "1"),
    ("exact, single effects", "85 %", "single", lambda row: row["exact"] == "1"),
    ("pairs found completely", "80 %", "pair", lambda row: row["hidden"] <= row["accepted"]),
    ("false alarms, clean sets", "1 in 60", "clean", lambda row: bool(row["accepted"])),
    ("on no list: a formula accepted", "70 %", "off_list", lambda row: "unlisted" in row["accepted"]),
)


def share(good, all_):
    return f"{good} of {all_}" if all_ else "–"


def middle_and_mean(rows):
    ratios = sorted(float(row["error_ratio"]) for row in rows if row["error_ratio"])
    return f"{number(ratios[len(ratios) // 2], 2)} ({number(sum(ratios) / len(ratios), 2)})"


def score_table(rows):
    suites = [suite for suite in COLUMNS if any(row["suite"] == suite for row in rows)]
    parts = [[row for row in rows if row["suite"] == suite] for suite in suites] + [rows]
    lines = [[what, asked] + [share(*of(part, kind, good)) for part in parts]
             for what, asked, kind, good in MEASURES]
    lines.append(["error over that of the true model, median (mean)", "1.10"] + [middle_and_mean(p) for p in parts])
    return table(["", "asked", *(COLUMNS[suite] for suite in suites), "pooled"], lines)


def with_verdict(rows, verdict, *outcomes):
    """How many sets ended so, of these outcomes if any are named."""
    return sum(row["verdict"] == verdict and (not outcomes or outcome(row) in outcomes) for row in rows)

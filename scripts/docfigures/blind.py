"""Scores on blind sets, counted anew from the tables of every set in tests/rigdata."""
import csv
import pathlib
import sys

from docfigures.form import number, table

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests" / "rigdata"))
from blind_sets import share_interval  # noqa: E402

ROWS = {"holdout": "`holdout`", **{each + "_hand": each for each in (
    "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth", "eleventh", "twelfth",
    "thirteenth", "fourteenth", "sixteenth", "seventeenth", "eighteenth", "nineteenth", "twentieth")},
    "twentyfirst_hand": "twenty-first", "twentysecond_hand": "twenty-second",
    "twentythird_hand": "twenty-third", "twentyfifth_hand": "twenty-fifth",
    "twentysixth_hand": "twenty-sixth",
    "twentyseventh_hand": "twenty-seventh",
    "twentyeighth_hand": "twenty-eighth", "twentyninth_hand": "twenty-ninth", "thirtieth_hand": "thirtieth", "thirtyfirst_hand": "thirty-first"}
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
    ("right effect first", "92 %", "single", lambda row: row["right"] == "1"),
    ("exact", "85 %", "single", lambda row: row["exact"] == "1"),
    ("pairs complete", "80 %", "pair", lambda row: row["hidden"] <= row["accepted"]),
    ("false alarms", "1 in 60", "clean", lambda row: bool(row["accepted"])),
    ("on no list: a formula", "70 %", "off_list", lambda row: "unlisted" in row["accepted"]),
)


# Read by hand, where it was: docs/identify_score.md.
DESCRIBED = ("described", "70 %", "off_list", lambda row: row["described"] == "1")


def share(good, all_):
    return f"{good} of {all_}" if all_ else "–"


def interval(good, all_):
    low, high = share_interval(good, all_) if all_ else (0.0, 1.0)
    return f"{100 * low:.0f} … {100 * high:.0f} %"


def middle_and_mean(rows):
    ratios = sorted(float(row["error_ratio"]) for row in rows if row["error_ratio"])
    return f"{number(ratios[len(ratios) // 2], 2)} ({number(sum(ratios) / len(ratios), 2)})"


def score_table(rows):
    """A row for each hand, one for all; `rows` of other suites are an error."""
    suites = [suite for suite in ROWS if any(row["suite"] == suite for row in rows)]
    assert {row["suite"] for row in rows} <= set(suites)
    parts = [(ROWS[suite], [row for row in rows if row["suite"] == suite]) for suite in suites] + [("**pooled**", rows)]
    measures = [*MEASURES, DESCRIBED] if "described" in rows[0] else MEASURES
    lines = [["*asked*", *(asked for _, asked, _, _ in measures), "1.10"]]
    for name, part in parts:
        lines.append([name, *(share(*of(part, kind, good)) for _, _, kind, good in measures), middle_and_mean(part)])
    lines.append(["exact 95 % interval", *(interval(*of(rows, kind, good)) for _, _, kind, good in measures), ""])
    return table(["hand", *(what for what, *_ in measures), "error over that of the true model, median (mean)"], lines)


def with_verdict(rows, verdict, *outcomes):
    """How many sets ended so, of these outcomes if any are named."""
    return sum(row["verdict"] == verdict and (not outcomes or outcome(row) in outcomes) for row in rows)

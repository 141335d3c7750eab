"""docs/identify_rule.md: each part of the rule of acceptance left out, each of its numbers moved, from the tables
tests/rigdata/rule_study_parts.csv and rule_study.csv."""
import csv

from docfigures.blind import outcome, parted
from docfigures.form import table

DOCUMENT = "docs/identify_rule.md"
WHOLE = "as it is"


def by_variant(phs, name):
    """{variant: {(suite, set): row}}."""
    with open(phs.source / "tests/rigdata" / name, newline="") as file:
        rows = parted(csv.DictReader(file))
    all_of = {}
    for row in rows:
        all_of.setdefault(row["variant"], {})[row["suite"], row["set"]] = row
    return all_of


def further(phs):
    """Rows of two parts on further records: pairs, and effects on no list."""
    all_of = by_variant(phs, "rule_study_more.csv")
    whole = all_of.pop(WHOLE)
    rows = []
    for variant, of in all_of.items():
        for kind, words in (("pair", "pairs"), ("off_list", "effects on no list")):
            own = {key: row for key, row in of.items() if row["kind"] == kind and key in whole}
            if own:
                rows.append([variant, words, str(len(own))] + counted(own, {key: whole[key] for key in own})[2:4])
    return table(["the rule", "records of", "how many", "sets that accept otherwise", "of them better / worse"], rows)


def is_right(row):
    """Nothing on a clean set, all that is hidden and nothing else, a formula for what is on no list."""
    return row["hidden"] == row["accepted"] or outcome(row) == "formula" and row["accepted"] == {"unlisted"}


def counted(of, whole):
    """[right of all, right of hidden, false alarms, sets that end otherwise, of them better and worse, with another verdict]."""
    clean = [row for row in of.values() if row["kind"] == "clean"]
    other = [key for key in of if of[key]["accepted"] != whole[key]["accepted"]]
    better = sum(is_right(of[key]) and not is_right(whole[key]) for key in other)
    worse = sum(is_right(whole[key]) and not is_right(of[key]) for key in other)
    verdicts = sum(of[key]["verdict"] != whole[key]["verdict"] for key in of)
    return [f"{sum(map(is_right, of.values()))} of {len(of)}", sum(bool(row["accepted"]) for row in clean), len(other),
            f"{better} / {worse}", verdicts]


def literals(phs):
    """How many literals were moved, on how many records, and those that changed any (tests/rigdata/literal_study.py)."""
    with open(phs.source / "tests/rigdata/literal_study.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    said = {}
    for row in rows:
        said.setdefault(row["literal"], {})[row["factor"], row["suite"], row["set"]] = row["accepted"], row["verdict"]
    whole = {key[1:]: words for key, words in said.pop(WHOLE).items()}
    other = [name for name, of in said.items() if any(words != whole[key[1:]] for key, words in of.items())]
    return {"literals": str(len(said)), "literal_records": str(len(whole)),
            "literals_other": ", ".join(f"`{name}`" for name in other) or "none"}


HEAD = ["right", "false alarms", "sets that accept otherwise", "of them better / worse", "other verdict"]


def rows_of(phs, name, is_wanted):
    """(rows of the table, records, clean ones) of the variants that have all records."""
    all_of = by_variant(phs, name)
    whole = all_of[WHOLE]
    rows = [[variant] + counted(of, whole) for variant, of in all_of.items()
            if len(of) == len(whole) and is_wanted(variant)]
    return rows, str(len(whole)), str(sum(row["kind"] == "clean" for row in whole.values()))


def figures(phs):
    numbers, _, _ = rows_of(phs, "rule_study.csv",
                            lambda v: v.endswith(("quartered", "halved", "doubled", "quadrupled")))
    parts, sets, clean = rows_of(phs, "rule_study_parts.csv", lambda v: v == WHOLE or v.startswith("without"))
    return {"parts": table(["the rule"] + HEAD, parts), "numbers": table(["number"] + HEAD, numbers),
            "further": further(phs), **literals(phs), "sets": sets, "clean": clean}

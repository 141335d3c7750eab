"""docs/identify_bogie.md: how many intervals hold the truth, counted from tests/rigdata/bogie_coverage.csv and, of records
in which nothing is hidden, bogie_clean.csv; and anew, from bogie_trembling.csv."""
import csv
import sys

from docfigures.form import table

DOCUMENT = "docs/identify_bogie.md"
WORDS = {"friction.scale": "scale of friction", "lines.gas_volume_m3": "gas of the lines"}


def off(row):
    """How far the truth is from the value, in half widths of the interval on its side; > 0: above."""
    truth, value, low, high = (float(row[k]) for k in ("truth", "value", "low", "high"))
    return (truth - value) / (high - value if truth > value else value - low)


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def coverage(rows, share_text):
    """A row for each kind of number."""
    counted = [row for row in rows if row["truth"]]
    groups = {words: [row for row in counted if row["number"] == name] for name, words in WORDS.items()}
    groups["amounts of what is hidden"] = [row for row in counted if row["number"] not in WORDS]
    lines = []
    for words, of in groups.items():
        missed = sorted(off(row) for row in of if abs(off(row)) > 1)
        lines.append([words, share_text(len(of) - len(missed), len(of)),
                      ", ".join(f"{x:+.1f}".replace("-", "−") for x in missed) or "none"])
    return table(["95 % interval of", "hold the truth", "missed by, in half widths"], lines)


def figures(phs):
    sys.path.insert(0, str(phs.source / "tests/rigdata"))
    from blind_sets import share_text
    rows, clean_rows, now = (read(phs.source / f"tests/rigdata/bogie_{name}.csv")
                             for name in ("coverage", "clean", "trembling"))
    records = {row["seed"]: row for row in rows}.values()
    more_clean = {row["seed"]: row for row in clean_rows}.values()
    clean = [row for row in records if row["hidden"] == "nothing"]
    as_hidden = sum(bool(row["truth"]) for row in records if row["hidden"] != "nothing")
    records_now = {row["seed"]: row for row in now}.values()
    ratios = [float(row["value"]) / float(row["truth"]) for row in now if row["number"] == "friction.scale"]
    told = [row for row in now if row["truth"]]
    return {"coverage": coverage(rows + clean_rows, share_text), "now": coverage(now, share_text),
            "now_records": str(len(records_now)),
            "now_all": share_text(sum(abs(off(row)) <= 1 for row in told), len(told)),
            "now_counted": f"{sum(bool(row['truth']) for row in records_now)} of {len(records_now)}",
            "now_friction": f"{sum(ratios) / len(ratios):.3f}",
            "coverage_records": str(len(records)), "coverage_clean": str(len(clean) + len(more_clean)),
            "clean_records": str(len(more_clean)),
            "coverage_false": str(sum(not row["truth"] for row in [*clean, *more_clean])),
            "coverage_found": f"{as_hidden} of {len(records) - len(clean)}"}

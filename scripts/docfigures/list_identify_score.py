"""docs/identify_score.md: the blind sets, from the table of every set."""
from docfigures.blind import VERDICTS, score_table, sets, with_verdict

DOCUMENT = "docs/identify_score.md"


def figures(phs):
    rows = sets(phs)
    present = sets(phs, "score_present.csv")
    out = {"scores": score_table(rows), "sets": str(len(rows)), "present": score_table(present),
           "present_sets": str(len(present))}
    for name, file in (("hands", "score_three_hands.csv"), ("later", "score_later_hands.csv")):
        hands = sets(phs, file)
        out[name], out[name + "_sets"] = score_table(hands), str(len(hands))
        out[name + "_explained"] = str(with_verdict(hands, "explained"))
        out[name + "_explained_right"] = str(with_verdict(hands, "explained", "exact", "one more", "formula"))
    for verdict in VERDICTS:
        out[verdict] = str(with_verdict(rows, verdict))
    clean = [row for row in rows if row["kind"] == "clean"]
    hidden = [row for row in rows if row["kind"] != "clean"]
    out["sufficient_clean"] = str(with_verdict(clean, "sufficient"))
    out["not_described_clean"] = str(with_verdict(clean, "not_described"))
    out["not_described_hidden"] = str(with_verdict(hidden, "not_described"))
    out["explained_exact"] = str(with_verdict(rows, "explained", "exact"))
    out["explained_more"] = str(with_verdict(rows, "explained", "one more"))
    out["explained_formula"] = str(with_verdict(rows, "explained", "formula"))
    out["explained_wrong"] = str(with_verdict(rows, "explained", "other", "nothing"))
    return out

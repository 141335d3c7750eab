"""docs/identify_score.md: the blind sets, from the table of every set."""
from docfigures.blind import VERDICTS, score_table, sets, with_verdict

DOCUMENT = "docs/identify_score.md"


def of_sticking_hand(phs):
    """Of the records that all hold presliding as well: what was named of it, and beside it."""
    rows = sets(phs, "score_sticking_hand.csv")
    kinds = {kind: [row for row in rows if row["kind"] == kind] for kind in ("clean", "single", "pair")}
    alone = sum(row["accepted"] == {"presliding"} for row in kinds["clean"])
    both = [sum(row["hidden"] <= row["accepted"] for row in kinds[kind]) for kind in ("single", "pair")]
    exact = sum(row["accepted"] == row["hidden"] | {"presliding"} for row in kinds["single"])
    return {"sticking_named": f"{sum('presliding' in row['accepted'] for row in rows)} of {len(rows)}",
            "sticking_alone": f"{alone} of {len(kinds['clean'])}",
            "sticking_single": f"{both[0]} of {len(kinds['single'])}",
            "sticking_exact": f"{exact} of {len(kinds['single'])}",
            "sticking_pairs": f"{both[1]} of {len(kinds['pair'])}"}


def figures(phs):
    rows = sets(phs)
    present = sets(phs, "score_present.csv")
    out = {"scores": score_table(rows), "sets": str(len(rows)), "present": score_table(present),
           "present_sets": str(len(present)), **of_sticking_hand(phs)}
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

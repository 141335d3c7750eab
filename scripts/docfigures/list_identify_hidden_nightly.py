"""docs/identify_examples.md: two records of an independent program with known truth."""
from docfigures.form import number
from docfigures.hidden import answer, errors, truth, verdict, with_interval

DOCUMENT = "docs/identify_examples.md"
PART = "hidden."


def figures(phs):
    off, pair = answer(phs, "off_list"), answer(phs, "pair")
    valve = truth(phs, "off_list")["effects"][0]["parameters"]
    leak, play = (e["parameters"] for e in truth(phs, "pair")["effects"])
    found = {e["name"]: e["parameters"] for e in pair["effects"]}
    return {
        "off_verdict": verdict(off),
        "off_formula": "`" + "; ".join(e.get("formula", "none") for e in off["effects"]) + "`",
        "off_amount": ", ".join(with_interval(e["parameters"]["c1_m3_per_s"], 1e8, 3, "· 10⁻⁸ m³/s")
                                for e in off["effects"] if "c1_m3_per_s" in e["parameters"]),
        # The formula counts from the static pressure, 1.8 MPa, and per 10 MPa.
        "off_true_opens": number((valve["pressure_Pa"] - 1.8e6) / 1e6, 3) + " MPa",
        "off_true_amount": number(1e7 * valve["conductance_m3_s_Pa"] * 1e8, 3) + " · 10⁻⁸ m³/s",
        "off_errors": errors(phs, "off_list"),
        "pair_verdict": verdict(pair),
        "pair_gap": with_interval(found["backlash"]["gap_m"], 1e3, 4, "mm"),
        "pair_true_gap": number(1e3 * play["gap_m"], 4) + " mm",
        "pair_leak": with_interval(found["piston_leakage"]["conductance_m3_per_Pas"], 1e15, 3, "· 10⁻¹⁵ m³/(Pa s)"),
        "pair_true_leak": number(1e15 * leak["conductance"], 3) + " · 10⁻¹⁵",
        "pair_errors": errors(phs, "pair"),
    }

"""docs/identify_examples.md: two records of an independent program with known truth."""
import math
import re

from docfigures.form import number
from docfigures.hidden import answer, errors, truth, verdict, with_interval

DOCUMENT = "docs/identify_examples.md"
PART = "hidden."


def figures(phs):
    off, pair = answer(phs, "off_list"), answer(phs, "pair")
    cogging = truth(phs, "off_list")["effects"][0]["parameters"]
    wave = next(iter(e for e in off["effects"] if "formula" in e), {"formula": "", "parameters": {}})
    amounts = [wave["parameters"][c]["value"] for c in ("c1_N", "c2_N") if c in wave["parameters"]]
    length = re.search(r"x/([0-9.e+-]+)\[m\]", wave["formula"])
    leak, play = (e["parameters"] for e in truth(phs, "pair")["effects"])
    found = {e["name"]: e["parameters"] for e in pair["effects"]}
    return {
        "off_verdict": verdict(off),
        "off_formula": "`" + "; ".join(e.get("formula", "none") for e in off["effects"]) + "`",
        "off_amount": number(math.hypot(*amounts), 0) + " N",
        "off_true_amount": number(cogging["amplitude_N"], 0) + " N",
        "off_length": number(1e3 * float(length[1]), 4) + " mm" if length else "no wave",
        "off_true_length": number(1e3 * cogging["wavelength_m"], 4) + " mm",
        "off_errors": errors(phs, "off_list"),
        "pair_verdict": verdict(pair),
        "pair_gap": with_interval(found["backlash"]["gap_m"], 1e3, 4, "mm"),
        "pair_true_gap": number(1e3 * play["gap_m"], 4) + " mm",
        "pair_leak": with_interval(found["piston_leakage"]["conductance_m3_per_Pas"], 1e15, 3, "· 10⁻¹⁵ m³/(Pa s)"),
        "pair_true_leak": number(1e15 * leak["conductance"], 3) + " · 10⁻¹⁵",
        "pair_errors": errors(phs, "pair"),
    }

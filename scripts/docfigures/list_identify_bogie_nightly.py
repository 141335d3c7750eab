"""docs/identify_bogie.md: what is found in the record of the independent bogie, and in that of hollow wheels."""
from docfigures.form import number, table

DOCUMENT = "docs/identify_bogie.md"
ROWS = (("lateral position, lead / trail", ("lead_lateral_m", "trail_lateral_m"), 1e3, 2, "mm"),
        ("angle of attack, lead / trail", ("lead_angle_of_attack_rad", "trail_angle_of_attack_rad"),
         1e3, 2, "mrad"),
        ("cylinder force 1 / 3", ("load1_N", "load3_N"), 1e-3, 2, "kN"),
        ("Q, lead left / right", ("lead_left_Q_N", "lead_right_Q_N"), 1e-3, 2, "kN"))


def effect_words(effect):
    """Name and first number with its interval; a length in mm."""
    name, value = next(iter(effect["parameters"].items()))
    factor, unit, digits = (1e3, " mm", 2) if name.endswith("_m") else (1, "", 3)
    low, high = (number(factor * value[end], digits) for end in ("low", "high"))
    return f"`{effect['name']}` {number(factor * value['value'], digits)}{unit} [{low}, {high}]"


def figures(phs):
    r = phs.result("identify hidden_bogie", "result.json")
    worn = phs.result("identify bogie_worn", "result.json")

    def cell(names, which, factor, decimals, unit):
        return " / ".join(number(factor * r["channels"][n][which]["rmse"], decimals)
                          for n in names) + " " + unit

    return {
        "verdict": f"*{r['verdict'].replace('_', ' ')}*",
        "found": ", ".join(effect_words(e) for e in r["effects"]) or "nothing",
        "bic": ", ".join(number(e["evidence"]["delta_bic"]) for e in r["effects"]),
        "table": table(["validation, rms", "declared, fitted", "corrected"],
                       [[words, cell(names, "before", factor, decimals, unit),
                         cell(names, "after", factor, decimals, unit)]
                        for words, names, factor, decimals, unit in ROWS]),
        "worn_verdict": f"*{worn['verdict'].replace('_', ' ')}*",
        "worn_found": ", ".join(effect_words(e) for e in worn["effects"]) or "nothing",
        "worn_bic": ", ".join(number(e["evidence"]["delta_bic"]) for e in worn["effects"]),
    }

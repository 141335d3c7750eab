"""docs/identify_bogie.md: hollow wheels found in a measured curve."""
from docfigures.form import number, table

DOCUMENT = "docs/identify_bogie.md"
ROWS = (("lateral position, lead / trail", ("lead_lateral_m", "trail_lateral_m"), 1e3, 2, "mm"),
        ("angle of attack, lead / trail", ("lead_angle_of_attack_rad", "trail_angle_of_attack_rad"),
         1e3, 2, "mrad"),
        ("cylinder force 1 / 3", ("load1_N", "load3_N"), 1e-3, 2, "kN"),
        ("pressure L2 / L3", ("pL2_Pa", "pL3_Pa"), 1e-6, 2, "MPa"),
        ("Y, lead left / right", ("lead_left_Y_N", "lead_right_Y_N"), 1e-3, 2, "kN"))


def figures(phs):
    r = phs.result("identify models/rigs/bogie_worn.yaml", "result.json")

    def cell(names, which, factor, decimals, unit):
        return " / ".join(number(factor * r["channels"][n][which]["rmse"], decimals)
                          for n in names) + " " + unit

    first = r["effects"][0]
    name, value = next(iter(first["parameters"].items()))
    scale = r["fitted"]["friction.scale"]
    return {
        "found": (f"`{first['name']}` {number(1e3 * value['value'], 3)} mm "
                  f"[{number(1e3 * value['low'], 3)}, {number(1e3 * value['high'], 3)}]"
                  if name.endswith("_m") else f"`{first['name']}`"),
        "bic": number(first["evidence"]["delta_bic"]),
        "gain": number(100 * first["evidence"]["estimation_gain"]) + " %",
        "count": number(len(r["effects"])),
        "table": table(["validation (the other curve), rms", "declared, fitted", "corrected"],
                       [[words, cell(names, "before", factor, decimals, unit),
                         cell(names, "after", factor, decimals, unit)]
                        for words, names, factor, decimals, unit in ROWS]),
        "scale": f"{number(scale['value'], 2)} [{number(scale['low'], 2)}, {number(scale['high'], 2)}]",
    }

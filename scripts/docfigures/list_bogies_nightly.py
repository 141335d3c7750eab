"""docs/bogies.md: every steering principle over the radius."""
from docfigures.form import attack, number, table

DOCUMENT = "docs/bogies.md"
PART = "curves."
RADII = (150, 250, 300, 400, 550, 800)
TABLE = "compare curve_r550 --bogies all --radii " + ",".join(map(str, RADII))


def over_radius(rows, cell):
    names = list(dict.fromkeys(row["bogie"] for row in rows))
    by = {(row["bogie"], round(row["radius_m"])): row for row in rows}

    def text(name, radius):
        row = by.get((name, radius))
        if row is None or row["status"] != "ok":
            return "–" if row is None else row["status"]
        return cell(row)

    return table(["bogie"] + [f"{r} m" for r in RADII],
                 [[f"`{name}`"] + [text(name, radius) for radius in RADII] for name in names])


def figures(phs):
    all_rows = phs(TABLE, codes=(0, 1))["rows"]
    return {
        "attack": over_radius(all_rows, lambda r: attack(r["angle_of_attack_lead_rad"])),
        "wear": over_radius(all_rows, lambda r: number(r["wear_yardstick_over_own_run"], 1)),
        "sum_Y": over_radius(all_rows, lambda r: number(r["sum_Y_lead_N"] / 1e3, 1)),
        "max_sum_Y": over_radius(all_rows, lambda r: number(r["max_sum_Y_N"] / 1e3)),
        "T_gamma": over_radius(all_rows, lambda r: number(r["T_gamma_N"])),
    }

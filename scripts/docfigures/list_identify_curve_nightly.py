"""docs/identify_bogie.md: steady curving of an independent multibody program beside ours."""
import csv
import io

from docfigures.form import number, table

DOCUMENT = "docs/identify_bogie.md"
PART = "curve."
STEADY = (340.0, 440.0)  # of the leading axle [m]: where `phs simulate curve_r550` takes its means


def independent(phs):
    """Means of its channels over the steady curve."""
    program = phs.program.parents[2] / "tests/rigdata/bogie_curve/generate_bogie_curve"
    text = phs.shell(f"{program} --curve r550 --profiles models/profiles --exact --out /dev/stdout")
    rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(io.StringIO(text))]
    rows = [row for row in rows if STEADY[0] <= row["s_m"] <= STEADY[1]]
    return {name: sum(row[name] for row in rows) / len(rows) for name in rows[0]}


def ours(phs):
    steady = phs.result("simulate measured_r550", "summary.json")["steady_curve"]
    out = {}
    for axle in steady["wheelsets"]:
        out[axle["name"] + "_lateral_m"] = axle["lateral_m"]
        out[axle["name"] + "_angle_of_attack_rad"] = axle["angle_of_attack_rad"]
    for cylinder in steady["cylinders"]:
        out[f"piston{cylinder['name']}_m"] = cylinder["piston_m"]
        out[f"load{cylinder['name']}_N"] = cylinder["force_N"]
    for line in steady["lines"]:
        out[f"p{line['name']}_Pa"] = line["pressure_Pa"]
    for wheel in steady["wheels"]:
        if wheel["name"].startswith("lead"):
            out[f"lead_{wheel['side']}_Y_N"] = wheel["Y_N"]
            out[f"lead_{wheel['side']}_Q_N"] = wheel["Q_N"]
    return out


ROWS = (("angle of attack, lead / trail", ("lead_angle_of_attack_rad", "trail_angle_of_attack_rad"), 1e3, 2, "mrad"),
        ("lateral position, lead / trail", ("lead_lateral_m", "trail_lateral_m"), 1e3, 2, "mm"),
        ("piston 1 / 3", ("piston1_m", "piston3_m"), 1e3, 3, "mm"),
        ("pressure L2 / L3", ("pL2_Pa", "pL3_Pa"), 1e-6, 3, "MPa"),
        ("cylinder force 1 / 3", ("load1_N", "load3_N"), 1e-3, 2, "kN"),
        ("Y, lead left / right", ("lead_left_Y_N", "lead_right_Y_N"), 1e-3, 2, "kN"),
        ("Q, lead left / right", ("lead_left_Q_N", "lead_right_Q_N"), 1e-3, 1, "kN"))


def figures(phs):
    theirs, mine = independent(phs), ours(phs)

    def cell(of, names, factor, decimals, unit):
        return " / ".join(number(factor * of[n], decimals) for n in names) + " " + unit

    return {"table": table(["steady curve, R = 550 m, 80 km/h", "independent program", "`phs simulate`"],
                           [[words, cell(theirs, names, factor, decimals, unit),
                             cell(mine, names, factor, decimals, unit)]
                            for words, names, factor, decimals, unit in ROWS])}

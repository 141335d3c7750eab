"""docs/oil_temperature.md: a day from −20 to 50 °C, loads held, other fillings."""
from docfigures.form import named, number, short, table

DOCUMENT = "docs/oil_temperature.md"
PART = "day."
WORDS = {"quarter_setup1": "1: oil on the gas side", "quarter_setup2": "2: atmospheric",
         "quarter_setup3": "3: 0.5 MPa", "quarter_setup4": "4: 1 MPa",
         "bo_bo_measured": "2 as measured"}


def cell(curve, hour, factor, decimals):
    for at, value in zip(curve["x"], curve["y"]):
        if at == hour:
            return number(factor * value, decimals)
    return "–"


def hours(part, y, factor, decimals):
    plot = next(p for p in part["plots"] if p["y"] == y)
    at = sorted({h for curve in plot["curves"] for h in curve["x"]})
    return table(["reservoir"] + [f"{h:.0f} h" for h in at],
                 [[WORDS[c["label"]]] + [cell(c, h, factor, decimals) for h in at]
                  for c in plot["curves"]])


def temperature(curve):
    """The same for all reservoirs: each hour once."""
    by = dict(zip(curve["x"], curve["y"]))
    return table(["", *(f"{h:.0f} h" for h in by)],
                 [["oil and gas [°C]", *(number(T - 273.15) for T in by.values())]])


def factor(group):
    if group["lacking"]:
        return "–"
    return short(group["factor"])


def spread_cells(spread):
    return {g["name"]: factor(g) for g in spread["groups"]}


def fillings(part):
    rest, loads = (spread_cells(s) for s in part["spreads"])
    rows = []
    for name in rest:
        setup, pressure = name.split(", ")
        rows.append([WORDS[setup], number(float(pressure) / 1e6, 1), rest[name], loads[name]])
    return table(["reservoir", "bore lines filled to [MPa absolute]", "at rest",
                  "at rest and under steering, traction, braking"], rows)


def figures(phs):
    study = phs.result("study temperature_day", "study.json")
    day, loads, filled = (named(study["parts"], n) for n in ("day", "loads", "fillings"))
    by_day, by_load = spread_cells(day["spreads"][0]), spread_cells(loads["spreads"][0])
    kept = filled["spreads"]
    return {
        "temperature": temperature(day["plots"][0]["curves"][0]),
        "shear": hours(day, "shear_stiffness_Nm_per_rad", 1e-6, 1),
        "bore": hours(loads, "L2_pressure_Pa", 1e-6, 2),
        "least": hours(loads, "traction_electric_braking_least_pressure_Pa", 1e-6, 2),
        "traction": hours(loads, "traction_electric_braking_shear_stiffness_Nm_per_rad", 1e-6, 1),
        "factors": table(["reservoir", "over the day, 2 mm", "over the day and all three loads"],
                         [[WORDS[n], by_day[n], by_load[n]] for n in by_day]),
        "fillings": fillings(filled),
        "kept_rest": f"{kept[0]['kept']} of {len(kept[0]['groups'])}",
        "kept_loads": f"{kept[1]['kept']} of {len(kept[1]['groups'])}",
    }

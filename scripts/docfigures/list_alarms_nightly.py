"""docs/failures.md: the alarm for a lost hose."""
import math

from docfigures.form import number, short, table

DOCUMENT = "docs/failures.md"
PART = "alarms."
SERVICES = {"line_coasting": "coasting, 20 °C", "line_traction": "traction, 20 °C",
            "line_coasting_cold": "coasting, −20 °C",
            "line_coasting_damped": "coasting, 20 °C", "line_traction_damped": "traction that goes, 20 °C",
            "line_coasting_cold_damped": "coasting, −20 °C"}


def signal(hose):
    a, b = hose["first"], hose["second"]
    text = {"sum": f"{a} + {b}", "difference": f"{a} − {b}", "ratio": f"ln({a}/{b})",
            "product": f"ln({a} {b}/MPa²)", "product over rest": f"ln({a} {b}/rest²)"}[hose["form"]]
    return text + (" less its mean" if hose["against_mean"] else "")


def threshold(hose):
    size = hose["threshold"] * (1e-6 if hose["unit"] == "Pa" else 1)
    return f"{hose['alarm']} {short(size, 3)}" + (" MPa" if hose["unit"] == "Pa" else "")


def safety(of):
    # A wheel that lifts has no Y/Q.
    ratio = number(of["Y_over_Q"], 2) if of["unloading"] < 1 else "–"
    return (f"{ratio}, {number(of['sum_Y_N'] / 1e3)} kN, "
            f"{number(100 * of['unloading'])} %")


def hoses(made):
    rows = [[h["name"], signal(h), threshold(h),
             f"{short(h['mean_seconds_to_alarm'])}, {short(h['largest_seconds_to_alarm'])}",
             short(h["margin"]), f"{h['alarmed']} of {h['runs']}", f"{h['named_by_lowest_pressure']} of {h['runs']}",
             safety(h["until_alarm"]), safety(h["before_burst"])] for h in made["hoses"]]
    return table(["hose", "signal", "alarm", "seconds: mean, slowest", "margin", "alarms",
                  "lowest line is the hose", "until the alarm: Y/Q, ΣY, unloading",
                  "before the burst"], rows)


def false_alarms(found):
    rows = [[SERVICES[s["name"]], number(s["distance_km"]), s["count"],
             short(s["upper_per_1000_km"])] for s in found["services"]]
    rows.append(["all", number(found["distance_km"]), found["count"],
                 short(found["upper_per_1000_km"])])
    return table(["service", "distance [km]", "false alarms", "at most in 1000 km (95 %)"], rows)


def told(phs, study):
    made = phs.result(f"study {study}", "alarms/alarms.json", codes=(0, 1))
    found = made["false_alarms"]
    needed = -math.log(0.05) / made["wanted_per_1000_km"] * 1e3
    alarmed, runs = (sum(h[key] for h in made["hoses"]) for key in ("alarmed", "runs"))
    return {"hoses": hoses(made), "false": false_alarms(found),
            "told": f"{alarmed} of {runs}",
            "wanted": short(made["wanted_per_1000_km"]), "needed": number(needed) + " km",
            "slowest": short(max(h["largest_seconds_to_alarm"] or math.inf
                                 for h in made["hoses"])) + " s"}


def figures(phs):
    return told(phs, "alarms")

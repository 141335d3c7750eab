"""docs/dampers.md: throttles at the chambers and yaw dampers of the PHS locomotive."""
import csv
import io

from docfigures.cases import SPEED_km_h
from docfigures.form import kmh, number, table, wheelset

DOCUMENT = "docs/dampers.md"
UNDAMPED_km_h = (80, 120)
ALL_SPEEDS = "from: 40, to: 120, count: 17"
RADII = (300, 550, 800)
LIMIT_N = 2000


def rows(phs, text):
    """Rows of the table of a study given as text."""
    found = phs.result_text(f"sweep {phs.file(text)}", "sweep.csv", codes=(0, 1))
    lines = (line for line in io.StringIO(found) if not line.startswith("#"))
    return list(csv.DictReader(lines))


def study(phs, name):
    return (phs.source / "models/sweeps" / (name + ".yaml")).read_text()


def linear(phs):
    by = {}
    for row in rows(phs, study(phs, "dampers_linear")):
        yaw = next(float(v) for k, v in row.items() if k.endswith("damping"))
        by.setdefault(float(row["laminar_Pas_per_m3"]), {})[yaw] = float(row["stable_up_to_m_s"])
    yaws = sorted(next(iter(by.values())))
    head = ["laminar resistance [Pa s/m³]"]
    head += [f"yaw damping {number(y / 1e3)} kN m s/rad" for y in yaws]
    return table(head, [[f"{r:.0e}"] + [kmh(of[y]) for y in yaws] for r, of in by.items()])


def at_speed(phs, speed):
    text = study(phs, "dampers_bump")
    assert text.count(ALL_SPEEDS) == 1
    return text.replace(ALL_SPEEDS, f"values: [{speed}]")


def left(row):
    return float(row["largest_rms_sum_Y_N"]) if row["status"] == "ok" else float("inf")


def bump(phs):
    by = {}
    for row in rows(phs, study(phs, "dampers_bump")):
        case = float(row["temperature_K"]), float(row["scale"])
        by.setdefault(case, []).append(left(row))
    head = ["oil", "seal friction", "largest rms of the sum of Y", "speeds run"]
    lines = []
    for (T, scale), of in sorted(by.items()):
        lines.append([f"{T - 273.15:.0f} °C".replace("-", "−"), f"× {scale:g}",
                      number(max(of) / 1e3, 2) + " kN", number(len(of))])
    worst = max(x for of in by.values() for x in of)
    return table(head, lines), "holds at every speed" if worst < LIMIT_N else "fails"


def undamped(phs):
    """The same bump without any damper, at 20 °C, seals as measured."""
    said = []
    for speed in UNDAMPED_km_h:
        text = at_speed(phs, speed)
        text = text.replace("[253.15, 293.15, 323.15]", "[293.15]").replace("[0.5, 1, 2]", "[1]")
        text = text.replace("axes:\n", "axes:\n  - {key: scenario.bogie, values: [phs]}\n")
        said.append(f"{number(left(rows(phs, text)[0]) / 1e3, 1)} kN at {speed} km/h")
    return " and ".join(said)


def curve(phs, radius, step):
    scenario = {"track": f"curve_r{radius}", "vehicle": "locomotive", "bogie": "phs",
                "speed_km_h": SPEED_km_h[radius], "wheel": "S1002", "rail": "UIC60",
                "friction": 0.35, "creep": "kalker_table", "timestep_s": step}
    return phs(f"compare {phs.file(scenario)} --bogies phs,phs_damped")["bogies"]


def of_wheelset(run, name):
    w = wheelset(run, name)
    wear = sum(x["T_gamma_N"] for x in run["steady_curve"]["wheels"]
               if x["name"].startswith(name + "_"))
    return 1e3 * w["angle_of_attack_rad"], w["sum_Y_N"] / 1e3, wear


def curving(phs):
    lines, angle, force, wear, step_change = [], 0, 0, 0, 0
    for radius in RADII:
        whole, half = curve(phs, radius, 0.001), curve(phs, radius, 0.0005)
        for name in ("front_lead", "front_trail", "rear_lead", "rear_trail"):
            a, b = of_wheelset(whole["phs"], name), of_wheelset(whole["phs_damped"], name)
            for bogie in ("phs", "phs_damped"):
                x, y = of_wheelset(whole[bogie], name), of_wheelset(half[bogie], name)
                step_change = max(step_change, abs(x[2] / y[2] - 1), abs(x[1] / y[1] - 1))
            angle = max(angle, abs(b[0] - a[0]))
            force, wear = max(force, abs(b[1] / a[1] - 1)), max(wear, abs(b[2] / a[2] - 1))
            lines.append([f"{radius} m", name.replace("_", " ")] +
                         [f"{number(a[i], d)} / {number(b[i], d)}" for i, d in
                          ((0, 2), (1, 1), (2, 1))])
    head = ["R", "wheelset", "angle of attack [mrad]", "sum of Y [kN]", "T-gamma [N]"]
    return {"curving": table(head, lines), "angle": number(angle, 2) + " mrad",
            "force": number(100 * force) + " %", "wear": number(100 * wear) + " %",
            "step": number(100 * step_change, 1) + " %"}


def figures(phs):
    made = {"undamped": undamped(phs), "linear": linear(phs)} | curving(phs)
    made["bump"], made["verdict"] = bump(phs)
    return made

"""docs/dampers.md: throttles at the chambers and yaw dampers of the PHS locomotive."""
import csv
import io

from docfigures.cases import RAMPS, compare, curve, ramp_length, with_ramps
from docfigures.form import kmh, number, table, wheelset

DOCUMENT = "docs/dampers.md"
UNDAMPED_km_h = (80, 120)
ALL_SPEEDS = "from: 40, to: 120, count: 17"
RADII = (300, 550, 800)
WHEELSETS = ("front_lead", "front_trail", "rear_lead", "rear_trail")
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


def entered(phs, radius, scale, step):
    """Both locomotives in curve_rRADIUS behind transitions `scale` times as long."""
    track = with_ramps(phs, f"curve_r{radius}", scale)
    scenario = curve(radius, track=track, vehicle="locomotive", bogie="phs", timestep_s=step)
    return compare(phs, scenario, "phs,phs_damped")["bogies"]


def of_wheelset(run, name):
    """Angle of attack [mrad], sum of Y [kN], T-gamma [N]."""
    w = wheelset(run, name)
    wear = sum(x["T_gamma_N"] for x in run["steady_curve"]["wheels"]
               if x["name"].startswith(name + "_"))
    return 1e3 * w["angle_of_attack_rad"], w["sum_Y_N"] / 1e3, wear


def apart(a, b):
    """Largest differences over the wheelsets: angle [mrad], sum of Y and T-gamma [share of b]."""
    pairs = [(of_wheelset(a, name), of_wheelset(b, name)) for name in WHEELSETS]
    return [max(abs(x[0] - y[0]) for x, y in pairs)] + \
           [max(abs(x[i] / y[i] - 1) for x, y in pairs) for i in (1, 2)]


def in_words(differences):
    angle, force, wear = differences
    return [number(angle, 2) + " mrad", number(100 * force) + " %", number(100 * wear) + " %"]


def curving(phs):
    """Every wheelset behind the shipped ramps, and what half the step changes."""
    lines, worst, step_change = [], [0, 0, 0], 0
    for radius in RADII:
        whole, half = entered(phs, radius, 1, 0.001), entered(phs, radius, 1, 0.0005)
        for bogie in ("phs", "phs_damped"):
            step_change = max([step_change] + apart(whole[bogie], half[bogie])[1:])
        worst = [max(pair) for pair in zip(worst, apart(whole["phs_damped"], whole["phs"]))]
        for name in WHEELSETS:
            a, b = of_wheelset(whole["phs"], name), of_wheelset(whole["phs_damped"], name)
            lines.append([f"{radius} m", name.replace("_", " ")] +
                         [f"{number(a[i], d)} / {number(b[i], d)}" for i, d in
                          ((0, 2), (1, 1), (2, 1))])
    head = ["R", "wheelset", "angle of attack [mrad]", "sum of Y [kN]", "T-gamma [N]"]
    angle, force, wear = in_words(worst)
    return {"curving": table(head, lines), "angle": angle, "force": force, "wear": wear,
            "step": number(100 * step_change, 2) + " %"}


def left_in_seals(phs):
    """Friction [kN] that stays in cylinder 1 of the rear bogie at R = 800 m: undamped and damped."""
    runs = entered(phs, 800, 1, 0.001)
    return " and ".join(number(next(c["friction_N"] for c in runs[bogie]["steady_curve"]["cylinders"]
                                    if c["name"] == "rear_bogie_1") / 1e3, 1)
                        for bogie in ("phs", "phs_damped"))


def over_ramps(phs):
    """What the dampers change beside what the ramp changes on the undamped one."""
    lines, slow, own = [], [], 0
    for radius in RADII:
        runs = {scale: entered(phs, radius, scale, 0.001) for scale in RAMPS}
        for scale, of in runs.items():
            dampers, ramp = apart(of["phs_damped"], of["phs"]), apart(of["phs"], runs[1]["phs"])
            own = max(own, ramp[2])
            if scale >= 2:
                slow.append(dampers)
            lines.append([f"{radius} m", f"{scale * ramp_length(phs, f'curve_r{radius}'):g} m"] +
                         in_words(dampers) + in_words(ramp))
    head = ["R", "ramp", "by the dampers: angle", "sum of Y", "T-gamma",
            "by the ramp, undamped: angle", "sum of Y", "T-gamma"]
    worst = in_words([max(x) for x in zip(*slow)])
    return {"ramps": table(head, lines), "slow_angle": worst[0], "slow_force": worst[1],
            "slow_wear": worst[2], "own_wear": number(100 * own) + " %"}


def figures(phs):
    made = {"undamped": undamped(phs), "linear": linear(phs)} | curving(phs) | over_ramps(phs)
    made["seals"] = left_in_seals(phs)
    made["bump"], made["verdict"] = bump(phs)
    return made

"""docs/failures.md: what a failure does on straight track, in curves and under traction."""
from docfigures.cases import compare, curve
from docfigures.form import attack, number, t_gamma, table, wheelset

DOCUMENT = "docs/failures.md"


def burst(*lines):
    return [{"kind": "line_burst", "line": line, "at_s": 1} for line in lines]


FAILURES = (
    ("none", []),
    ("L1 bursts (cross line of the leading axle)", burst("L1")),
    ("L4 bursts (cross line of the trailing axle)", burst("L4")),
    ("L2 bursts (diagonal 1–3)", burst("L2")),
    ("L3 bursts (diagonal 2–4)", burst("L3")),
    ("all four burst", burst("L1", "L2", "L3", "L4")),
    ("L1 leaks at 1e-12", [{"kind": "line_leak", "line": "L1", "at_s": 0}]),
    ("L2 leaks at 1e-12", [{"kind": "line_leak", "line": "L2", "at_s": 0}]),
    ("gas of L1's reservoir lost", [{"kind": "reservoir_gas_lost", "line": "L1"}]),
    ("gas of L2's reservoir lost", [{"kind": "reservoir_gas_lost", "line": "L2"}]),
    ("accumulator of L1 without gas", [{"kind": "accumulator_gas_lost", "line": "L1"}]),
    ("20 ml of air in L2", [{"kind": "air", "line": "L2", "air_m3": 20e-6}]),
)


def run(phs, scenario, failures):
    if failures:
        scenario = dict(scenario, failures=failures)
    return compare(phs, scenario, "phs")["bogies"]["phs"]


def moved(steady):
    """How far each axle has moved forward in its bogie [m]: cylinders 1, 2 extend as the leading axle
    goes forward, 3, 4 as the trailing one goes back."""
    piston = [c["piston_m"] for c in steady["cylinders"]]
    return (piston[0] + piston[1]) / 2, -(piston[2] + piston[3]) / 2


def straight(phs):
    scenario = {"track": "straight", "speed_km_h": 72, "wheel": "S1002", "rail": "UIC60",
                "friction": 0.35, "creep": "kalker_table"}
    rows = []
    for words, failures in FAILURES:
        if failures and failures[0]["kind"] == "line_leak":
            continue
        steady = run(phs, scenario, failures)["steady_curve"]
        sets = [wheelset({"steady_curve": steady}, name) for name in ("lead", "trail")]
        rows.append([words, ", ".join(number(1e3 * x, 1) for x in moved(steady)),
                     ", ".join(number(1e3 * w["yaw_rad"], 1) for w in sets),
                     ", ".join(number(w["sum_Y_N"] / 1e3, 1) for w in sets)])
    return table(["failure", "lead x, trail x [mm]", "lead yaw, trail yaw [mrad]",
                  "ΣY lead, trail [kN]"], rows)


def curves(phs):
    rows, largest, track_shift = [], 0, 0
    for words, failures in FAILURES:
        cells = [words]
        for radius in (550, 300):
            done = run(phs, curve(radius), failures)
            sets = [wheelset(done, name) for name in ("lead", "trail")]
            cells += [attack(sets[0]["angle_of_attack_rad"]),
                      " / ".join(number(w["sum_Y_N"] / 1e3, 1) for w in sets),
                      number(t_gamma(done))]
            if failures:
                largest = max(largest, done["run"]["max_Y_over_Q"])
                track_shift = max(track_shift, done["run"]["max_sum_Y_N"])
        rows.append(cells)
    head = ["failure"] + [f"R {r} m, {v} km/h: {what}" for r, v in ((550, 80), (300, 55))
                          for what in ("angle of attack [mrad]", "ΣY lead / trail [kN]", "Tγ [N]")]
    return table(head, rows), number(largest, 2), number(track_shift / 1e3)


def pulling(phs):
    """A diagonal lost under hard traction."""
    done = phs("compare burst_L2_traction_r300 --bogies phs,rigid_link", codes=(0, 1))["bogies"]
    own, steady = done["phs"], done["phs"]["steady_curve"]
    worst = own["assessment"]["worst"]["Y_over_Q"]["value"]
    return {
        "pull_attack": number(1e3 * own["run"]["max_angle_of_attack_rad"], 1),
        "pull_steady": attack(wheelset(own)["angle_of_attack_rad"], 1, 1, " mrad"),
        "pull_Y_over_Q": number(own["run"]["max_Y_over_Q"], 2),
        "pull_Y_over_Q_2m": number(worst, 2),
        "pull_sum_Y": number(own["run"]["max_sum_Y_N"] / 1e3),
        "pull_piston": number(1e3 * max(abs(c["piston_m"]) for c in steady["cylinders"]), 1),
        "pull_force": number(max(abs(c["force_N"]) for c in steady["cylinders"]) / 1e3, 1),
        "pull_force_peak": number(max(abs(w.get("force_N", 0)) for w in own["warnings"]) / 1e3),
        "pull_line": number(min(line["pressure_Pa"] for line in steady["lines"])),
        "pull_rigid_attack": attack(wheelset(done["rigid_link"])["angle_of_attack_rad"], 1, 1, " mrad"),
        "pull_rigid_Y_over_Q": number(done["rigid_link"]["run"]["max_Y_over_Q"], 2),
    }


def figures(phs):
    out = {"straight": straight(phs)}
    out["curves"], out["Y_over_Q"], out["sum_Y"] = curves(phs)
    rigid = [compare(phs, curve(r), "rigid_link")["bogies"]["rigid_link"] for r in (550, 300)]
    out["rigid_Y_over_Q"] = number(max(r["run"]["max_Y_over_Q"] for r in rigid), 2)
    for scenario in ("load_traction", "load_braking"):
        done = phs(f"compare {scenario} --bogies phs")["bogies"]["phs"]["steady_curve"]
        force = [c["force_N"] / 1e3 for c in done["cylinders"]]
        pressure = [line["pressure_Pa"] / 1e6 for line in done["lines"]]
        out[scenario] = (f"{number(max(force), 1)} and {number(min(force), 1)} kN per cylinder, "
                         f"highest line {number(max(pressure), 1)} MPa")
    out.update(pulling(phs))
    return out

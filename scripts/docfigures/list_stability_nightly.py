"""docs/stability.md: critical speeds of bogies and locomotive."""
from docfigures.cases import compare
from docfigures.form import kmh, number, short, table

DOCUMENT = "docs/stability.md"
BOGIES = ("phs", "phs_declared", "rigid_link", "soft_link")


def speeds_of(phs, scenario):
    """In the portions in which README and bogies.md ask for them, so that the answers are shared."""
    speeds = {}
    portions = BOGIES if scenario == "curve_r550" else ("phs,rigid_link", "phs_declared", "soft_link")
    for bogies in portions:
        done = phs(f"compare {scenario} --bogies {bogies} --radii 550 --stability", codes=(0, 1))
        speeds.update(done["critical_speeds"])
    return speeds


def linear(of):
    return kmh(of["linear_m_s"]) if of["linear_m_s"] is not None else "stable"


def lives(of):
    if of["hunting"] == "dies":
        return f"{kmh(of['nonlinear_m_s'])} ({number(1e3 * of['amplitude_m'], 1)} mm)"
    return "below " + kmh(of["ramp_to_m_s"]) if of["hunting"] == "lives" else of["hunting"]


def rows_of(words, of):
    return [[f"{words}: linear"] + [linear(of[b]) for b in BOGIES],
            [f"{words}: non-linear critical speed"] + [lives(of[b]) for b in BOGIES]]


def rough(phs):
    """T-gamma over straight_rough beside rigid links, by speed."""
    words = []
    for speed in (50, 60, 70, 80):
        done = compare(phs, {"track": "straight_rough", "speed_km_h": speed, "wheel": "S1002",
                             "rail": "UIC60", "friction": 0.35, "creep": "kalker_table",
                             "timestep_s": 0.00025})
        own, rigid = done["bogies"]["phs"], done["bogies"]["rigid_link"]
        words.append(f"{short(own['run']['T_gamma_total_J'] / rigid['run']['T_gamma_total_J'])} "
                     f"times at {speed} km/h")
    return ", ".join(words), own, rigid


def figures(phs):
    rows = []
    for words, scenario in (("single bogie", "curve_r550"), ("locomotive", "locomotive_r550"),
                            ("locomotive with yaw dampers", "locomotive_yaw_dampers")):
        rows += rows_of(words, speeds_of(phs, scenario))
    out = {"critical": table(["km/h", "PHS", "PHS, as declared", "rigid link", "soft link"], rows)}
    out["rough"], own, rigid = rough(phs)
    out["rough_Y_over_Q"] = number(own["run"]["max_Y_over_Q"], 2)
    out["rough_Y_over_Q_2m"] = number(own["assessment"]["worst"]["Y_over_Q"]["value"], 2)
    out["rough_Y_over_Q_2m_rigid"] = number(rigid["assessment"]["worst"]["Y_over_Q"]["value"], 2)
    cycle = phs("stability --bogie cooperrider --from 50 --to 90 --speeds 9")
    out["cooperrider"] = f"{number(cycle['critical_speed_m_s'], 2)} m/s"
    return out

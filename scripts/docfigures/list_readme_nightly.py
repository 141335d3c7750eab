"""README.md: wear on rough track and of the locomotive; running straight."""
from docfigures.cases import compare, curve, factor, track_text
from docfigures.draws import band, draws
from docfigures.form import kmh, number, short

DOCUMENT = "README.md"

SCENARIOS = {"rough": "curve_r550_rough", "pull_rough": "traction_r550_rough",
             "loco_smooth": "locomotive_r550", "loco_rough": "locomotive_r550_rough",
             "loco_pull": "locomotive_traction_r550",
             "loco_pull_rough": "locomotive_traction_r550_rough",
             "loco_dampers": "locomotive_yaw_dampers"}


def lives_from(speeds):
    """Non-linear critical speed, in words [km/h]."""
    if speeds["hunting"] == "dies":
        return kmh(speeds["nonlinear_m_s"])
    if speeds["hunting"] == "lives":
        return "below " + kmh(speeds["ramp_to_m_s"])
    return speeds["hunting"]


def factor_band(phs):
    """Steering factor by T-gamma with the measured hydraulics: 2.5 to 97.5 % of the draws."""
    rigid = phs("compare curve_r550 --bogies phs,rigid_link")["bogies"]["rigid_link"]
    key = "run.T_gamma_total_J"
    return band([rigid["run"]["T_gamma_total_J"] / drawn[key]
                 for drawn in draws(phs, "curve_r550", [key])], joint=" to ")


def over_seeds(phs, **changes):
    """Range of the steering factor by T-gamma over eight draws of the irregularity."""
    text = track_text(phs, "curve_r550_rough")
    assert text.count("seed: 1,") == 1
    found = [factor(compare(phs, curve(550, track=phs.file(text.replace("seed: 1,", f"seed: {seed},")),
                                       timestep_s=0.0005, **changes)), "phs") for seed in range(1, 9)]
    return f"{short(min(found))} to {short(max(found))}"


def figures(phs):
    out = {"band": factor_band(phs), "seeds": over_seeds(phs), "loco_seeds": over_seeds(phs, vehicle="locomotive")}
    for name, scenario in SCENARIOS.items():
        ratio = phs(f"compare {scenario} --bogies phs,rigid_link")["ratios"]["rigid_link_over_phs"]
        out["T_" + name] = short(ratio["run"]["T_gamma_total_J"])
        out["W_" + name] = short(ratio["run"]["lost_creep_J"])
    for name, scenario in (("plain", "locomotive_r550"), ("damped", "locomotive_yaw_dampers")):
        speeds = phs(f"compare {scenario} --bogies phs,rigid_link --radii 550 --stability")
        for bogie, of in speeds["critical_speeds"].items():
            out[f"linear_{name}_{bogie}"] = number(3.6 * of["linear_m_s"]) \
                if of["linear_m_s"] is not None else "stable"
            out[f"hunts_{name}_{bogie}"] = lives_from(of)
    return out

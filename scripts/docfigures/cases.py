"""Scenarios that documents vary: a curve of the family curve_rRADIUS with some keys changed."""
import re

SPEED_km_h = {150: 40, 250: 50, 300: 55, 400: 65, 550: 80, 800: 80, 1200: 80, 2000: 80, 4000: 80}
RAMPS = (0.75, 1, 1.5, 2, 3)


def curve(radius_m, **changes):
    """Dry rail 0.35, S1002 on UIC60, speed of that curve; `changes`: keys of a scenario file."""
    scenario = {"track": f"curve_r{radius_m}", "speed_km_h": SPEED_km_h[radius_m], "wheel": "S1002",
                "rail": "UIC60", "friction": 0.35, "creep": "kalker_table"}
    scenario.update(changes)
    return scenario


def track_text(phs, track):
    return (phs.source / f"models/tracks/{track}.yaml").read_text()


def with_ramps(phs, track, scale):
    """Path of a shipped track with both transitions (and with them its cant ramps) `scale` times as long."""
    text, changed = re.subn(r"(kind: transition, length_m: )([0-9.]+)",
                            lambda m: f"{m[1]}{scale * float(m[2]):g}", track_text(phs, track))
    assert changed == 2
    return phs.file(text)


def ramp_length(phs, track):
    """Length of the first transition [m]."""
    return float(re.search(r"kind: transition, length_m: ([0-9.]+)", track_text(phs, track))[1])


def compare(phs, scenario, bogies="phs,rigid_link"):
    """compare.json of a scenario given as data; a run that derails is no failure of the command."""
    return phs(f"compare {phs.file(scenario)} --bogies {bogies}", codes=(0, 1))


def run_wear(result, bogie):
    """T-gamma over the run [J]; None for a run that did not end well."""
    run = result["bogies"][bogie]
    return run["run"]["T_gamma_total_J"] if run["status"] == "ok" else None


def factor(result, own, other="rigid_link"):
    """Wear of the yardstick over that of `own`, over the run."""
    a, b = run_wear(result, other), run_wear(result, own)
    return a / b if a is not None and b else None


def over_ramps(phs, radius_m, bogies, rough=False, **changes):
    """{scale: compare.json} of curve_rRADIUS entered over shorter and longer transitions.

    Rough track needs all of its length for its irregularity: no shorter ones."""
    track = f"curve_r{radius_m}" + ("_rough" if rough else "")
    return {scale: compare(phs, curve(radius_m, track=with_ramps(phs, track, scale), **changes), bogies)
            for scale in RAMPS if scale >= 1 or not rough}


def hunts(run):
    """Largest sum of Y of the run above 40 kN and three times any steady one."""
    steady = max(abs(w["sum_Y_N"]) for w in run["steady_curve"]["wheelsets"])
    return run["run"]["max_sum_Y_N"] > max(40e3, 3 * steady)

"""Scenarios that documents vary: a curve of the family curve_rRADIUS with some keys changed."""

SPEED_km_h = {150: 40, 250: 50, 300: 55, 400: 65, 550: 80, 800: 80, 1200: 80, 2000: 80, 4000: 80}


def curve(radius_m, **changes):
    """Dry rail 0.35, S1002 on UIC60, speed of that curve; `changes`: keys of a scenario file."""
    scenario = {"track": f"curve_r{radius_m}", "speed_km_h": SPEED_km_h[radius_m], "wheel": "S1002",
                "rail": "UIC60", "friction": 0.35, "creep": "kalker_table"}
    scenario.update(changes)
    return scenario


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


def hunts(run):
    """Largest sum of Y of the run above 40 kN and three times any steady one."""
    steady = max(abs(w["sum_Y_N"]) for w in run["steady_curve"]["wheelsets"])
    return run["run"]["max_sum_Y_N"] > max(40e3, 3 * steady)

"""docs/curving.md: the steady state found directly beside the run in time."""
from docfigures.cases import factor, over_ramps, ramp_length
from docfigures.form import attack, number, percent, short, t_gamma, table, wheelset

DOCUMENT = "docs/curving.md"
BOGIES = ("rigid_link", "phs")
NAMES = {"rigid_link": "rigid link", "phs": "PHS"}


def friction(steady, name):
    for cylinder in steady["cylinders"]:
        if cylinder["name"] == name:
            return cylinder["friction_N"]
    return None


def entered(phs):
    """The same steady curve of R 550 m, entered over ramps of several lengths."""
    smooth = over_ramps(phs, 550, "phs,rigid_link", timestep_s=0.00125)
    rough = over_ramps(phs, 550, "phs,rigid_link", rough=True, timestep_s=0.0005)
    rows, wear, angles = [], [], []
    factors = [factor(result, "phs") for result in rough.values()]
    for scale, result in smooth.items():
        own = result["bogies"]["phs"]
        wear.append(t_gamma(own))
        angles.append(wheelset(own)["angle_of_attack_rad"])
        on_rough = factor(rough[scale], "phs") if scale in rough else None
        rows.append([f"{scale * ramp_length(phs, 'curve_r550'):g}", attack(angles[-1]),
                     number(friction(own["steady_curve"], "1") / 1e3, 2) + " / " +
                     number(friction(own["steady_curve"], "2") / 1e3, 2),
                     number(wear[-1], 1), number(t_gamma(result["bogies"]["rigid_link"]), 1),
                     short(factor(result, "phs")), short(on_rough)])
    head = ["ramp [m]", "angle of attack, leading axle [mrad]", "seal friction, cylinders 1 / 2 [kN]",
            "T-gamma, PHS [N]", "rigid link [N]", "rigid / PHS over the run", "on rough track"]
    return {"ramps": table(head, rows),
            "ramps_wear": f"{number(min(wear))} to {number(max(wear))} N",
            "ramps_angle": number(1e3 * (max(angles) - min(angles)), 2) + " mrad",
            "ramps_rough": f"{short(min(factors))} to {short(max(factors))}"}


def figures(phs):
    runs = phs("curving --bogies phs,rigid_link --radii 300,550 --time-run")["bogies"]
    rows = [[NAMES[name]] +
            [percent(row["time_run"]["largest_difference"], 2) for row in runs[name]]
            for name in BOGIES]
    out = {"against_time": table(["", "R = 300 m", "R = 550 m"], rows)}
    for radius, row in ((300, runs["phs"][0]), (550, runs["phs"][1])):
        direct, timed = row["steady_curve"], row["time_run"]["steady_curve"]
        out[f"attack_{radius}"] = (attack(wheelset({"steady_curve": direct})["angle_of_attack_rad"],
                                          3, 1, " mrad") + " directly, " +
                                   attack(wheelset({"steady_curve": timed})["angle_of_attack_rad"],
                                          3, 1, " mrad") + " in time")
        out[f"wear_{radius}"] = (number(t_gamma({"steady_curve": direct})) + " N directly, " +
                                 number(t_gamma({"steady_curve": timed})) + " N in time")
        for name, steady in (("direct", direct), ("timed", timed)):
            out[f"friction_{name}_{radius}"] = " and ".join(
                number(friction(steady, cylinder) / 1e3, 1) + " kN" for cylinder in ("1", "2"))
    return out | entered(phs)

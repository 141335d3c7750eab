"""docs/curving.md: the steady state found directly beside the run in time."""
from docfigures.form import attack, number, percent, t_gamma, table, wheelset

DOCUMENT = "docs/curving.md"
BOGIES = ("rigid_link", "phs")
NAMES = {"rigid_link": "rigid link", "phs": "PHS"}


def friction(steady, name):
    for cylinder in steady["cylinders"]:
        if cylinder["name"] == name:
            return cylinder["friction_N"]
    return None


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
    return out

"""docs/traction.md: does the PHS still steer under traction?"""
from docfigures.cases import compare, curve, factor, hunts
from docfigures.form import attack, short, table, wheelset

DOCUMENT = "docs/traction.md"
CASES = (("no traction, µ 0.45", "0", 0, 0.45), ("0.25, µ 0.45", "56 %", 39850, 0.45),
         ("0.25, µ 0.35", "71 %", 39850, 0.35), ("0.40, µ 0.56", "71 %", 63760, 0.56),
         ("0.40, µ 0.50", "80 %", 63760, 0.50))
BOGIES = ("phs", "rigid_link", "emd_radial")


def of_radius(phs, radius):
    rows = []
    for words, budget, torque, mu in CASES:
        scenario = curve(radius, friction=mu)
        if torque:
            scenario["running"] = {"drive_torque_Nm": torque, "begin_s": 1, "ramp_s": 3}
        done = compare(phs, scenario, ",".join(BOGIES))
        cells = []
        for bogie in BOGIES:
            run = done["bogies"][bogie]
            if run["status"] != "ok":
                cells.append(run["status"])
                continue
            cells.append(attack(wheelset(run)["angle_of_attack_rad"]) +
                         (" (hunts)" if hunts(run) else ""))
        rows.append([words, budget] + cells + [short(factor(done, "phs")),
                                               short(factor(done, "emd_radial"))])
    return table(["tractive force over wheel load", "budget", "angle of attack, PHS [mrad]", "rigid",
                  "EMD", "Tγ run, rigid / PHS", "rigid / EMD"], rows)


def figures(phs):
    blocks = phs("compare braking_r300 --bogies phs")["bogies"]["phs"]
    return {"r300": of_radius(phs, 300), "r550": of_radius(phs, 550),
            "blocks": attack(wheelset(blocks)["angle_of_attack_rad"], 2, 1, " mrad")}

"""docs/steering_claims.md: what the PHS gives over radius, and what it depends on."""
from docfigures.cases import compare, curve, factor, hunts
from docfigures.form import attack, number, short, t_gamma, table, wheelset

DOCUMENT = "docs/steering_claims.md"
RADII = (150, 250, 300, 400, 550, 800)
WIDE = RADII + (1200, 2000, 4000)


def angle(run):
    return attack(wheelset(run)["angle_of_attack_rad"]) + (" (hunts)" if hunts(run) else "")


def over_radius(phs):
    rows = []
    for radius in RADII:
        done = compare(phs, curve(radius))
        own, rigid = done["bogies"]["phs"], done["bogies"]["rigid_link"]
        rows.append([radius, angle(own) + " / " + angle(rigid), short(factor(done, "phs")),
                     number(wheelset(own)["sum_Y_N"] / 1e3, 1) + " / " +
                     number(wheelset(rigid)["sum_Y_N"] / 1e3, 1)])
    return table(["R [m]", "angle of attack, PHS / rigid [mrad]", "Tγ run, rigid / PHS",
                  "ΣY leading axle, PHS / rigid [kN]"], rows)


HYDRAULICS = {"smooth, single bogie": "curve_r550", "smooth, locomotive": "locomotive_r550",
              "rough, single bogie": "curve_r550_rough", "rough, locomotive": "locomotive_r550_rough",
              "traction 0.25, single bogie": "traction_r550",
              "traction 0.25, locomotive": "locomotive_traction_r550"}


def hydraulics(phs):
    """Wear of the rigid bogie over that of the PHS, hydraulics as measured and as declared."""
    rows = []
    for words, scenario in HYDRAULICS.items():
        runs = dict(phs(f"compare {scenario} --bogies phs,rigid_link")["bogies"])
        runs.update(phs(f"compare {scenario} --bogies phs_declared")["bogies"])
        rows.append([words] + [short(runs["rigid_link"]["run"][what] / runs[own]["run"][what])
                               for what in ("T_gamma_total_J", "lost_creep_J")
                               for own in ("phs", "phs_declared")])
    return table(["R = 550 m, rigid / PHS", "T-gamma, as measured", "as declared",
                  "creep work with spin, as measured", "as declared"], rows)


def seal_friction(phs):
    rows = []
    for radius in WIDE:
        runs = [compare(phs, curve(radius, phs_parameters={"friction.scale": scale}), "phs")
                ["bogies"]["phs"] for scale in (0, 1, 2)]
        rigid = compare(phs, curve(radius))["bogies"]["rigid_link"]
        rows.append([radius, " / ".join(angle(run) for run in runs),
                     " / ".join(number(t_gamma(run)) for run in runs), number(t_gamma(rigid))])
    return table(["R [m]", "angle of attack, scale 0 / 1 / 2 [mrad]", "Tγ steady, scale 0 / 1 / 2 [N]",
                  "rigid bogie [N]"], rows)


def joints(name, value):
    return {f"{axle}_{name}": value for axle in ("lead", "trail")}


def varied(phs):
    def row(words, changes, both=True):
        """`both`: the rigid bogie is changed as well; its links are no springs in shear."""
        cells = []
        for radius in (300, 550):
            done = compare(phs, curve(radius, **changes), "phs")
            done["bogies"].update(compare(phs, curve(radius, **(changes if both else {})),
                                          "rigid_link")["bogies"])
            cells.append(angle(done["bogies"]["phs"]) + "; " + short(factor(done, "phs")))
        return [words] + cells

    rows = [row("as it ships", {})]
    for k in (3, 6, 24):
        rows.append(row(f"lateral stiffness of the primary {k} instead of 12 MN/m per axle",
                        {"joints": joints("y", {"stiffness": k * 1e6})}))
    for words, times in (("half", 0.5), ("double", 2), ("four times", 4)):
        changes = dict(joints("x", {"stiffness": times * 2.0e6}))
        changes.update(joints("yaw", {"stiffness": times * 1.62e6}))
        rows.append(row(f"springs in shear (longitudinal and yaw) {words}", {"joints": changes},
                        both=False))
    rows.append(row("friction of the rail 0.45", {"friction": 0.45}))
    return table(["varied", "R = 300 m: angle of attack [mrad]; Tγ run, rigid / PHS", "R = 550 m"], rows)


def deficiency(phs):
    words = []
    for speed in (50, 65, 80, 95):
        done = compare(phs, curve(550, speed_km_h=speed))
        words.append(f"{speed} km/h: {angle(done['bogies']['phs'])} mrad, "
                     f"{short(factor(done, 'phs'))} times less wear than rigid")
    return "; ".join(words)


def cones(phs):
    words = []
    for wheel, name in (("cone:0.05", "1:20"), ("cone:0.1", "1:10"), ("S1002", "S1002")):
        done = compare(phs, curve(550, wheel=wheel), "phs")["bogies"]["phs"]
        words.append(f"{number(done['run']['T_gamma_total_J'] / 1e3)} kJ ({name})"
                     if done["status"] == "ok" else f"{done['status']} ({name})")
    return ", ".join(words)


def figures(phs):
    return {"over_radius": over_radius(phs), "hydraulics": hydraulics(phs),
            "seal_friction": seal_friction(phs), "varied": varied(phs), "deficiency": deficiency(phs), "cones": cones(phs)}

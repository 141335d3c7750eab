"""docs/steering_claims.md: what the PHS gives over radius, and what it depends on."""
from docfigures.cases import compare, curve, factor, hunts
from docfigures.draws import band, draws, limits, once
from docfigures.form import attack, number, short, t_gamma, table, wheelset

DOCUMENT = "docs/steering_claims.md"
RADII = (150, 250, 300, 400, 550, 800)
WIDE = RADII + (1200, 2000, 4000)


def angle(run, unit=""):
    return attack(wheelset(run)["angle_of_attack_rad"], unit=unit) + (" (hunts)" if hunts(run) else "")


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


WEAR = ("T_gamma_total_J", "lost_creep_J")


def hydraulics(phs):
    """Wear of the rigid bogie over that of the PHS, hydraulics as measured and as declared."""
    rows = []
    for words, scenario in HYDRAULICS.items():
        runs = dict(phs(f"compare {scenario} --bogies phs,rigid_link")["bogies"])
        runs.update(phs(f"compare {scenario} --bogies phs_declared")["bogies"])
        drawn = draws(phs, scenario, ["run." + what for what in WEAR])
        row = [words]
        for what in WEAR:
            rigid = runs["rigid_link"]["run"][what]
            low, high = limits([rigid / d["run." + what] for d in drawn])
            row += [short(rigid / runs["phs"]["run"][what]) + f" ({short(low, 3)} … {short(high, 3)})",
                    short(rigid / runs["phs_declared"]["run"][what])]
        rows.append(row)
    return table(["R = 550 m, rigid / PHS", "T-gamma, as measured", "as declared",
                  "creep work with spin, as measured", "as declared"], rows)


def steady(phs, radius, changes):
    return compare(phs, curve(radius, **changes), "phs,phs_declared")["bogies"]


LEAD = "steady_curve.wheelsets.lead."
WHEELS = [f"steady_curve.wheels.{axle}_{side}.T_gamma_N"
          for axle in ("lead", "trail") for side in ("outer", "inner")]


STRAIGHT = (("shear stiffness at rest, seals free [MN m/rad]", "held",
             "rest.shear_stiffness_Nm_per_rad", 1e-6, 0),
            ("linear critical speed, single bogie [km/h]", "stability", "critical_speed_m_s", 3.6, 0))


def headlines(phs):
    """Further numbers with their bands, and what half the step changes of the measured ones."""
    rows = []
    for radius in (300, 550, 800):
        runs = steady(phs, radius, {})
        half = steady(phs, radius, {"timestep_s": runs["phs"]["timestep_s"] / 2})["phs"]
        drawn = draws(phs, phs.file(dict(curve(radius), bogie="phs")),
                      [LEAD + "angle_of_attack_rad", LEAD + "sum_Y_N"] + WHEELS)

        def row(words, scale, decimals, of_run, of_draw):
            own, declared = of_run(runs["phs"]), of_run(runs["phs_declared"])
            rows.append([f"R {radius} m: {words}", number(scale * own, decimals),
                         band([scale * of_draw(d) for d in drawn], decimals),
                         number(scale * declared, decimals),
                         number(scale * (of_run(half) - own), decimals + 2)])

        row("Tγ, steady [N]", 1, 1, t_gamma,
            lambda d: sum(d[wheel] for wheel in WHEELS))
        row("angle of attack, leading axle, > 0 to the inner rail [mrad]", 1e3, 3,
            lambda run: wheelset(run)["angle_of_attack_rad"],
            lambda d: d[LEAD + "angle_of_attack_rad"])
        row("ΣY, leading axle [kN]", 1e-3, 2, lambda run: wheelset(run)["sum_Y_N"],
            lambda d: d[LEAD + "sum_Y_N"])
    for words, analysis, key, scale, decimals in STRAIGHT:
        own, declared = (once(phs, phs.file({"track": "straight", "speed_km_h": 60, "bogie": bogie}),
                              [key], analysis)[key] for bogie in ("phs", "phs_declared"))
        drawn = draws(phs, phs.file({"track": "straight", "speed_km_h": 60, "bogie": "phs"}), [key], analysis)
        rows.append([words, number(scale * own, decimals),
                     band([scale * d[key] for d in drawn], decimals),
                     number(scale * declared, decimals), "without steps"])
    return table(["", "as measured", "95 % of draws", "as declared", "changed by half the step"], rows)


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
    rows.append(row("seal friction that rises with pressure (`bo_bo_measured_seals`)",
                    {"phs": "bo_bo_measured_seals"}, both=False))
    return table(["varied", "R = 300 m: angle of attack [mrad]; Tγ run, rigid / PHS", "R = 550 m"], rows)


def deficiency(phs):
    words = []
    for speed in (50, 65, 80, 95):
        done = compare(phs, curve(550, speed_km_h=speed))
        words.append(f"{speed} km/h: {angle(done['bogies']['phs'], ' mrad')}, "
                     f"1/{short(factor(done, 'phs'))} of the rigid wear")
    return "; ".join(words)


def cones(phs):
    words = []
    for wheel, name in (("cone:0.05", "1:20"), ("cone:0.1", "1:10"), ("S1002", "S1002")):
        done = compare(phs, curve(550, wheel=wheel), "phs")["bogies"]["phs"]
        words.append(f"{number(done['run']['T_gamma_total_J'] / 1e3)} kJ ({name})"
                     if done["status"] == "ok" else f"{done['status']} ({name})")
    return ", ".join(words)


def figures(phs):
    return {"over_radius": over_radius(phs), "hydraulics": hydraulics(phs), "headlines": headlines(phs),
            "seal_friction": seal_friction(phs), "varied": varied(phs), "deficiency": deficiency(phs), "cones": cones(phs)}

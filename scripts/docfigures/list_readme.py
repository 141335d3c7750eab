"""README.md: the main comparison, what it is made of, what phs validate says."""
from docfigures.blind import of, sets, share, with_verdict
from docfigures.cases import factor, over_ramps
from docfigures.form import attack, attack_words, hand, number, percent, short, t_gamma, wheel, wheelset

DOCUMENT = "README.md"

BOGIES = ("phs", "phs_declared", "rigid_link", "soft_link")


def budget(run, part, axle="lead"):
    """Magnitude of a yaw moment on an axle [kN m]."""
    return number(abs(run["budget"][axle][part]) / 1e3, 1)


def figures(phs):
    c = phs("compare curve_r550 --bogies " + ",".join(BOGIES))
    out = {}
    for name in BOGIES:
        run = c["bogies"][name]
        out["attack_" + name] = attack(wheelset(run)["angle_of_attack_rad"], 2, hand(run), " mrad")
        out["Y_" + name] = number(wheel(run, "lead_outer")["Y_N"] / 1e3, 1) + " kN"
        out["sum_Y_" + name] = number(wheelset(run)["sum_Y_N"] / 1e3, 1) + " kN"
        out["wear_" + name] = number(t_gamma(run), 0) + " N"
        out["work_" + name] = number(run["run"]["lost_creep_J"] / 1e3, 1) + " kJ"
    blind = [row for name in ("present", "three_hands", "later_hands") for row in sets(phs, f"score_{name}.csv")]
    out["blind_sets"] = str(len(blind))
    out["blind_clean"] = str(sum(row["kind"] == "clean" for row in blind))
    out["blind_alarms"] = str(sum(row["kind"] == "clean" and bool(row["accepted"]) for row in blind))
    out["blind_explained"] = str(with_verdict(blind, "explained"))
    out["blind_right"] = str(with_verdict(blind, "explained", "exact", "one more", "formula"))
    for name, rows in (("own", [row for row in blind if row["suite"] == "holdout"]),
                       ("others", [row for row in blind if row["suite"] != "holdout"])):
        out["blind_" + name] = share(*of(rows, "single", lambda row: row["right"] == "1"))
    own, rigid = c["bogies"]["phs"], c["bogies"]["rigid_link"]
    out["rigid_words"] = attack_words(wheelset(rigid)["angle_of_attack_rad"], 1, hand(rigid))
    out["rigid_creep"] = budget(rigid, "creep_Nm")
    out["own_pressure"] = budget(own, "phs_pressure_Nm")
    out["own_friction"] = budget(own, "phs_friction_Nm")
    out["own_primary"] = budget(own, "primary_Nm")
    declared = c["ratios"]["rigid_link_over_phs_declared"]["run"]
    out["T_declared"] = short(declared["T_gamma_total_J"])
    out["W_declared"] = short(declared["lost_creep_J"])
    for name, scenario in (("smooth", "curve_r550"), ("pull", "traction_r550")):
        ratio = phs(f"compare {scenario} --bogies phs,rigid_link")["ratios"]["rigid_link_over_phs"]
        out["T_" + name] = short(ratio["run"]["T_gamma_total_J"])
        out["W_" + name] = short(ratio["run"]["lost_creep_J"])
    by_ramp = [factor(r, "phs") for r in over_ramps(phs, 550, "phs,rigid_link", timestep_s=0.00125).values()]
    out["ramps"] = f"{short(min(by_ramp))} to {short(max(by_ramp))}"
    energy = [abs(c["bogies"][b]["run"]["energy_error_relative"]) for b in BOGIES]
    out["energy"] = percent(max(energy), 3)
    v = phs("validate")
    out["validate"] = (f"{v['passed']} checks hold, {v['missed_and_listed']} are missed and listed "
                       f"with the reason, {v['orientation']} are orientation")
    missed = [r["what"] for r in v["checks"] if r["verdict"].startswith("missed")]
    fitted = [what for what in missed if "left out" in what]
    out["missed_declared"], out["missed_fitted"] = str(len(missed) - len(fitted)), str(len(fitted))
    row = {r["what"]: r["ours"] for r in v["checks"]}

    def at_most(start):
        return next(ours for what, ours in row.items() if what.startswith(start))

    out["a22_place"] = number(at_most("A-2.2, left wheel: reference point"), 2)
    out["a22_angle"] = number(1e3 * at_most("A-2.2, left wheel: contact angle"), 1)
    out["a22_pressure"] = percent(at_most("A-2.2, left wheel: peak pressure"), 1)
    out["a22_force"] = percent(at_most("A-2.2, left wheel: tangential force"), 0)
    out["fastsim"] = number(row["FASTSIM against CONTACT, rms of force error over mu N"], 3)
    out["cooperrider"] = number(at_most("linear critical speed of the Cooperrider"), 2)
    return out

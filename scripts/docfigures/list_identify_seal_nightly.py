"""docs/identify_examples.md: the O-ring, and what a play found on a rig changes in a curve."""
from docfigures.form import attack, number, short, t_gamma, table, wheelset

DOCUMENT = "docs/identify_examples.md"
PART = "seal."


def interval(value, factor, decimals):
    return (f"{number(value['value'] * factor, decimals)} [{number(value['low'] * factor, decimals)}, "
            f"{number(value['high'] * factor, decimals)}]")


def seal(phs):
    r = phs.result("identify models/rigs/seal_friction.yaml", "result.json")
    before, after = r["channels"]["force_N"]["before"], r["channels"]["force_N"]["after"]
    of_fit = r["channels_estimation"]["force_N"]
    effects = {e["name"]: e for e in r["effects"]}
    order = ", ".join(f"`{e['name']}`" for e in r["effects"])
    again = r["validation_asks_for"]["refitted"]["effects.pressure_friction.bore_N_per_Pa"]
    return {
        "table": table(["", "declared, fitted", "corrected"], [
            ["force error, estimation (rms)", number(of_fit["before"]["rmse"], 1) + " N",
             number(of_fit["after"]["rmse"], 3) + " N"],
            ["force error, validation (rms)", number(before["rmse"], 1) + " N",
             number(after["rmse"], 2) + " N"],
            ["relative, validation", number(before["relative_percent"], 1) + " %",
             number(after["relative_percent"], 2) + " %"]]),
        "order": order,
        "area": interval(effects["pressure_area"]["parameters"]["area_m2"], 1e4, 3) + " cm²",
        "slope": interval(effects["pressure_friction"]["parameters"]["bore_N_per_Pa"], 1e6, 2) +
        "e-6 N/Pa",
        "slope_bar": number(
            effects["pressure_friction"]["parameters"]["bore_N_per_Pa"]["value"] * 1e5, 2),
        "formula": f"`{effects['unlisted']['formula']}`" if "unlisted" in effects else "none",
        "left": number(r["unexplained"]["residual_over_noise"]),
        "noise": number(r["noise"]["force_N"], 3),
        "slope_again": interval(again, 1e6, 1) + "e-6 N/Pa",
    }


def play(phs):
    """The same play in the bogie, at the same step beside the declared model."""
    model = (phs.source / "models/phs/bo_bo_measured.yaml").read_text()
    model += "effects:\n  backlash: {gap_m: 30.2e-6, contact_N_per_m: 2.5e10}\n"
    path = phs.file(model)
    label = "phs@" + path.rpartition("/")[2].removesuffix(".yaml")
    rows = [["angle of attack, leading [mrad]"], ["T-gamma, all wheels [N]"],
            ["T-gamma over the run [kJ]"], ["seal friction on the leading axle [kNm]"]]
    head, wear = [""], {}
    for step in (0.5, 0.25, 0.125):
        done = phs(f"compare curve_r550 --bogies phs,phs@{path} --timestep {step * 1e-3:g}")
        for words, name in (("declared", "phs"), ("with the play", label)):
            run = done["bogies"][name]
            head.append(f"{words}, {step:g} ms")
            rows[0].append(attack(wheelset(run)["angle_of_attack_rad"], 3))
            rows[1].append(number(t_gamma(run), 1))
            wear[words] = run["run"]["T_gamma_total_J"]
            rows[2].append(number(wear[words] / 1e3, 2))
            rows[3].append(number(run["budget"]["lead"]["phs_friction_Nm"] / 1e3, 2))
    change = 100 * abs(wear["with the play"] / wear["declared"] - 1)
    return {"play": table(head, rows), "play_change": short(change, 1) + " %"}


def figures(phs):
    return {**seal(phs), **play(phs)}

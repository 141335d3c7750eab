"""docs/rig_table_b1.md: Table B-1, declared and fitted jointly."""
from docfigures.form import number, percent, table

DOCUMENT = "docs/rig_table_b1.md"
SETUPS = (2, 3, 4)
JOINT = "identify models/rigs/steps_joint.yaml"


def interval(v, factor, decimals, low="low", high="high"):
    return (f"{number(v['value'] * factor, decimals)} "
            f"({number(v[low] * factor, decimals)}–{number(v[high] * factor, decimals)})")


def figures(phs):
    joint = phs.result(JOINT, "result.json")
    alone = {n: phs.result(f"identify models/rigs/steps_setup{n}.yaml", "result.json") for n in SETUPS}
    runs = {run["setup"]: run["errors"] for run in joint["runs"]}

    def cells(key, of="of_gauge"):
        return [percent(runs[n][key][of]) for n in SETUPS]

    single = {n: alone[n]["runs"][0]["errors"] for n in SETUPS}
    out = {"errors": table([""] + [f"setup {n}" for n in SETUPS], [
        ["settled, as declared (1.1 l, 1.4 GPa, gas as charged)"] + cells("settled_declared"),
        ["settled, left out: oil and gas fitted, jointly"] + cells("settled_before_left_out"),
        ["settled, left out: each setup by itself"]
        + [percent(single[n]["settled_left_out"]["of_gauge"]) for n in SETUPS],
        ["**settled, left out: the joint fit**"] + cells("settled_left_out"),
        ["… of the absolute pressure"] + cells("settled_left_out", "of_absolute"),
        ["settled, in sample: the joint fit"] + cells("settled_in_sample"),
        ["just after the step, left out, gas isothermal"] + cells("begin_left_out_isothermal"),
        ["**just after the step, left out, gas with energy equation**"]
        + cells("begin_left_out_thermal")])}
    fitted = joint["fitted"]
    shared = [("oil per line at 1.4 GPa [l]", "lines.oil_volume_m3", 1e3, 2, "1.10"),
              ("blow-off opens at [MPa absolute]", "L1.accumulator_precharge_Pa", 1e-6, 2, "15.00")]
    lines = [[words, declared] + [interval(fitted[key], factor, decimals)] * 3
             for words, key, factor, decimals, declared in shared]
    own = [("filled to, bore [MPa absolute]", "L2.static_pressure_Pa", 1e-6, 2, "1.80"),
           ("filled to, rod [MPa absolute]", "L1.static_pressure_Pa", 1e-6, 2, "2.01"),
           ("gas, bore [ml]", "L2.gas_volume_m3", 1e6, 1, "16.2, 88.9, 178"),
           ("gas, rod [ml]", "L1.gas_volume_m3", 1e6, 1, "16.2, 79.8, 160")]
    for words, key, factor, decimals, declared in own:
        lines.append([words, declared] + [
            interval(fitted[f"quarter_setup{n}: {key}"], factor, decimals) for n in SETUPS])
    area = {"L2": 7.85398e-3, "L1": 7.04974e-3}
    force = [number(sum(sign * fitted[f"quarter_setup{n}: {line}.static_pressure_Pa"]["value"] * area[line]
                        for sign, line in ((1, "L1"), (-1, "L2"))) / 1e3, 1) for n in SETUPS]
    lines.append(["net force at rest, tension [kN]", "0"] + force)
    thermal = {e["run"]: e["parameters"]["thermal_time_s"]
               for e in joint["effects"] if e["name"] == "gas_thermal"}
    lines.append(["thermal time of the gas [s] (range of the left-out fits)", "isothermal"] + [
        interval(thermal[f"quarter_setup{n}"], 1, 1) if f"quarter_setup{n}" in thermal else "isothermal"
        for n in SETUPS])
    out["moved"] = table(["value (95 %)", "declared"] + [f"setup {n}" for n in SETUPS], lines)
    blow_off = fitted["L1.accumulator_precharge_Pa"]
    out["blow_off"] = (f"{number(blow_off['value'] / 1e6, 2)} MPa absolute, 95 % "
                       f"{number(blow_off['low'] / 1e6, 2)}–{number(blow_off['high'] / 1e6, 2)}; "
                       f"{number(blow_off['left_out_low'] / 1e6, 2)}–"
                       f"{number(blow_off['left_out_high'] / 1e6, 2)} over the left-out fits")
    out["sizes"] = (f"{percent(joint['noise']['model_share'])} of the pressure and "
                    f"{number(joint['noise']['reading_Pa'] / 1e3)} kPa")
    out["needed"] = ", ".join(f"`{e['name']}`" for e in joint["effects"] if e["name"] != "gas_thermal")
    checks = {c["what"]: c for c in phs("validate --group hydraulics")["checks"]}
    rows = [[c["what"], number(c["ours"], 1) + " %", number(c["reference"], 1) + " %"]
            for what, c in checks.items() if what.startswith("Table 6-3, middle block")]
    rows += [[c["what"], number(c["ours"] / 1e6, 2) + " MPa", number(c["reference"] / 1e6, 2) + " MPa"]
             for what, c in checks.items() if what.startswith("row ")]
    out["proofs"] = table(["", "ours", "measured"], rows)
    return out

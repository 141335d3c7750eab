"""docs/rig_table_b1.md: settled pressures of Table B-1, declared and fitted."""
from docfigures.form import number, percent, table

DOCUMENT = "docs/rig_table_b1.md"
SETUPS = (2, 3, 4)


def candidate(result, name, beside=()):
    for c in result["candidates"]:
        if c["name"] == name and tuple(c["beside"]) == tuple(beside):
            return c
    return None


def fitted_cell(c):
    return (f"{percent(c['error_in_sample'])} ({percent(c['error_left_out'])})")


def interval(value, factor, decimals):
    return (f"{number(value['value'] * factor, decimals)} "
            f"({number(value['low'] * factor, decimals)}–{number(value['high'] * factor, decimals)})")


def figures(phs):
    found = {n: phs.result(f"identify models/rigs/steps_setup{n}.yaml", "result.json") for n in SETUPS}
    rows = [["as declared (1.1 l, 1.4 GPa, gas as charged)"], ["oil compliance and both gas volumes fitted"]]
    for n in SETUPS:
        channel = found[n]["channels"]["p_end_Pa"]
        rows[0].append(number(channel["declared"]["m_re_percent"], 1) + " %")
        rows[1].append("left out " + number(channel["before"]["m_re_percent"], 1) + " %")
    for name, words in (("accumulator_precharge", "… and the blow-off's precharge"),
                        ("diaphragm_stop", "… and a stop of the diaphragm"),
                        ("filling", "**… and the pressures the lines were filled to**")):
        rows.append([words] + [fitted_cell(candidate(found[n], name)) for n in SETUPS])
    out = {"errors": table([""] + [f"setup {n}" for n in SETUPS], rows)}

    def moved(n):
        filling = next(e for e in found[n]["effects"] if e["name"] == "filling")["parameters"]
        return filling, found[n]["fitted"]

    lines = [["filled to, bore [MPa]", "1.80"], ["filled to, rod [MPa]", "2.00"],
             ["oil compliance V/β [1e-13 m³/Pa]", "7.86"], ["gas, bore [ml]", "as charged"],
             ["gas, rod [ml]", "as charged"], ["net force at rest, tension [kN]", "0"]]
    for n in (3, 4):
        filling, fitted = moved(n)
        bore, rod = filling["static_pressure_bore_Pa"], filling["static_pressure_rod_Pa"]
        lines[0].append(interval(bore, 1e-6, 2))
        lines[1].append(interval(rod, 1e-6, 2))
        lines[2].append(interval(fitted["oil_compliance_m3_per_Pa"], 1e13, 2))
        lines[3].append(number(fitted["gas_volume_bore_m3"]["value"] * 1e6, 1))
        lines[4].append(number(fitted["gas_volume_rod_m3"]["value"] * 1e6, 1))
        area_bore, area_rod = 7.85398e-3, 7.04974e-3
        lines[5].append(number((rod["value"] * area_rod - bore["value"] * area_bore) / 1e3, 1))
    out["moved"] = table(["value (range over the left-out fits)", "declared", "setup 3", "setup 4"], lines)
    return out

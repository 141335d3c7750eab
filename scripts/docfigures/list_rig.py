"""docs/rig.md: Table 6-3 of the thesis, middle block, and which number of the rig decides it."""
import csv
import io
import json

from docfigures.form import number, table

DOCUMENT = "docs/rig.md"
COLUMN = "against_load_cell_m_re_percent"

# Rows of the table: words, columns of the sweep over the source's ranges, of that over the fitted ones.
FACTORS = (("oil of the lines", "oil_volume_m3", "oil_volume_m3"),
           ("bulk modulus", "bulk_modulus_Pa", None),
           ("gas of the reservoirs; of L1 where apart", "gas_volume_m3", "model_L1_gas_volume_m3"),
           ("gas of L2", None, "model_L2_gas_volume_m3"),
           ("filling of L1 (rod)", "model_L1_static_pressure_Pa", "model_L1_static_pressure_Pa"),
           ("filling of L2 (bore)", "model_L2_static_pressure_Pa", "model_L2_static_pressure_Pa"),
           ("blow-off of L1", "accumulator_precharge_Pa", None),
           ("seal friction", "scale", "scale"),
           ("temperature", "temperature_K", "temperature_K"),
           ("amplitude", "amplitude_m", "amplitude_m"))


def indices(phs, study):
    """parameter -> first order, total and their standard errors, of the middle block."""
    saved = json.loads(phs.result_text(f"sweep {study}", "sweep_report.json"))
    of = next(one for one in saved["indices"] if one["output"] == COLUMN)
    return {name: tuple(of[what][i] for what in ("first", "total", "first_error", "total_error"))
            for i, name in enumerate(saved["parameters"])}


def shares(index):
    if index is None:
        return "–"
    first, total, first_error, total_error = index
    return (f"{number(first, 2)} ± {number(1.96 * first_error, 2)} / "
            f"{number(total, 2)} ± {number(1.96 * total_error, 2)}")


def block(phs, study):
    rows = csv.DictReader(io.StringIO(phs.result_text(f"sweep {study}", "sweep.csv")))
    values = [float(row[COLUMN]) for row in rows]
    return f"{number(min(values), 1)} to {number(max(values), 1)} %"


def figures(phs):
    whole = phs("rig --table 6.3")
    rows = [row["friction"] for row in whole["rows"] if row["gas_law"] == "isothermal"]
    ours = [number(row["ours"]["quarter_measured"]["m_re_percent"], 1) for row in rows]
    theirs = [number(row["theirs"]["m_re_percent"], 1) for row in rows]
    printed = [number(row["ours"]["quarter_source"]["m_re_percent"], 0) for row in rows]
    free = whole["friction_free"]
    source = indices(phs, "rig_sensitivity")
    fitted = indices(phs, "rig_sensitivity_measured")
    decides = table(["varied", "over the source's ranges", "as fitted to Table B-1"],
                    [[words, shares(source.get(a)), shares(fitted.get(b))] for words, a, b in FACTORS])
    oil = source["oil_volume_m3"][1] + source["bulk_modulus_Pa"][1]
    return {"middle": f"{ours[0]} % (sine, measured {theirs[0]} %) and {ours[1]} % (triangle, measured {theirs[1]} %)",
            "scale": number(free["friction.scale"]["value"], 2),
            "pressed": number(1e6 * free["difference_N_per_Pa"]["value"]),
            "decides": decides, "oil": number(100 * oil, 1) + " %",
            "block": block(phs, "rig_sensitivity"), "block_fitted": block(phs, "rig_sensitivity_measured"),
            "printed": f"{printed[0]} % (sine) and {printed[1]} % (triangle)"}

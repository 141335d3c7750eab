"""docs/oil_temperature.md: filled at 20 °C, used from −20 to 50 °C."""
import csv
import io

from docfigures.form import number, short, table

DOCUMENT = "docs/oil_temperature.md"
WORDS = {"quarter_setup1": "1: oil on the gas side", "quarter_setup2": "2: atmospheric",
         "quarter_setup3": "3: 0.5 MPa", "quarter_setup4": "4: 1 MPa"}
LOAD = "traction_electric_braking"  # of the load cases (src/analysis/load_cases.cc)


def rows(phs, study):
    # A setup that cannot live at a temperature is a run with status error: exit code 1.
    text = phs.result_text(f"sweep {study}", "sweep.csv", codes=(0, 1))
    lines = (line for line in io.StringIO(text) if not line.startswith("#"))
    found = {}
    for row in csv.DictReader(lines):
        found.setdefault(row["phs"], {})[float(row["temperature_K"])] = row
    return found


def values(found, key):
    """By setup and temperature; None where the run did not end well."""
    return {setup: {T: float(row[key]) if row["status"] == "ok" else None for T, row in by.items()}
            for setup, by in found.items()}


def over_temperature(of, factor, decimals, last=None):
    temperatures = sorted(next(iter(of.values())))
    lines = []
    for setup, by in of.items():
        cells = [number(by[T] * factor, decimals) if by[T] is not None else "–"
                 for T in temperatures]
        lines.append([WORDS[setup]] + cells + ([last(by)] if last else []))
    head = ["reservoir"] + [f"{T - 273.15:.0f} °C".replace("-", "−") for T in temperatures]
    return table(head + (["largest / least"] if last else []), lines)


def spread(by):
    known = [v for v in by.values()]
    return "–" if None in known else short(max(known) / min(known))


def figures(phs):
    shear = values(rows(phs, "temperature_stiffness"), "shear_stiffness_Nm_per_rad")
    loads = rows(phs, "temperature_loads")
    shift = values(loads, LOAD + "_largest_shift_m")
    least = values(loads, LOAD + "_least_pressure_Pa")
    stable = values(rows(phs, "temperature_stability"), "stable_up_to_m_s")
    return {"shear": over_temperature(shear, 1e-6, 1, spread),
            "shift": over_temperature(shift, 1e3, 1),
            "least": over_temperature(least, 1e-6, 2),
            "stable": over_temperature(stable, 3.6, 0)}

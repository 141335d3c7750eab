"""docs/gas_laws.md: the gas laws beside each other and beside what was measured."""
import math
import re

from docfigures.form import number, table

DOCUMENT = "docs/gas_laws.md"
AREA_BORE, AREA_ROD = 7.853982e-3, 7.049734e-3
LAWS = (("isothermal", "isothermal"), ("polytropic 1.4", "polytropic"),
        ("ideal gas, energy equation", "ideal"), ("BWR, energy equation", "bwr"))
INPUTS = (("sine", {"kind": "sine", "amplitude_m": 1.5e-3, "frequency_Hz": 0.1}),
          ("triangle", {"kind": "triangle", "amplitude_m": 1.5e-3, "frequency_Hz": 0.25}))
TAU = {1: 0.725, 2: 1.73, 3: 0.797, 4: 1.376}  # thesis, Table 6-2 [s]


def model(setup, law, tau, balance="unified"):
    """The declared quarter rig of a setup with another gas law."""
    charge = {2: 101325, 3: 0.5e6, 4: 1.0e6}[setup]
    reservoir = {"law": law, "volume_m3": 0.32e-3, "polytropic_exponent": 1.4, "thermal_time_s": tau}
    if setup == 2:
        reservoir["gas_volume_m3"] = 16.16e-6
    else:
        reservoir["charge_pressure_Pa"] = charge
    return {"name": "quarter", "balance": balance,
            "cylinders": [{"name": "1", "bore_line": "L2", "rod_line": "L1"}],
            "line_defaults": {"oil_volume_m3": 1.1e-3, "bulk_modulus_Pa": 1.4e9,
                              "reservoir": reservoir},
            "lines": [{"name": "L1", "static_pressure_Pa": 2005347.5935828877,
                       "accumulator": {"law": law, "volume_m3": 0.75e-3, "precharge_Pa": 15e6,
                                       "thermal_time_s": tau}},
                      {"name": "L2", "static_pressure_Pa": 1.8e6}],
            "friction": {"model": "static"}}


def force(phs, law, signal):
    """Hydraulic force over the second half of the run [N]."""
    rig = phs.file({"rig": "quarter", "model": phs.file(model(2, law, TAU[2])),
                    "signal": {"duration_s": 40, "sample_s": 0.005, "actuator_m": signal}})
    c = phs.columns("rig " + rig, "predicted.csv", ("p_bore_Pa", "p_rod_Pa"))
    f = [r * AREA_ROD - b * AREA_BORE for b, r in zip(c["p_bore_Pa"], c["p_rod_Pa"])]
    return f[len(f) // 2:]


def rms_difference(f, reference):
    square = sum((a - b) ** 2 for a, b in zip(f, reference))
    return 100 * math.sqrt(square / sum(b * b for b in reference))


def mean_relative(f, reference):
    return sum(min(100.0, 100 * abs((a - b) / b)) for a, b in zip(f, reference)) / len(f)


def against_bwr(phs):
    columns = []
    for _, signal in INPUTS:
        reference = force(phs, "bwr", signal)
        columns.append([(rms_difference(f, reference), mean_relative(f, reference))
                        for f in (force(phs, law, signal) for _, law in LAWS)])
    rows = [[words] + [number(x, 1) + " %" for column in columns for x in column[i]]
            for i, (words, _) in enumerate(LAWS)]
    return table(["law", "sine 0.1 Hz, 1.5 mm: rms difference", "m%RE",
                  "triangle 0.25 Hz, 1.5 mm: rms difference", "m%RE"], rows)


def steps(phs, setup, law, balance="unified"):
    rig = {"rig": "steps", "model": phs.file(model(setup, law, TAU[setup], balance)),
           "data": str(phs.source / "models/rigs/lowe_table_b1.csv"), "setup": setup}
    return phs.result("rig " + phs.file(rig), "result.json")


def fitted_steps(phs, setup, law):
    """Errors of the model that identify fits to the settled pressures, its gas by another law."""
    found = phs.result_text(f"identify models/rigs/steps_setup{setup}.yaml", "model.yaml")
    found = re.sub(r"law: \w+", "law: " + law, found)
    found = re.sub(r"thermal_time_s: \S+", f"thermal_time_s: {TAU[setup]}", found)
    rig = {"rig": "steps", "model": phs.file(found),
           "data": str(phs.source / "models/rigs/lowe_table_b1.csv"), "setup": setup}
    return phs.result("rig " + phs.file(rig), "result.json")["channels"]


def against_steps(phs):
    rows = []
    for words, law in LAWS:
        if law == "polytropic":
            continue
        cells = [fitted_steps(phs, setup, law) for setup in (2, 3, 4)]
        rows.append([words] + [number(c["p_begin_Pa"]["m_re_percent"], 1) + " %" for c in cells])
    return table(["just after the step"] + [f"setup {n}" for n in (2, 3, 4)], rows)


def sequential(phs):
    wanted = ((7, 2), (5, 2), (9, 2), (11, 2), (13, 2), (33, 4))
    rows = []
    for row, setup in wanted:
        cells = []
        for balance in ("unified", "sequential"):
            found = next(r for r in steps(phs, setup, "isothermal", balance)["rows"]
                         if r["row"] == row)
            cells.append(found["p_end_Pa"])
        rows.append([f"{row}: setup {setup}, {found['chamber']}, "
                     f"{number(1e3 * found['piston_step_m'], 2)} mm",
                     number(cells[0]["measured"] / 1e6, 2)] +
                    [number(c["predicted"] / 1e6, 2) for c in cells])
    return table(["row", "measured", "unified", "sequential"], rows)


def figures(phs):
    return {"against_bwr": against_bwr(phs), "against_steps": against_steps(phs),
            "sequential": sequential(phs)}

"""docs/stability.md: what the uncertainty of the measured hydraulics does to hunting."""
from docfigures.draws import band, draws
from docfigures.form import table

DOCUMENT = "docs/stability.md"
PART = "bands."
VEHICLES = (("single bogie", "curve_r550"), ("locomotive", "locomotive_r550"),
            ("locomotive with yaw dampers", "locomotive_yaw_dampers"))


def figures(phs):
    rows = []
    for words, scenario in VEHICLES:
        drawn = draws(phs, scenario, ["linear_m_s", "nonlinear_m_s"], "ramps")
        told = [d for d in drawn if d["nonlinear_m_s"] is not None]
        rows.append([words, band([3.6 * d["nonlinear_m_s"] for d in told], 1), f"{len(told)} of {len(drawn)}",
                     band([3.6 * d["linear_m_s"] for d in drawn], 1)])
    return {"hunting": table(["km/h, 95 % of draws", "non-linear critical speed", "ramps that tell", "linear"], rows)}

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
        rows.append([words] + [band([3.6 * d[key] for d in drawn], 0) for key in ("nonlinear_m_s", "linear_m_s")])
    return {"hunting": table(["km/h, 95 % of draws", "hunting lives from", "linear"], rows)}

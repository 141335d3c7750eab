"""docs/failures.md: loads on the axle boxes."""
from docfigures.form import number, table

DOCUMENT = "docs/failures.md"
WORDS = {"shear": "same-sense yaw", "traction": "both axles forward",
         "braking": "both axles backward"}


def figures(phs):
    rows = []
    for case in phs("loads --bogie phs")["cases"]:
        if case["pattern"] == "shear":
            moved = number(1e3 * case["lead_yaw_rad"], 2) + " mrad"
        else:
            moved = (number(1e3 * case["lead_x_m"], 1) + ", " +
                     number(1e3 * case["trail_x_m"], 1) + " mm")
        rows.append([case["name"], number(case["load_per_box_N"] / 1e3) + " kN",
                     WORDS.get(case["pattern"], case["pattern"]), moved,
                     number(case["largest_cylinder_N"] / 1e3, 1) + " kN",
                     ", ".join(number(line["pressure_Pa"] / 1e6, 1) for line in case["lines"])])
    return {"loads": table(["case", "per box", "pattern", "axles move", "largest cylinder force",
                            "lines L1 … L4 [MPa absolute]"], rows)}

"""docs/failures.md: loads on the axle boxes."""
from docfigures.form import number, table

DOCUMENT = "docs/failures.md"
WORDS = {"shear": "same-sense yaw", "traction": "both axles forward",
         "braking": "both axles backward"}


def order(case):
    """Which part gives at which load of a case, in its own order."""
    at = {}
    for limit in case["limits"]:
        what = limit["what"].split()
        part = " ".join(["cylinders"] + what[2:]) if what[0] == "cylinder" else limit["what"]
        at.setdefault((limit["load_per_box_N"], part), []).append(what[1])
    return "; ".join(
        f"{number(load / 1e3)} kN per box: " +
        (part.replace("cylinders", "cylinders " + " and ".join(names)).replace(" its ", " their ")
         .replace(" stop", " stops") if part.startswith("cylinders") else part)
        for (load, part), names in at.items())


def figures(phs):
    rows = []
    cases = phs("loads --bogie phs")["cases"]
    for case in cases:
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
                            "lines L1 … L4 [MPa absolute]"], rows),
            "order": order(next(c for c in cases if c["name"].startswith("unusual"))),
            "rising": number(next(line["pressure_Pa"] for line in cases[1]["lines"]
                                  if line["name"] == "L2") / 1e6, 1) + " MPa"}

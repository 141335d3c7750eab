"""docs/modes.md: stiffness of the axle modes, measured and by hand."""
from docfigures.form import number, table

DOCUMENT = "docs/modes.md"
MODES = (("bending", "stiffness_Nm_per_rad"), ("shear", "stiffness_Nm_per_rad"),
         ("traction", "stiffness_N_per_m"), ("antiphase", "stiffness_N_per_m"))


def mega(x):
    return number(x / 1e6, 1)


def small(modes):
    return [mega(modes[name]["small_amplitude"][key]) for name, key in MODES]


def closed(modes):
    return [mega(modes[name]["closed_form"][key]) for name, key in MODES]


def pressure(mode, largest):
    lines = [line["pressure_Pa"] for line in mode["at_greatest_displacement"]["lines"]]
    return number(max(lines) / 1e6, 1) if largest else lines


def figures(phs):
    own = phs("modes --bogie phs")
    rigid, soft = phs("modes --bogie rigid_link"), phs("modes --bogie soft_link")
    head = ["totals, small motion", "bending [MN m/rad]", "shear [MN m/rad]", "traction [MN/m]",
            "anti-phase [MN/m]"]
    rows = [["PHS, measured"] + small(own), ["PHS, closed form"] + closed(own),
            ["rigid links, measured"] + small(rigid), ["rigid links, closed form"] + closed(rigid),
            ["soft links, measured"] + small(soft), ["soft links, closed form"] + closed(soft)]
    return {
        "table": table(head, rows),
        "bending": mega(own["bending"]["stiffness_Nm_per_rad"]),
        "damping": number(own["bending"]["damping_Nms_per_rad"] / 1e6, 2),
        "shear": mega(own["shear"]["stiffness_Nm_per_rad"]),
        "traction": mega(own["traction"]["stiffness_N_per_m"]),
        "antiphase": mega(own["antiphase"]["stiffness_N_per_m"]),
        "shear_pressure": pressure(own["shear"], True),
        "traction_pressure": pressure(own["traction"], True),
    }

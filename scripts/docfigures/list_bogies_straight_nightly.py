"""docs/bogies.md: running straight."""
from docfigures.form import kmh, table

DOCUMENT = "docs/bogies.md"
PART = "straight."
BOGIES = ("rigid_link", "soft_link", "phs", "emd_radial", "ge_coupling_shaft", "adtranz_shifting",
          "scheffel_cross_anchors", "active_steering", "rigid_link_coco", "phs_coco",
          "emd_radial_coco", "ge_coupling_shaft_coco", "adtranz_shifting_coco")


def critical(speeds):
    rows = []
    for name, of in speeds.items():
        linear = kmh(of["linear_m_s"]) if of["linear_m_s"] is not None else "stable"
        lives = (kmh(of["nonlinear_m_s"]) if of["hunting"] == "dies" else
                 "below " + kmh(of["ramp_to_m_s"]) if of["hunting"] == "lives" else of["hunting"])
        rows.append([f"`{name}`", linear, lives])
    return table(["bogie, km/h", "linear", "non-linear critical speed"], rows)


def figures(phs):
    speeds = {}
    for bogie in BOGIES:
        done = phs(f"compare curve_r550 --bogies {bogie} --radii 550 --stability", codes=(0, 1))
        speeds.update(done["critical_speeds"])
    return {"critical": critical(speeds)}

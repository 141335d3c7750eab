"""docs/bogies.md: forced steering on the locomotive, the angle of the Co-Co's cylinders, assumed values doubled."""
import csv
import io

from docfigures.cases import compare, curve, factor
from docfigures.form import attack, kmh, number, percent, table, wheelset

DOCUMENT = "docs/bogies.md"
PART = "systems."
RADII = (300, 550, 800)
LOCOMOTIVES = ("rigid_link", "phs", "emd_radial", "active_steering", "forced_steering")


def rows(phs, sweep):
    found = phs.result_text(f"sweep {sweep}", "sweep.csv", codes=(0, 1))
    lines = (line for line in io.StringIO(found) if not line.startswith("#"))
    return list(csv.DictReader(lines))


def value(row, name):
    """None where the run did not end well."""
    return float(row[name]) if row["status"] == "ok" and row[name] else None


def one(row, suffix):
    """The value in the column that ends so."""
    return value(row, next(name for name in row if name.endswith(suffix)))


def locomotive(phs):
    lines = []
    for radius in RADII:
        done = compare(phs, curve(radius, vehicle="locomotive"), ",".join(LOCOMOTIVES))
        for bogie in LOCOMOTIVES:
            run = done["bogies"][bogie]
            if run["status"] != "ok":
                lines.append([f"{radius} m", f"`{bogie}`", run["status"], "–", "–", "–", "–"])
                continue
            lines.append([f"{radius} m", f"`{bogie}`"] +
                         [attack(wheelset(run, name)["angle_of_attack_rad"])
                          for name in ("front_lead", "rear_lead")] +
                         [number(wheelset(run, "front_lead")["sum_Y_N"] / 1e3, 1),
                          number(run["run"]["max_sum_Y_N"] / 1e3),
                          number(factor(done, bogie), 1)])
    return table(["R", "bogies", "front bogie, leading axle [mrad]", "rear bogie, leading axle [mrad]",
                  "sum of Y of the front one [kN]", "largest sum of Y of the run [kN]",
                  "wear: rigid / own"], lines)


def angle(phs):
    modes, straight = rows(phs, "cylinder_angle_modes"), rows(phs, "cylinder_angle_straight")
    curves = [rows(phs, f"cylinder_angle_r{radius}") for radius in RADII]
    lines = []
    for i, row in enumerate(modes):
        cells = [row["angle_deg"] + "°"]
        cells += [number(one(row, name) / 1e6, 1) for name in
                  ("shear_stiffness_Nm_per_rad", "traction_stiffness_N_per_m")]
        cells.append(kmh(one(straight[i], "stable_up_to_m_s")))
        for of in curves:
            wear = one(of[i], "T_gamma_total_J")
            cells.append(of[i]["status"] if wear is None else
                         f"{attack(one(of[i], 'lead_angle_of_attack_rad'))}; {number(wear / 1e3, 1)}")
        lines.append(cells)
    return table(["angle", "shear [MN m/rad]", "traction [MN/m]", "nothing grows up to [km/h]"] +
                 [f"R = {radius} m: leading axle [mrad]; wear [kJ]" for radius in RADII], lines)


def doubled(phs):
    lines = []
    for name in ("assumed", "assumed_locomotive"):
        own = {}
        for at, on in zip(rows(phs, name + "_curve"), rows(phs, name + "_straight")):
            bogie, what = at["bogie"], at["doubled"]
            speed, wear = one(on, "stable_up_to_m_s"), one(at, "T_gamma_total_J")
            if what == "nothing":
                own[bogie] = wear
            change = None if wear is None or own[bogie] is None else wear / own[bogie] - 1
            lines.append([f"`{bogie}`", what, at["status"] if wear is None else
                          attack(one(at, "lead_angle_of_attack_rad")),
                          "" if what == "nothing" else percent(change), kmh(speed)])
    return table(["bogie", "doubled", "leading axle, R = 300 m [mrad]", "wear of that run",
                  "nothing grows up to [km/h]"], lines)


def figures(phs):
    return {"locomotive": locomotive(phs), "angle": angle(phs), "doubled": doubled(phs)}

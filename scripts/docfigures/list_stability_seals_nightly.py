"""docs/stability.md: what seal friction does to hunting."""
import csv
import io

from docfigures.form import kmh, number, table

DOCUMENT = "docs/stability.md"
PART = "seals."
IN_TIME = (0.5, 1)  # a disturbance of 4 mm starts hunting there
HARMONICS = (1, 5)


def model(phs, scale):
    text = (phs.source / "models/phs/bo_bo_measured.yaml").read_text()
    changed = text.replace("  model: presliding\n", f"  model: presliding\n  scale: {scale}\n")
    assert changed != text
    return phs.file(changed)


def millimetres(cell):
    return number(1e3 * float(cell), 1) + " mm" if cell else "–"


def in_time(phs, scale):
    if scale not in IN_TIME:
        return "–"
    done = phs(f"stability --bogie phs --phs {model(phs, scale)} --ramp --ramp-from 40 --ramp-to 8 "
               "--timestep 0.0005")
    return kmh(done["limit_cycle"]["nonlinear_critical_speed_m_s"], 1)


def rows(phs):
    found = phs.result_text("sweep seal_friction", "sweep.csv", codes=(0, 1))
    return csv.DictReader(x for x in io.StringIO(found) if not x.startswith("#"))


def by_scale(phs):
    lines = []
    for row in rows(phs):
        scale = float(row["scale"])
        least = row["least_speed_m_s"]
        lines.append([f"× {scale:g}", kmh(float(least), 1) if least else "–", in_time(phs, scale),
                      millimetres(row["least_amplitude_m"]), millimetres(row["brink_m"]),
                      millimetres(row["cycle_m"])])
    return table(["seal friction", "hunting from [km/h]", "by ramps in time", "amplitude there",
                  "brink at 80 km/h", "hunting at 80 km/h"], lines)


def by_harmonics(phs):
    said = []
    for n in HARMONICS:
        least = phs(f"stability --bogie phs --map --harmonics {n}")["hunting_map"]["least"]
        said.append(f"{kmh(least['speed_m_s'], 1)} with {n}" if least else f"none with {n}")
    return ", ".join(said)


def figures(phs):
    return {"friction": by_scale(phs), "harmonics": by_harmonics(phs)}

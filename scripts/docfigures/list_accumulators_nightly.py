"""docs/gas_laws.md: accumulators as spring-dampers and as relief valves beside the full model."""
import re

from docfigures.form import named, number, t_gamma, table, wheelset

DOCUMENT = "docs/gas_laws.md"
MODELS = (("full", "bo_bo_measured"), ("spring-damper", "bo_bo_spring"),
          ("relief valve", "bo_bo_relief"))
OIL_m3 = 1.014e-3
LOADS = (("traction, electric braking", "52 kN"), ("braking", "82 kN"))


def text(phs, name):
    return (phs.source / "models/phs" / (name + ".yaml")).read_text()


def value(model, key):
    return float(re.search(key + r": (\S+)", model).group(1))


def settled(model):
    """A spring-damper at rest: its creeping part has followed. All of it in the oil's modulus, which the
    filling at another temperature knows."""
    if "hose_expansion" not in model:
        return model
    spring = value(model, "compliance_m3_per_Pa") + value(model, "creep_m3_per_Pa")
    of_oil = OIL_m3 / value(model, "bulk_modulus_Pa")
    head, effects = model.split("effects:\n")
    for names, ratio in ((("L1", "L4"), value(model, "rod_ratio")), (("L2", "L3"), 1)):
        modulus = OIL_m3 / (of_oil + ratio * spring)
        for name in names:
            head = re.sub(rf"(- name: {name}\b.*\n)", rf"\1    bulk_modulus_Pa: {modulus:.9e}\n", head)
    return head + "effects:\n" + effects[effects.index("  unlisted:"):]


def at(model, T):
    return model.replace("temperature_K: 293.15", f"filled_at_K: 293.15\ntemperature_K: {T}")


def stiffness(phs, model):
    done = phs(f"modes --bogie phs --phs {phs.file(model)}", codes=(0, 2))
    return done["shear"]["stiffness_Nm_per_rad"] / 1e6 if "shear" in done else None


def rest(phs, model, T):
    """Bore pressure at rest after filling at 20 °C [MPa]; None: the line has lost its pressure."""
    study = {"scenario": "straight", "analysis": "held", "design": "grid",
             "axes": [{"key": "scenario.phs", "values": [phs.file(at(model, T))]}],
             "outputs": ["rest.lines.L2.pressure_Pa"]}
    found = phs.result_text(f"sweep {phs.file(study)}", "sweep.csv", codes=(0, 1))
    row = [line for line in found.splitlines() if not line.startswith("#")][1].split(",")
    head = [line for line in found.splitlines() if not line.startswith("#")][0].split(",")
    cell = dict(zip(head, row))
    return float(cell["L2_pressure_Pa"]) / 1e6 if cell["status"] == "ok" else None


def loads(phs, model):
    done = phs(f"loads --bogie phs --phs {phs.file(settled(model))}")
    cells = []
    for name, _ in LOADS:
        case = named(done["cases"], name)
        empty = [x["load_per_box_N"] for x in case["limits"] if x["what"].endswith("empty")]
        shift = number(1e3 * case["largest_shift_m"], 1) + " mm"
        cells.append(shift + (f", a line empty from {number(empty[0] / 1e3)} kN" if empty else ""))
    return cells


def quarter(model):
    """Its cylinder 1 with lines L1 and L2."""
    model = re.sub(r'  - \{name: "[234]".*\n', "", model)
    model = re.sub(r"  - name: L[34].*\n(?:    .*\n)*", "", model)
    return model.replace("[L1, L4]", "[L1]")


def steps(phs, model):
    """Mean relative errors of Table B-1, setup 2: just after the step, settled."""
    rig = {"rig": "steps", "model": phs.file(quarter(model)),
           "data": str(phs.source / "models/rigs/lowe_table_b1.csv"), "setup": 2}
    channels = phs.result("rig " + phs.file(rig), "result.json")["channels"]
    return [number(channels[c]["m_re_percent"]) + " %" for c in ("p_begin_Pa", "p_end_Pa")]


def curve(phs, scenario):
    asked = ",".join("phs@models/phs/" + name + ".yaml" for _, name in MODELS)
    runs = phs(f"compare {scenario} --bogies {asked}", codes=(0, 1))["bogies"]
    return [runs["phs@" + name] for _, name in MODELS]


def figures(phs):
    models = [text(phs, name) for _, name in MODELS]
    rows = [["shear stiffness, ±2 mm at 0.5 Hz [MN m/rad]"] +
            [number(stiffness(phs, m)) for m in models]]
    for words, cells in zip(LOADS, zip(*(loads(phs, m) for m in models))):
        rows.append([f"{words[0]}, {words[1]} per box: shift of an axle"] + list(cells))
    for words, scenario in (("R 550 m", "curve_r550"), ("R 300 m", "curve_r300"),
                            ("R 550 m, traction", "traction_r550")):
        runs = curve(phs, scenario)
        rows.append([f"{words}: angle of attack, leading [mrad]"] +
                    [number(1e3 * abs(wheelset(r)["angle_of_attack_rad"]), 3) for r in runs])
        rows.append([f"{words}: T-gamma, all wheels [N]"] + [number(t_gamma(r), 1) for r in runs])
    for words, cells in zip(("just after", "settled"), zip(*(steps(phs, m) for m in models))):
        rows.append([f"Table B-1, setup 2: mean error, {words}"] + list(cells))
    for T in (253.15, 323.15):
        rows.append([f"bore lines at {T - 273.15:.0f} °C, filled at 20 °C [MPa]".replace("-", "−")] +
                    [number(rest(phs, settled(m), T), 2) for m in models])
    return {"accumulators": table([""] + [words for words, _ in MODELS], rows)}

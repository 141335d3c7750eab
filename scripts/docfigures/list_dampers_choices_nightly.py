"""docs/dampers.md: whether another throttle would keep the curves of the undamped locomotive."""
from docfigures.cases import compare, curve
from docfigures.form import table
from docfigures.list_dampers_nightly import RADII, apart, in_words

DOCUMENT = "docs/dampers.md"
PART = "choices."
SHIPPED = (2.0e9, 1.0e14)  # R [Pa s/m³], K [Pa s²/m⁶]
THROTTLES = ((1.0e6, 1.0e10), (1.0e7, 4.0e11), (1.0e8, 4.0e12), (5.0e8, 2.0e13), SHIPPED, (8.0e9, 4.0e14))


def model(phs, laminar, turbulent):
    text = (phs.source / "models/phs/bo_bo_damped.yaml").read_text()
    for key, size in (("laminar_Pas_per_m3: 2.0e+9", laminar), ("turbulent_Pas2_per_m6: 1.0e+14", turbulent)):
        assert text.count(key) == 1
        text = text.replace(key, f"{key.split(':')[0]}: {size:.1e}")
    return phs.file(text)


def run(phs, radius, bogie, hydraulics):
    scenario = curve(radius, vehicle="locomotive", bogie=bogie, timestep_s=0.001,
                     **({"phs": hydraulics} if hydraulics else {}))
    return compare(phs, scenario, bogie)["bogies"][bogie]


def figures(phs):
    rows = []
    for bogie, words in (("phs", "none"), ("phs_damped", "as shipped")):
        for laminar, turbulent in THROTTLES:
            own = model(phs, laminar, turbulent)
            rows.append([f"{laminar:.0e}", f"{turbulent:.0e}", words] +
                        [", ".join(in_words(apart(run(phs, r, bogie, own), run(phs, r, "phs", None))))
                         for r in RADII])
    return {"table": table(["R [Pa s/m³]", "K [Pa s²/m⁶]", "yaw dampers"] + [f"R = {r} m" for r in RADII], rows)}

"""docs/rig.md: Table 6-3 of the thesis, middle block."""
from docfigures.form import number

DOCUMENT = "docs/rig.md"


def figures(phs):
    table = phs("rig --table 6.3")
    rows = [row["friction"] for row in table["rows"] if row["gas_law"] == "isothermal"]
    ours = [number(row["ours"]["quarter_measured"]["m_re_percent"], 1) for row in rows]
    theirs = [number(row["theirs"]["m_re_percent"], 1) for row in rows]
    free = table["friction_free"]
    return {"middle": f"{ours[0]} % (sine, measured {theirs[0]} %) and {ours[1]} % (triangle, measured {theirs[1]} %)",
            "scale": number(free["friction.scale"]["value"], 2),
            "pressed": number(1e6 * free["difference_N_per_Pa"]["value"])}

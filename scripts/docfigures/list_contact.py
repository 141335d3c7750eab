"""docs/contact.md: equivalent conicity of S1002 on UIC60."""
from docfigures.form import number, table

DOCUMENT = "docs/contact.md"
PAIR = ("contact --functions --wheel S1002 --rail UIC60 --gauge_m 1.067 "
        "--flange_back_distance_m 0.992 --radius_m 0.625")
AMPLITUDES = (1, 1.5, 2, 3, 4, 5)


def conicity(text):
    """Equivalent conicity by amplitude, as phs prints it: two columns of numbers."""
    out = {}
    for line in text.splitlines():
        words = line.split()
        if len(words) == 2 and all(w.replace(".", "").isdigit() for w in words):
            out[float(words[0])] = float(words[1])
    return [number(out[a], 2) for a in AMPLITUDES]


def figures(phs):
    rows = [["equivalent conicity, rigid"] + conicity(phs.text(PAIR)),
            ["under 127.5 kN on each wheel"] + conicity(phs.text(PAIR + " --load_N 127500"))]
    return {"conicity": table(["amplitude [mm]"] + [str(a) for a in AMPLITUDES], rows)}

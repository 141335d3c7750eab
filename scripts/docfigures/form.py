"""Numbers as they are printed in documents."""
import math


def number(x, decimals=0):
    """'−0.25'; '–' where there is none."""
    if x is None or not math.isfinite(x):
        return "–"
    text = f"{x:.{decimals}f}"
    if float(text) == 0:
        text = text.replace("-", "")
    return text.replace("-", "−")


def short(x, digits=2):
    """With so many significant digits, without an exponent."""
    if x is None or not math.isfinite(x):
        return "–"
    if x == 0:
        return "0"
    return number(x, max(0, digits - 1 - math.floor(math.log10(abs(x)) + 1e-12)))


def percent(x, decimals=1):
    return number(100 * x, decimals) + " %" if x is not None else "–"


def kmh(metres_per_second, decimals=0):
    return number(None if metres_per_second is None else 3.6 * metres_per_second, decimals)


def attack(rad, decimals=2, hand=1, unit=""):
    """Magnitude of an angle of attack in mrad and where the axle points: '4.61 outer'.

    `rad`: yaw against the radial direction, > 0 to the left. `hand`: 1 in a left curve, -1 right.
    """
    if rad is None or not math.isfinite(rad):
        return "–"
    size = number(abs(1e3 * rad), decimals)
    if float(size) == 0:
        return size + unit
    return size + unit + (" outer" if -hand * rad > 0 else " inner")


def attack_words(rad, decimals=2, hand=1):
    """'4.61 mrad to the outer rail'."""
    text = attack(rad, decimals, hand, " mrad")
    for side in ("outer", "inner"):
        text = text.replace(" " + side, f" to the {side} rail")
    return text


def table(head, rows):
    """A Markdown table as the content of a place on lines of its own."""
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n" + "\n".join(lines) + "\n"


def named(entries, name):
    """The entry of a list of results that is called so."""
    for entry in entries:
        if entry["name"] == name:
            return entry
    raise KeyError(name)


def wheelset(run, name="lead"):
    return named(run["steady_curve"]["wheelsets"], name)


def wheel(run, name):
    return named(run["steady_curve"]["wheels"], name)


def t_gamma(run):
    """Sum over all wheels in the steady curve [N], without spin."""
    return sum(w["T_gamma_N"] for w in run["steady_curve"]["wheels"])


def hand(run):
    """1 in a left curve, -1 in a right one."""
    radius = run["steady_curve"].get("radius_m")
    return -1 if radius is not None and radius < 0 else 1

"""Marked places in a document: <!--=NAME-->text<!--/-->."""
import re

PLACE = re.compile(r"<!--=([\w.]+)-->(.*?)<!--/-->", re.DOTALL)
NUMBER = re.compile(r"[-+−]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
NIGHTLY = "nightly."
MACHINE = "machine."


def names(text, prefix):
    """Names of the places whose list has this prefix ("" for the fast ones)."""
    return [m.group(1) for m in PLACE.finditer(text)
            if m.group(1).rpartition(".")[0] == prefix.rstrip(".")]


def filled(text, figures):
    """The text with the places named in `figures` written anew."""

    def write(match):
        name = match.group(1)
        if name not in figures:
            return match.group(0)
        return f"<!--={name}-->{figures[name]}<!--/-->"

    return PLACE.sub(write, text)


def last_digit(number):
    """Worth of one unit in the last place of a number as printed: '0.03' 0.01, '4e-5' 1e-5."""
    mantissa, _, exponent = number.lower().partition("e")
    decimals = len(mantissa.partition(".")[2])
    return 10.0 ** ((int(exponent) if exponent else 0) - decimals)


def value(number):
    return float(number.replace("−", "-"))


def same(printed, now):
    """True if the words are the same and each number as printed, last digit +- 1."""
    if NUMBER.sub("#", printed).split() != NUMBER.sub("#", now).split():
        return False
    for a, b in zip(NUMBER.findall(printed), NUMBER.findall(now)):
        unit = max(last_digit(a), last_digit(b))
        if abs(value(a) - value(b)) > 1.000001 * unit:
            return False
    return True


def differences(text, figures, prefix):
    """One line for each place that does not hold what `figures` says."""
    lines = []
    found = names(text, prefix)
    for name in found:
        if name not in figures:
            lines.append(f"{name}: no list fills this place")
    for name in figures:
        if name not in found:
            lines.append(f"{name}: the document has no such place")
    for match in PLACE.finditer(text):
        name, printed = match.group(1), match.group(2)
        if name == prefix + "made":
            continue
        if name in figures and not same(printed, figures[name]):
            lines.append(f"{name}: printed\n    {printed.strip()}\n  now\n    {figures[name].strip()}")
    return lines

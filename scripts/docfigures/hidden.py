"""What `phs identify` says of the records whose truth ships beside them (models/rigs/hidden)."""
import json

from docfigures.form import number, short, table

CHANNELS = (("piston_m", "piston", 1e6, "µm"), ("load_cell_N", "load cell", 1, "N"),
            ("p_bore_Pa", "pressure, bore side", 1e-3, "kPa"), ("p_rod_Pa", "pressure, rod side", 1e-3, "kPa"))


def truth(phs, record):
    return json.loads((phs.source / f"models/rigs/hidden/{record}_truth.json").read_text())


def answer(phs, record):
    return phs.result(f"identify hidden_{record}", "result.json")


def errors(phs, record):
    """Before, after, and of the true model, on the validation window."""
    said, true = answer(phs, record), truth(phs, record)
    rows = []
    for name, words, factor, unit in CHANNELS:
        both = said["channels"][name]
        values = (both["before"]["rmse"], both["after"]["rmse"], true["validation_rmse"]["true_model"][name])
        rows.append([words] + [short(factor * v, 3) + " " + unit for v in values])
    return table(["validation, rms", "declared, fitted", "corrected", "the true model itself"], rows)


def verdict(said):
    names = ", ".join(f"`{e['name']}`" + (" on " + " ".join(e["on"]) if e.get("on") else "")
                      for e in said["effects"])
    return f"{said['verdict'].replace('_', ' ')}: {names or 'nothing found'}"


def with_interval(value, factor, decimals, unit):
    return (f"{number(factor * value['value'], decimals)} {unit} [{number(factor * value['low'], decimals)}, "
            f"{number(factor * value['high'], decimals)}]")

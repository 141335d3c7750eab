"""What the uncertainty of the measured hydraulics does: the draws of models/sweeps/hydraulics_measured."""
import csv
import io

from docfigures.form import number


def rows_of(phs, lines, scenario, outputs, analysis):
    """Numbers of `outputs` by key (None: there is none), one dictionary per run of a study; all must have ended well."""
    lines = lines + [f"scenario: {scenario}", f"analysis: {analysis}", f"outputs: [{', '.join(outputs)}]"]
    text = phs.result_text("sweep " + phs.file("\n".join(lines) + "\n"), "sweep.csv")
    rows = list(csv.reader(line for line in io.StringIO(text) if not line.startswith("#")))
    status = rows[0].index("status")  # outputs stand behind it, under shorter names
    assert all(row[status] == "ok" for row in rows[1:]), scenario
    return [dict(zip(outputs, (float(cell) if cell else None for cell in row[status + 1:]))) for row in rows[1:]]


def draws(phs, scenario, outputs, analysis="simulate"):
    """The draws of the hydraulics over a scenario (name, or path of a file)."""
    text = (phs.source / "models/sweeps/hydraulics_measured.yaml").read_text()
    lines = [line for line in text.splitlines()
             if not line.startswith(("#", "scenario:", "outputs:"))]
    return rows_of(phs, lines, scenario, outputs, analysis)


def once(phs, scenario, outputs, analysis):
    """An analysis of studies for one scenario as it is."""
    lines = ["design: grid", "axes:", "  - {key: note.once, values: [1]}"]
    return rows_of(phs, lines, scenario, outputs, analysis)[0]


def limits(values):
    """2.5 and 97.5 % of the draws, between them by straight lines."""
    values = sorted(values)

    def at(share):
        place = share * (len(values) - 1)
        low = int(place)
        high = min(low + 1, len(values) - 1)
        return values[low] + (place - low) * (values[high] - values[low])

    return at(0.025), at(0.975)


def band(values, decimals=1, joint=" … "):
    low, high = limits(values)
    return number(low, decimals) + joint + number(high, decimals)

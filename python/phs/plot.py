"""Plots with Matplotlib: channels of runs, bars of a comparison, contact patches.

Every function draws into `ax` (or a figure of its own) and returns the axes.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Union

import numpy as np

from ._errors import Error, no_such
from ._results import Comparison, Run

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def channels(runs: Run | Comparison | Sequence[Run], names: str | Sequence[str], *,
             over: str = "s_m", ax: Axes | None = None) -> Axes:
    """Channels over way (`s_m`) or time (`t_s`). Several runs are told apart by their bogies.

    Channels that share an axis must have one unit.
    """
    ax = _axes(ax)
    several = _runs(runs)
    wanted = [names] if isinstance(names, str) else list(names)
    units: set[str] = set()
    for run in several:
        for name in wanted:
            values = run[name]
            units.add(run.units[name])
            label = name if len(several) == 1 else f"{run.bogie}: {name}" if len(
                wanted) > 1 else run.bogie
            ax.plot(run[over], values, label=label)
    if len(units) > 1:
        raise Error("plot.channels", f"the channels have the units {', '.join(sorted(units))}",
                    "one unit on one axis", "draw them into axes of their own (ax=)")
    unit = units.pop() if units else ""
    ax.set_xlabel(f"{several[0].texts[over]} [{several[0].units[over]}]")
    if len(wanted) == 1:
        ax.set_title(several[0].texts[wanted[0]], fontsize="medium")
    ax.set_ylabel(f"{wanted[0] if len(wanted) == 1 else ''} [{unit}]".strip())
    if len(several) * len(wanted) > 1:
        ax.legend()
    return ax


def compare(comparison: Comparison | Mapping[str, Run], number: str, *,
            ax: Axes | None = None) -> Axes:
    """One number of every bogie's summary as bars: `run.max_Y_over_Q`,
    `steady_curve.wheelsets.lead.angle_of_attack_rad` (lists by the `name` of their members)."""
    ax = _axes(ax)
    values = [_number(run.summary, number) for run in comparison.values()]
    bars = ax.bar(list(comparison), values, width=0.6)
    ax.bar_label(bars, fmt="%.4g")
    ax.margins(y=0.12)
    ax.axhline(0, color="black", linewidth=0.8)
    ax.set_ylabel(number)
    return ax


def patches(table: Mapping[str, Any], *, ax: Axes | None = None) -> Axes:
    """Contact patches of `contact_wheelset` or `contact_patches` as ellipses, one case beside the
    other: a upwards along the track, b across at its place on the rail. Coloured by the largest
    pressure (or the normal force); the arrow is the creep force, the longest as long as a."""
    from matplotlib.collections import PatchCollection
    from matplotlib.patches import Ellipse

    ax = _axes(ax)
    here = np.flatnonzero(np.asarray(table["a_mm"], dtype=float) > 0)
    if here.size == 0:
        raise Error("plot.patches", "the table holds no patch", "rows with a_mm > 0", "")

    def column(name: str, otherwise: Any) -> Any:
        return np.asarray(table.get(name, otherwise), dtype=float)[here]

    rows = np.arange(len(table["a_mm"]))
    a, b = column("a_mm", None), column("b_mm", None)
    place = column("ycp_rail_mm", np.zeros(rows.size))
    case = column("case", rows + 1)
    room = np.ptp(place) + 2 * max(a.max(), b.max())
    across = case * room + place - place.mean()
    key = "pmax_MPa" if "pmax_MPa" in table else "FN_N"
    drawn = PatchCollection([Ellipse((y, 0), 2 * width, 2 * length)
                             for y, width, length in zip(across, b, a)], cmap="viridis", alpha=0.8)
    drawn.set_array(column(key, None))
    ax.add_collection(drawn)
    along, sideways = column("Fx_N", None), column("Fs_N" if "Fs_N" in table else "Fy_N", None)
    largest = max(float(np.hypot(along, sideways).max()), 1e-300)
    ax.quiver(across, np.zeros(here.size), sideways, along, angles="xy", scale_units="xy",
              scale=largest / a.max(), color="crimson")
    ax.figure.colorbar(drawn, ax=ax, label=key, location="bottom")
    ax.set_xticks(np.unique(case) * room, [f"{number:.0f}" for number in np.unique(case)])
    ax.set_xlabel("case; within it across the rail, to scale")
    ax.set_ylabel("along the track [mm]")
    ax.set_aspect("equal")
    ax.autoscale_view()
    return ax


def _axes(ax: Axes | None) -> Axes:
    if ax is not None:
        return ax
    from matplotlib.figure import Figure
    import matplotlib.pyplot as plt

    figure: Figure = plt.figure(layout="constrained")
    return figure.add_subplot()


def _runs(runs: Union[Run, Comparison, Sequence[Run]]) -> list[Run]:
    if isinstance(runs, Run):
        return [runs]
    found = list(runs.values()) if isinstance(runs, Comparison) else list(runs)
    if not found:
        raise Error("plot.channels", "no run is given", "one run or several", "")
    return found


def _number(summary: Any, path: str) -> float:
    """The number at `path`; a member of a list is named by its `name` or place."""
    value = summary
    for part in path.split("."):
        if isinstance(value, list):
            value = {str(row.get("name", i)) if isinstance(row, dict) else str(i): row
                     for i, row in enumerate(value)}
        if not isinstance(value, dict) or part not in value:
            raise no_such(f"number {path!r}: part", part, value if isinstance(value, dict) else [])
        value = value[part]
    return float("nan") if value is None else float(value)

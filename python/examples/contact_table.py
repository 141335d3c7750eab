#!/usr/bin/env python3
"""Contact table: a wheelset pushed sideways over the rails, and creep forces of several laws.

Run it: python3 contact_table.py [FOLDER]."""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import numpy as np

import phs

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")

# Every millimetre to the right, rolling at 20 m/s, 80 kN on the wheel.
places = np.arange(0.0, 6.0)
patches = phs.contact_wheelset(
    {"y_mm": places, "Fz_N": np.full(places.size, 80e3), "vs_mm_s": np.full(places.size, 20e3),
     "vpitch_rad_s": np.full(places.size, -20 / 0.46)},
    wheel="S1002", rail="UIC60", cant_rad=0.025, side="right")
for case, angle, peak in zip(patches["case"], patches["contact_angle_rad"], patches["pmax_MPa"]):
    print(f"{places[int(case) - 1]:4.0f} mm: contact angle {np.degrees(angle):7.2f} deg, "
          f"peak pressure {peak:6.0f} MPa")
phs.plot.patches(patches).figure.savefig(folder / "contact_table.png")

# One patch at rising creepage by several laws.
creepage = np.logspace(-4, -2, 9)
one = {"a_mm": 6.0, "b_mm": 5.0, "FN_N": 80e3, "mu": 0.35, "G_MPa": 82e3, "nu": 0.28, "eta": 0.0,
       "phi_rad_per_mm": 0.0}
cases = {name: np.full(creepage.size, value) for name, value in one.items()} | {"xi": creepage}
for law in ("fastsim", "polach", "kalker_table"):
    force = phs.contact_patches(cases, method=law)["Fx_N"]
    print(f"{law:13}" + "".join(f"{value / 1e3:8.2f}" for value in force) + "  kN")
    assert np.all(np.diff(force) <= 1e-9) and abs(force[-1]) <= 0.35 * 80e3 * 1.001

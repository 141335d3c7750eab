#!/usr/bin/env python3
"""Parameter study: how friction in the rail and the gas in the reservoirs change curving.

Steady states need no run in time, so a grid of them takes seconds; large studies with a store, a
report and a cluster are `phs sweep`. Run it: python3 parameter_study.py [FOLDER]."""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import phs

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
radii_m = [300, 550, 1000]
frictions = [0.2, 0.4]

figure, axes = plt.subplots(layout="constrained")
for friction in frictions:
    curves = phs.curving(["phs", "rigid_link"], radii_m, friction=friction)
    for bogie in ("phs", "rigid_link"):
        wear = curves.column(bogie, "T_gamma_N")
        axes.plot(radii_m, wear, marker="o", label=f"{bogie}, friction {friction}")
        print(f"friction {friction}: {bogie:11}" + "".join(
            f"{radius:6.0f} m: {value:7.1f} N" for radius, value in zip(radii_m, wear)))
    assert np.all(curves.column("phs", "T_gamma_N") < curves.column("rigid_link", "T_gamma_N"))
axes.set_xlabel("radius [m]")
axes.set_ylabel("T-gamma of all wheels [N]")
axes.legend()
figure.savefig(folder / "parameter_study.png")

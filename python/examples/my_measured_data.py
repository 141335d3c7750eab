#!/usr/bin/env python3
"""My measured data: a model beside a measurement, and the effect that the model lacks.

The measurement is made here: a load cell that reads too much, and noise. Put your own arrays in its
place. Run it: python3 my_measured_data.py [FOLDER] [--identify]."""
import sys
from pathlib import Path

import numpy as np

import phs

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")

# A quarter rig is moved; its declared model says what load cell and pressures should read.
manifest = {"rig": "quarter", "model": "quarter_setup2",
            "signal": {"duration_s": 20, "sample_s": 0.01,
                       "actuator_m": {"kind": "sine", "amplitude_m": 1.5e-3, "frequency_Hz": 0.1}}}
predicted = phs.rig(manifest).predicted

# "Measured": the same motion, a load cell that reads 4 % too much, and noise.
random = np.random.default_rng(1)
measured = {name: np.array(values) for name, values in predicted.items()}
measured["load_cell_N"] *= 1.04
for name, values in measured.items():
    if name not in ("t_s", "actuator_m"):
        measured[name] = values + random.normal(0, 2e-3 * np.ptp(values), values.size)

beside = phs.rig({"rig": "quarter", "model": "quarter_setup2", "data": measured})
score = beside["channels"]["load_cell_N"]
print(f"load cell: rms error {score['rmse']:.0f} N of a swing of "
      f"{np.ptp(measured['load_cell_N']) / 1e3:.1f} kN")

if "--identify" in sys.argv:  # minutes
    found = phs.identify({"rig": "quarter", "model": "quarter_setup2", "data": measured,
                          "estimation": [0, 12], "validation": [12, 20]},
                         out=folder / "found", overwrite=True, progress=lambda share: print(
                             f"\r{share:4.0%}", end="", flush=True))
    print("\nfound:", [effect["name"] for effect in found.effects], "->", found.model)
assert 0 < score["rmse"] < 0.2 * np.ptp(measured["load_cell_N"])

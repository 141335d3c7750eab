#!/usr/bin/env python3
"""First curve: the steered bogie and its conventional twin through a curve of 550 m.

Run it: python3 first_curve.py [FOLDER]. It prints what the steering does and draws two pictures."""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")  # pictures into files; leave this away to see windows
import matplotlib.pyplot as plt

import phs

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
folder.mkdir(parents=True, exist_ok=True)
both = phs.compare("curve_r550", ["phs", "rigid_link"])

for bogie, run in both.items():
    lead = run.steady["wheelsets"][0]
    print(f"{bogie:12} angle of attack {1e3 * lead['angle_of_attack_rad']:7.3f} mrad, "
          f"wear {run.summary['run']['T_gamma_total_J'] / 1e3:8.1f} kJ")
wear = both.ratios["phs_over_rigid_link"]["run"]["T_gamma_total_J"]
print(f"the steered bogie wears {wear:.1%} of what the conventional one does")
assert wear < 1

figure, (upper, lower) = plt.subplots(2, figsize=(8, 6), layout="constrained")
phs.plot.channels(both, "lead_angle_of_attack_rad", ax=upper)
phs.plot.compare(both, "run.T_gamma_total_J", ax=lower)
figure.savefig(folder / "first_curve.png")

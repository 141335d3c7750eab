"""steers.py BOGIE MODES.json: the bogie of out/compare.json points less to the rail than rigid links and is softer in
bending."""
import json
import sys

bogie, modes = sys.argv[1], json.load(open(sys.argv[2]))
runs = json.load(open("out/compare.json"))["bogies"]
angle = {name: abs(run["steady_curve"]["wheelsets"][0]["angle_of_attack_rad"]) for name, run in runs.items()}
print({name: f"{1e3 * value:.2f} mrad" for name, value in angle.items()})
assert angle[bogie] < 0.8 * angle["rigid_link"]
bending = modes["bending"]["stiffness_Nm_per_rad"]
print(f"bending {bending:.4g} N m/rad")
assert bending < 0.5 * 132.84e6  # of rigid links

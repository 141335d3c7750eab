"""angle_of_attack.py ONE OTHER SHARE: the largest angles of attack of two results agree within a share and are not equal."""
import json
import sys


def angle(folder):
    summary = json.load(open(folder + "/summary.json"))
    return summary["run"]["max_angle_of_attack_rad"]


one, other, share = angle(sys.argv[1]), angle(sys.argv[2]), float(sys.argv[3])
print(f"angle of attack {1e3 * one:.3f} and {1e3 * other:.3f} mrad")
assert one != other and abs(one - other) <= share * abs(one)

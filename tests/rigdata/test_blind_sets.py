"""The counting of blind sets, on suites written here and against closed formulas."""
import json
import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import literal_study  # noqa: E402
import rule_plot  # noqa: E402
from blind_sets import share_interval  # noqa: E402

DECLARED = {"L1.oil_volume_m3": 1.1e-3, "L2.oil_volume_m3": 1.1e-3, "L1.gas_volume_m3": 16.16e-6,
            "L2.gas_volume_m3": 16.16e-6, "friction.scale": 1.0}
FACTORS = ("oil_compliance_bore", "oil_compliance_rod", "gas_volume_bore", "gas_volume_rod", "friction")


def write_set(suite, name, kind, hidden, accepted, fitted_over_truth):
    """A set whose true factors are all 1, fitted with intervals of 1 % to either side."""
    channels = {"piston_m": 1e-6, "load_cell_N": 50.0}
    truth = {"effects": [{"name": e, "grade": "strong", "form": "gap_stiff_contact", "size_over_noise": 5,
                          "parameters": {"gap_m": 1e-5, "contact_stiffness_N_m": 1e10}} for e in hidden],
             "factors_on_declared": dict.fromkeys(FACTORS, 1.0), "validation_rmse": {"true_model": channels}}
    value = {n: d * fitted_over_truth for n, d in DECLARED.items()}
    gap = {"gap_m": {"value": 1e-5 * fitted_over_truth, "low": 0.98e-5 * fitted_over_truth,
                     "high": 1.02e-5 * fitted_over_truth}}
    result = {"effects": [{"name": e, "parameters": gap} for e in accepted], "verdict": "explained" if accepted else "sufficient",
              "channels": {c: {"after": {"rmse": x}} for c, x in channels.items()},
              "fitted": {n: {"value": v, "low": 0.99 * v, "high": 1.01 * v} for n, v in value.items()}}
    for folder, file, content in (("truth", name + ".json", truth), (f"results/{name}", "result.json", result),
                                  ("results", name + ".run.json", {"seconds": 3})):
        os.makedirs(os.path.join(suite, folder), exist_ok=True)
        with open(os.path.join(suite, folder, file), "w") as out:
            json.dump(content, out)
    return {"set": name, "kind": kind, "truth": name + ".json"}


def printed(script, *words):
    return subprocess.run([sys.executable, os.path.join(HERE, script), *words], capture_output=True, text=True,
                          check=True).stdout


class Shares(unittest.TestCase):
    def test_none_of_sixty_is_at_most_one_less_the_sixtieth_root_of_a_fortieth(self):
        self.assertAlmostEqual(share_interval(0, 60)[1], 1 - 0.025 ** (1 / 60), places=9)
        self.assertEqual(share_interval(0, 60)[0], 0)

    def test_five_of_ten_as_tabulated(self):  # Clopper and Pearson 1934: 18.7 … 81.3 %
        low, high = share_interval(5, 10)
        self.assertAlmostEqual(low, 0.1871, places=4)
        self.assertAlmostEqual(high, 0.8129, places=4)


class Suites(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        suite = self.folder.name
        index = [write_set(suite, "1", "clean", [], [], 1.005),
                 write_set(suite, "2", "clean", [], ["stribeck"], 1.005),
                 write_set(suite, "3", "single", ["backlash"], ["backlash"], 1.03),
                 write_set(suite, "4", "single", ["stribeck"], ["stribeck"], 1.03),
                 write_set(suite, "5", "pair", ["stribeck", "backlash"], ["backlash"], 1.0)]
        with open(os.path.join(suite, "truth", "index.json"), "w") as out:
            json.dump(index, out)

    def tearDown(self):
        self.folder.cleanup()

    def test_intervals_are_counted_where_the_model_is_right_and_the_effect_of_another_kind(self):
        text = printed("interval_coverage.py", self.folder.name)
        self.assertIn("| all, clean | 5 of 5 ", text)         # 0.5 % off, 1 % wide
        self.assertIn("| all, with effects | 0 of 9 ", text)  # 3 % off; the scale of friction beside Stribeck's left out
        self.assertIn("| effects' amounts | 0 of 1 ", text)   # a gap 3 % too large, 2 % wide
        self.assertIn("friction.scale: 2.9 (backlash)", text)  # ln 1.03 / ln 1.01, lower half 0.99: 2.94

    def test_scores_count_what_was_named(self):
        text = printed("pool_scores.py", "made=" + self.folder.name)
        self.assertIn("| right effect first | 2 of 2 ", text)
        self.assertIn("| false alarms | 1 of 2 ", text)
        self.assertIn("| pairs complete | 0 of 1 ", text)


class Literals(unittest.TestCase):
    def test_numbers_of_the_code_and_of_the_rows_are_found_and_nothing_else(self):
        with tempfile.TemporaryDirectory() as root:
            for folder in ("identify/fit", "measurement", "effects", "vehicle"):
                os.makedirs(os.path.join(root, "src", folder))
            with open(os.path.join(root, "src/identify/fit/a.cc"), "w") as out:
                out.write('#include "b2.h"\ndouble x = 2.5e-3 * y1 + 0 + 1;  // 7 parts\nSay("9 of 10", 3);\n')
            with open(os.path.join(root, "src/effects/a.cc"), "w") as out:
                out.write("double Law() { return 4; }\n  static const EffectInfo info = {\n  5,\n  };\nint z = 6;\n")
            found = list(literal_study.literals(root))
        self.assertEqual([literal[3] for literal in found], ["2.5e-3", "3", "5"])
        self.assertEqual(literal_study.name_of(found[0]), "src/identify/fit/a.cc:2:12 2.5e-3")

    def test_a_moved_literal_stays_of_its_kind(self):
        self.assertEqual([literal_study.moved("3", 2), literal_study.moved("3", 0.5), literal_study.moved("2", 0.25),
                          literal_study.moved("0.1", 2)], ["6", "2", "1", "0.2"])

    def test_a_literal_decides_that_changes_more_than_a_twentieth_of_the_records(self):
        def rows(literal, factor, changed):
            return [{"literal": literal, "factor": factor, "suite": "s", "set": str(k), "verdict": "explained",
                     "accepted": "backlash" if k < changed else "stribeck"} for k in range(40)]
        table = rows(*literal_study.BASE, 0) + rows("a.cc:1:1 2", "2", 2) + rows("a.cc:1:1 2", "0.5", 3)
        self.assertEqual(literal_study.deciding(table), [("a.cc:1:1 2", "0.5", 3, 40)])


class Pictures(unittest.TestCase):
    def test_the_picture_of_the_rule_is_that_of_its_table(self):  # else: rule_plot.py rule_study.csv docs/pictures/…
        with open(os.path.join(HERE, "../../docs/pictures/identify_rule.svg")) as file:
            self.assertEqual(file.read(), rule_plot.draw(rule_plot.read_table(os.path.join(HERE, "rule_study.csv"))))


if __name__ == "__main__":
    unittest.main()

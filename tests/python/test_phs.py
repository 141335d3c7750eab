"""The package phs: its functions give what the program gives, its own functions act as physics
says, its errors say what to do. Needs PYTHONPATH; PHS_PROGRAM is the program."""
import calendar
import hashlib
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

import phs

PROGRAM = os.environ["PHS_PROGRAM"]
STRAIGHT = {"track": "straight", "bogie": "phs", "speed_m_s": 20, "duration_s": 1}


def program(*arguments):
    run = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    return run.stdout


class Folder(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)


def same_numbers(a, b, leave=("real_time_factor",)):
    """Equal but for what the clock says."""
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(
            same_numbers(a[k], b[k], leave) for k in a if k not in leave)
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(same_numbers(x, y, leave) for x, y in zip(a, b))
    return a == b


class RunTest(Folder):
    def test_memory_file_and_program_agree(self):
        run = phs.run("curve_r550", duration_s=1, out=self.folder / "python")
        scenario = self.folder / "scenario.yaml"
        text = (phs.data_folder() / "models/scenarios/curve_r550.yaml").read_text()
        scenario.write_text(text + "\nduration_s: 1\n")
        program("simulate", scenario, "--out", self.folder / "program", "--quiet")
        opened = phs.load(self.folder / "python")
        theirs = phs.load(self.folder / "program")
        self.assertTrue(same_numbers(opened.summary["run"], theirs.summary["run"]))
        self.assertEqual(list(run), list(opened))
        self.assertEqual(list(run), list(theirs))
        for name in run:
            np.testing.assert_array_equal(run[name], opened[name], name)
            np.testing.assert_array_equal(run[name], theirs[name], name)
            self.assertEqual(run.units[name], opened.units[name])
            self.assertEqual(run.texts[name], opened.texts[name])
        self.assertEqual(run.units["lead_left_Y_N"], "N")
        self.assertTrue(run.report.is_file())
        self.assertTrue(same_numbers(run.summary, opened.summary))

    def test_a_result_is_opened_lazily(self):
        phs.run("curve_r550", duration_s=0.1, out=self.folder / "r")
        opened = phs.load(self.folder / "r")
        (self.folder / "r/timeseries.h5").unlink()
        self.assertEqual(opened.status, "ok")  # the summary needs no series
        with self.assertRaisesRegex(phs.Error, "timeseries.h5: cannot be read"):
            opened["t_s"]
        code = ("import sys, phs; phs.run('curve_r550', duration_s=0.05)['t_s'];"
                "sys.exit('h5py' in sys.modules or 'matplotlib' in sys.modules)")
        self.assertEqual(subprocess.run([sys.executable, "-c", code]).returncode, 0)

    def test_arrays_outlive_the_run_and_cannot_be_written(self):
        values = phs.run("curve_r550", duration_s=0.1)["t_s"]
        np.testing.assert_allclose(values, np.arange(11) * 0.01, atol=1e-12)
        with self.assertRaises(ValueError):
            values[0] = 1

    def test_keywords_and_dicts_are_scenarios(self):
        as_name = phs.run("curve_r550", speed_km_h=60, duration_s=0.2)
        whole = {"track": "curve_r550", "bogie": "phs", "speed_km_h": 60, "wheel": "S1002",
                 "rail": "UIC60", "friction": 0.35, "creep": "kalker_table", "timestep_s": 0.00125,
                 "record_interval_s": 0.01, "duration_s": 0.2}
        as_dict = phs.run(whole)
        self.assertAlmostEqual(as_name["speed_m_s"][-1], 60 / 3.6, places=2)
        for name in as_name:
            np.testing.assert_array_equal(as_name[name], as_dict[name])
        track = {"gauge_m": 1.067, "segments": [{"kind": "tangent", "length_m": 50}]}
        run = phs.run(STRAIGHT, track=track, friction="wet", duration_s=0.1)
        self.assertEqual(run.status, "ok")
        self.assertEqual(run["curvature_1_m"].tolist(), [0.0] * 11)
        model = phs.run(STRAIGHT, phs_parameters={"friction.scale": 0}, duration_s=0.1)
        self.assertFalse(np.array_equal(model["cylinder_1_force_N"], run["cylinder_1_force_N"]))

    def test_compare_is_compare(self):
        both = phs.compare("curve_r550", ["phs", "rigid_link"], duration_s=0.5,
                           out=self.folder / "c")
        again = phs.load(self.folder / "c")
        self.assertEqual(list(both), ["phs", "rigid_link"])
        self.assertTrue(same_numbers(both.data, again.data))
        np.testing.assert_array_equal(both["rigid_link"]["lead_lateral_m"],
                                      again["rigid_link"]["lead_lateral_m"])
        self.assertFalse(np.array_equal(both["rigid_link"]["lead_lateral_m"],
                                        both["phs"]["lead_lateral_m"]))
        self.assertIn("phs_over_rigid_link", both.ratios)
        verified = phs.run("curve_r550", duration_s=0.5, verify=True)
        self.assertEqual(verified.summary["discretisation"]["half_step_s"], 0.000625)

    def test_errors_say_where_what_and_how(self):
        (self.folder / "there").mkdir()
        (self.folder / "there/file").touch()
        for call, where, text in (
                (lambda: phs.run("curve_r551"), "scenario", "did you mean 'curve_r550'"),
                (lambda: phs.run("curve_r550", frction=0.3), "frction", "did you mean 'friction'"),
                (lambda: phs.run("curve_r550", friction=7), "scenario: friction", "allowed: "),
                (lambda: phs.run("curve_r550", bogie="pfs"), "bogie", "phs"),
                (lambda: phs.run({"speed_m_s": 20}), "track", ""),
                (lambda: phs.run("curve_r550", track={"gauge_m": 9}), "track.yaml", "gauge"),
                (lambda: phs.run("curve_r550", out=self.folder / "there"), "there", "exists"),
                (lambda: phs.load(self.folder), "", "holds no result of phs"),
                (lambda: phs.modes("phs", frequency=1), "frequency", "unknown key"),
                (lambda: phs.contact_patches({"a_mm": [1.0, 2.0], "b_mm": [1.0]}), "b_mm",
                 "1 values"),
                (lambda: phs.contact_wheelset("positions", wheel="S1002", rail="UIC60",
                                              methd="x"), "methd", "keyword"),
                (lambda: phs.contact_patches("creepages", method="polch"), "method", "polach"),
                (lambda: phs.curving(["phs"], [10]), "", "80"),
                (lambda: phs.rig({"rig": "quarter", "modell": "quarter_setup2"}), "modell",
                 "did you mean 'model'")):
            with self.assertRaises(phs.Error) as caught:
                call()
            line = str(caught.exception)
            self.assertIn(where, line)
            self.assertIn(text, line)
            self.assertNotIn("/tmp/phs-", line)
            self.assertEqual(line.count("\n"), 0)
        run = phs.run("curve_r550", duration_s=0.02)
        with self.assertRaisesRegex(phs.Error, "did you mean 'lead_lateral_m'"):
            run["lead_latral_m"]
        self.assertIsNone(run.get("nothing"))  # a KeyError, too

    def test_the_program_says_the_same(self):
        with self.assertRaises(phs.Error) as caught:
            phs.run("curve_r551")
        said = subprocess.run([PROGRAM, "simulate", "curve_r551"], capture_output=True, text=True)
        self.assertEqual(said.stderr.strip(), f"phs: {caught.exception}")


class LongWorkTest(Folder):
    def test_ctrl_c_stops_within_a_second_and_leaves_nothing(self):
        out = self.folder / "r"
        code = ("import phs, sys\n"
                "print('begins', flush=True)\n"
                f"phs.run('curve_r550', timestep_s=2e-5, out={str(out)!r})\n")
        child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, text=True)
        self.assertEqual(child.stdout.readline(), "begins\n")
        time.sleep(1.5)
        self.assertIsNone(child.poll(), "it was over before")
        begin = time.monotonic()
        child.send_signal(signal.SIGINT)
        _, errors = child.communicate(timeout=60)
        self.assertLess(time.monotonic() - begin, 1)
        self.assertIn("KeyboardInterrupt", errors)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_other_threads_run_meanwhile_and_progress_is_told(self):
        seen, shares, done = [], [], threading.Event()

        def count():
            while not done.wait(0.005):
                seen.append(time.monotonic())

        thread = threading.Thread(target=count)
        thread.start()
        phs.run("curve_r550", duration_s=15, progress=shares.append)
        done.set()
        thread.join()
        self.assertGreater(len(seen), 5)
        self.assertEqual(shares, sorted(shares))
        self.assertGreater(shares[-1], 0)

        def fail(_):
            raise ZeroDivisionError

        for work in (lambda: phs.run("curve_r550", timestep_s=1e-4, progress=fail),
                     lambda: phs.modes("phs", progress=fail),
                     lambda: phs.stability("phs", speeds=900, progress=fail),
                     lambda: phs.curving(["phs"], range(200, 2000), progress=fail)):
            with self.assertRaises(ZeroDivisionError):
                work()

    def test_two_threads_give_the_bits_of_one(self):
        alone = phs.run("curve_r550", duration_s=1)
        runs = {}
        threads = [threading.Thread(target=lambda i=i: runs.update(
            {i: phs.run("curve_r550", duration_s=1, forces=lambda t, s: {})})) for i in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for i in range(2):
            for name in alone:
                np.testing.assert_array_equal(runs[i][name], alone[name])


class OwnFunctionsTest(unittest.TestCase):
    def test_a_weight_on_the_frame_is_carried_by_the_wheels(self):
        load = 20e3
        plain = phs.run(STRAIGHT, duration_s=3)
        loaded = phs.run(STRAIGHT, duration_s=3,
                         forces=lambda t, s: {"frame": (0, 0, -load * min(t, 1))})
        wheels = [name for name in plain if name.endswith("_Q_N") and name.count("_") == 3]
        self.assertEqual(len(wheels), 4)
        more = sum(loaded[name][-1] - plain[name][-1] for name in wheels)
        self.assertAlmostEqual(more / load, 1, delta=0.02)

    def test_work_of_an_own_force_is_in_the_book_of_energy(self):
        run = phs.run(STRAIGHT, duration_s=3,
                      forces=lambda t, s: {"frame": (0, 5e3 * np.sin(6 * t), 0, 0, 0, 2e3)})
        self.assertLess(abs(run.summary["run"]["energy_error_relative"]), 1e-3)

    def test_own_torque_of_the_drives_accelerates_as_newton_says(self):
        torque = 2e3
        free = phs.run(STRAIGHT, controller=lambda t, s: {name: 0.0 for name in s.actuators})
        driven = phs.run(STRAIGHT, controller=lambda t, s: {name: torque for name in s.actuators})
        actuators = []
        phs.run(STRAIGHT, duration_s=0.01,
                forces=lambda t, s: actuators.extend(s.actuators) or {})
        count = len(set(actuators))
        self.assertGreater(count, 0)
        gain = (driven["speed_m_s"][-1] - free["speed_m_s"][-1]) / driven["t_s"][-1]
        half = (phs.run(STRAIGHT, controller=lambda t, s: {n: torque / 2 for n in s.actuators})
                ["speed_m_s"][-1] - free["speed_m_s"][-1]) / driven["t_s"][-1]
        self.assertAlmostEqual(half / gain, 0.5, delta=0.02)  # linear
        force = count * torque / 0.625
        mass = 2 * sum(free[f"{w}_{s}_Q_N"][-1] for w in ("lead", "trail")
                       for s in ("left", "right")) / 2 / 9.81
        # Rotating parts carry some of it: between 60 and 100 % of the force over the mass.
        self.assertGreater(gain, 0.6 * force / mass)
        self.assertLess(gain, 1.0 * force / mass)

    def test_the_state_shows_now_and_the_instant_before(self):
        seen = []

        def look(time, state):
            seen.append((time, state["lead_lateral_m"], state["s_m"], state.qpos.copy(),
                         state.joint("lead_yaw"), state.position("frame").copy()))
            rotation = state.rotation("frame")
            np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-12)
            with np.testing.assert_raises(ValueError):
                state.qpos[0] = 1
            return {}

        run = phs.run("curve_r550", duration_s=0.05, record_interval_s=0.001, forces=look)
        self.assertEqual([row[0] for row in seen], run["t_s"].tolist())
        self.assertEqual([row[1] for row in seen[1:]], run["lead_lateral_m"][:-1].tolist())
        self.assertAlmostEqual(seen[-1][5][0] - seen[0][5][0], 80 / 3.6 * 0.05, delta=1e-3)
        self.assertFalse(np.array_equal(seen[0][3], seen[-1][3]))

    def test_what_a_function_raises_ends_the_run(self):
        def late(time, state):
            return {"frame": (0, 0, 1 / (time < 0.1))}

        with self.assertRaises(ZeroDivisionError):
            phs.run(STRAIGHT, forces=late)
        for forces, text in ((lambda t, s: {"fram": (0, 0, 0)}, "did you mean 'frame'"),
                             (lambda t, s: {"frame": (0, 0)}, "2 numbers"),
                             (lambda t, s: {"frame": (0, 0, np.nan)}, "not finite"),
                             (lambda t, s: 5, "returned int"),
                             (lambda t, s: s["lead_latral_m"], "did you mean 'lead_lateral_m'"),
                             (lambda t, s: s.joint("root"), "joint")):
            with self.assertRaisesRegex(phs.Error, text):
                phs.run(STRAIGHT, forces=forces)
        with self.assertRaisesRegex(phs.Error, "actuator 'cylinder"):
            phs.run(STRAIGHT, controller=lambda t, s: {"cylinder_1": 0})


class AnalysesTest(Folder):
    def test_analyses_are_those_of_the_program(self):
        m = phs.modes("phs", out=self.folder / "m")
        self.assertEqual(m.data, json.loads(program("modes", "--bogie", "phs", "--format", "json")))
        self.assertEqual(phs.load(self.folder / "m").stiffness, m.stiffness)
        c = phs.curving(["phs"], [550], out=self.folder / "c")
        told = json.loads(program("curving", "--bogies", "phs", "--radii", "550", "--format",
                                  "json"))
        self.assertTrue(same_numbers(c.data, told, ("processor_s",)))
        self.assertEqual(phs.load(self.folder / "c")["phs"][0]["radius_m"], 550)
        loads = phs.loads("phs")
        self.assertEqual(loads.data, json.loads(program("loads", "--bogie", "phs", "--format",
                                                        "json")))
        s = phs.stability("phs", from_m_s=40, to_m_s=50, speeds=2)
        told = json.loads(program("stability", "--bogie", "phs", "--from", "40", "--to", "50",
                                  "--speeds", "2", "--format", "json", "--quiet"))
        self.assertEqual(s.data, told)
        self.assertEqual(set(s.eigenvalues["speed_m_s"]), {40.0, 50.0})

    def test_contact_is_that_of_the_program(self):
        def table(path):
            lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
            return lines[0].split(",")

        out = self.folder / "patches.csv"
        program("contact", "--cases", "creepages", "--out", out)
        patches = phs.contact_patches("creepages")
        self.assertEqual(list(patches), table(out))
        again = phs.contact_patches({name: values for name, values in patches.items()
                                     if name not in ("Fx_N", "Fy_N", "Mz_Nmm")})
        np.testing.assert_array_equal(again["Fx_N"], patches["Fx_N"])
        self.assertLess(patches["Fx_N"][0], 0)
        self.assertEqual(patches["note"][0], "driving")
        with open(out) as file:
            self.assertIn(repr(float(patches["Fx_N"][0]))[:12], file.read())
        wheelset = phs.contact_wheelset("positions", wheel="S1002", rail="UIC60", cant_rad=0.025)
        self.assertTrue(np.all(wheelset["FN_N"] > 0))
        out = self.folder / "functions.csv"
        said = program("contact", "--functions", "--wheel", "S1002", "--rail", "UIC60",
                       "--cant_rad", "0.025", "--out", out)
        functions, amplitude, conicity = phs.contact_functions("S1002", "UIC60", cant_rad=0.025)
        self.assertEqual(list(functions), table(out))
        theirs = np.genfromtxt(out, delimiter=",", skip_header=1)
        np.testing.assert_array_equal(np.array(list(functions.values())).T, theirs)
        for size, value in zip(amplitude, conicity):
            self.assertIn(f"{1e3 * size:14.1f}   {value:19.4f}", said)

    def test_rigs_take_dicts_and_arrays(self):
        models = phs.data_folder() / "models/rigs"
        from_file = phs.rig(models / "cylinder_ramp.yaml")
        signal_ = {"duration_s": 20, "sample_s": 0.01,
                   "actuator_m": {"kind": "ramp", "amplitude_m": 8.0e-4, "speed_m_s": -5.0e-5,
                                  "start_s": 2}}
        from_dict = phs.rig({"rig": "cylinder", "model": "single_cylinder", "signal": signal_})
        predicted = from_file.predicted
        for name, values in predicted.items():
            np.testing.assert_array_equal(values, from_dict.predicted[name])
        driven = phs.rig({"rig": "cylinder", "model": "single_cylinder", "data": predicted},
                         out=self.folder / "rig")
        score = driven["channels"]["load_cell_N"]
        self.assertLess(score["rmse"], 0.01 * np.ptp(predicted["load_cell_N"]))
        self.assertIsInstance(phs.load(self.folder / "rig"), phs.Rig)
        with self.assertRaisesRegex(phs.Error, "table 'meassured'"):
            driven.table("meassured")

    def test_identify_is_that_of_the_program(self):
        manifest = phs.data_folder() / "models/rigs/steps_setup2.yaml"
        found = phs.identify("steps_setup2", out=self.folder / "i")
        told = json.loads(program("identify", manifest, "--out", self.folder / "p", "--format",
                                  "json", "--quiet"))
        self.assertEqual(found["effects"], told["effects"])
        self.assertIsInstance(phs.load(self.folder / "i"), phs.Identification)
        self.assertTrue(found.model.is_file())


class SweepTest(Folder):
    AXES = [{"key": "scenario.speed_km_h", "values": [50, 70]},
            {"key": "scenario.bogie", "values": ["phs", "rigid_link"]}]
    OUTPUTS = ["run.T_gamma_total_J", "run.max_sum_Y_N"]

    def study(self, duration_s, speeds=(50, 70)):
        """The same study as a file and as a dict."""
        scenario = {"track": "straight_rough", "bogie": "phs", "speed_km_h": 60,
                    "duration_s": duration_s}
        axes = [{**self.AXES[0], "values": list(speeds)}, self.AXES[1]]
        file = self.folder / "study.yaml"
        (self.folder / "scenario.yaml").write_text(json.dumps(scenario))
        file.write_text(json.dumps({"scenario": "scenario.yaml", "axes": axes,
                                    "outputs": self.OUTPUTS}))
        return file, {"scenario": scenario, "axes": axes, "outputs": self.OUTPUTS}

    def test_the_table_is_that_of_the_program_to_the_bit(self):
        file, given = self.study(0.3)
        program("sweep", file, "--out", self.folder / "p", "--quiet")
        theirs = (self.folder / "p/sweep.csv").read_bytes()
        shares = []
        table = phs.sweep(file, out=self.folder / "f", workers=2, progress=shares.append)
        self.assertEqual((self.folder / "f/sweep.csv").read_bytes(), theirs)
        self.assertTrue(table.report.is_file())
        self.assertEqual(shares, sorted(shares))
        self.assertGreater(len(shares), 1)
        phs.sweep(given, out=self.folder / "d")
        self.assertEqual((self.folder / "d/sweep.csv").read_bytes(), theirs)
        opened = phs.load(self.folder / "p")
        for of in (opened, phs.sweep(given, workers=1)):
            self.assertEqual(list(of), theirs.decode().splitlines()[0].split(","))
            for name in of:
                np.testing.assert_array_equal(of[name], table[name])
        for i, line in enumerate(theirs.decode().splitlines()[1:]):
            cells = line.split(",")
            self.assertEqual([table["run"][i], table["speed_km_h"][i]], [i, float(cells[1])])
            self.assertEqual(table["bogie"][i], cells[2])
            self.assertEqual(table["max_sum_Y_N"][i], float(cells[-2]))
        self.assertEqual(table.units["max_sum_Y_N"], "N")
        self.assertEqual(list(table["bogie"][table.ok]), ["phs", "rigid_link"] * 2)
        with self.assertRaises(ValueError):
            table["run"][0] = 1

    def test_runs_that_fail_stand_in_the_table(self):
        _, given = self.study(0.2)
        given["scenario"]["speed_km_h"] = 60
        given["axes"] = [{"key": "scenario.timestep_s", "values": [0.001, 0.02]}]
        table = phs.sweep(given)
        self.assertEqual(table.ok.tolist(), [True, False])
        self.assertEqual(table["status"][1], "error")
        self.assertIn("timestep", table["reason"][1])
        self.assertTrue(np.isnan(table["max_sum_Y_N"][1]))
        self.assertFalse(np.isnan(table["max_sum_Y_N"][0]))

    def test_cases_are_columns(self):
        _, given = self.study(0.2)
        given = {"scenario": given["scenario"], "design": "list", "outputs": self.OUTPUTS,
                 "cases": {"scenario.bogie": ["rigid_link", "phs"], "scenario.speed_km_h": [50, 60]}}
        table = phs.sweep(given)
        self.assertEqual(table["bogie"].tolist(), ["rigid_link", "phs"])
        self.assertEqual(table["speed_km_h"].tolist(), [50, 60])

    def test_ctrl_c_keeps_what_is_made_and_resume_goes_on(self):
        file, _ = self.study(8, speeds=range(40, 46))
        out = self.folder / "r"
        code = ("import phs, sys\n"
                "def told(share):\n"
                "    if share > 0: print('made', flush=True)\n"
                f"phs.sweep({str(file)!r}, out={str(out)!r}, workers=1, progress=told)\n")
        child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, text=True)
        self.assertEqual(child.stdout.readline(), "made\n")
        child.send_signal(signal.SIGINT)
        _, errors = child.communicate(timeout=60)
        self.assertIn("KeyboardInterrupt", errors)
        self.assertFalse(out.exists())
        made = len(list((self.folder / "r.unfinished/runs").iterdir()))
        self.assertGreater(made, 0)
        self.assertLess(made, 12)
        with self.assertRaisesRegex(phs.Error, "resume=True continues it, overwrite=True"):
            phs.sweep(file, out=out)
        shares = []
        table = phs.sweep(file, out=out, resume=True, progress=shares.append)
        self.assertGreaterEqual(shares[0], made / 12)
        self.assertTrue(table.ok.all())
        self.assertEqual(table["run"].tolist(), list(range(12)))
        again = phs.sweep(file, out=out, resume=True)  # nothing is left to do
        np.testing.assert_array_equal(again["max_sum_Y_N"], table["max_sum_Y_N"])

    def test_errors_are_those_of_the_program_in_words_of_python(self):
        file, given = self.study(0.2)
        for wrong, words in (({**given, "outputs": ["run.max_sum_Z_N"]}, "max_sum_Y_N"),
                             ({**given, "axis": []}, "axis.*unknown key"),
                             ({**given, "scenario": "curve_r55"}, "curve_r550")):
            with self.assertRaisesRegex(phs.Error, words):
                phs.sweep(wrong)
        with self.assertRaisesRegex(phs.Error, "search for the best design"):
            phs.sweep("reservoir_design", out=self.folder / "s")
        with self.assertRaisesRegex(phs.Error, "workers: -1 is out of range"):
            phs.sweep(file, workers=-1)
        with self.assertRaisesRegex(phs.Error, "write it to a file"):
            phs.sweep(given, out=self.folder / "s", resume=True)
        (self.folder / "mine").mkdir()
        (self.folder / "mine/thesis.txt").write_text("dear")
        with self.assertRaisesRegex(phs.Error, "mine"):
            phs.sweep(given, out=self.folder / "mine", overwrite=True)
        self.assertTrue((self.folder / "mine/thesis.txt").is_file())

        def fail(_):
            raise ZeroDivisionError

        with self.assertRaises(ZeroDivisionError):
            phs.sweep(given, progress=fail)


class PlotTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        import matplotlib

        matplotlib.use("Agg")

    def test_plots_show_the_numbers(self):
        both = phs.compare("curve_r550", ["phs", "rigid_link"], duration_s=0.3)
        axes = phs.plot.channels(both, "lead_lateral_m")
        self.assertEqual(len(axes.lines), 2)
        np.testing.assert_array_equal(axes.lines[1].get_ydata(),
                                      both["rigid_link"]["lead_lateral_m"])
        np.testing.assert_array_equal(axes.lines[0].get_xdata(), both["phs"]["s_m"])
        self.assertIn("[m]", axes.get_ylabel())
        with self.assertRaisesRegex(phs.Error, "one unit on one axis"):
            phs.plot.channels(both["phs"], ["lead_lateral_m", "lead_left_Y_N"])
        bars = phs.plot.compare(both, "run.max_Y_over_Q")
        self.assertEqual([bar.get_height() for bar in bars.patches],
                         [both[b].summary["run"]["max_Y_over_Q"] for b in both])
        with self.assertRaisesRegex(phs.Error, "did you mean 'max_Y_over_Q'"):
            phs.plot.compare(both, "run.max_Y_over_P")
        table = phs.contact_wheelset("positions", wheel="S1002", rail="UIC60", cant_rad=0.025)
        drawn = phs.plot.patches(table).collections[0]
        self.assertEqual(len(drawn.get_paths()), int(np.sum(table["a_mm"] > 0)))
        np.testing.assert_array_equal(drawn.get_array(), table["pmax_MPa"][table["a_mm"] > 0])


class OriginTest(Folder):
    def origin(self, folder):
        return json.loads((self.folder / folder / "origin.json").read_text())

    def test_a_result_says_which_call_it_comes_from(self):
        before = time.time()
        phs.run("curve_r550", bogie="phs", duration_s=0.1, out=self.folder / "r")
        origin = self.origin("r")
        self.assertRegex(origin["program"], r"^phs \d+\.\d+\.\d+ in Python$")
        self.assertEqual(origin["command"], "phs.run('curve_r550', "
                         f"out='{self.folder / 'r'}', duration_s=0.1, bogie='phs')")
        date = calendar.timegm(time.strptime(origin["date"], "%Y-%m-%dT%H:%M:%SZ"))
        self.assertTrue(before - 2 < date < time.time() + 2, origin["date"])
        inputs = {pathlib.Path(i["path"]).name: i for i in origin["inputs"]}
        for name in ("phs.xml", "curve_r550.yaml", "S1002.prw", "UIC60.prr"):
            self.assertIn(name, inputs)
        for entry in origin["inputs"]:
            digest = hashlib.sha256(pathlib.Path(entry["path"]).read_bytes()).hexdigest()
            self.assertEqual(entry["sha256"], digest, entry["path"])
        page = (self.folder / "r/report.html").read_text()
        self.assertIn("phs.run(&#39;curve_r550&#39;, out=&#39;r&#39;", page)
        self.assertNotIn(str(self.folder), page)

    def test_the_program_notes_the_same_inputs(self):
        phs.compare("curve_r550", ["phs", "rigid_link"], duration_s=0.05, out=self.folder / "p")
        scenario = self.folder / "scenario.yaml"
        text = (phs.data_folder() / "models/scenarios/curve_r550.yaml").read_text()
        scenario.write_text(text + "\nduration_s: 0.05\n")
        program("compare", scenario, "--bogies", "phs,rigid_link", "--quiet",
                "--out", self.folder / "q")
        names = [{(pathlib.Path(i["path"]).name, i["sha256"]) for i in self.origin(out)["inputs"]
                  if pathlib.Path(i["path"]).name not in ("scenario.yaml", "curve_r550.yaml")}
                 for out in "pq"]
        self.assertGreater(len(names[0]), 4)
        self.assertEqual(*names)

    def test_dicts_are_named_as_given(self):
        scenario = {"track": {"name": "mine", "gauge_m": 1.067, "segments": [
            {"kind": "tangent", "length_m": 200}]}, "bogie": "phs",
                    "speed_m_s": 15, "duration_s": 0.05}
        phs.run(scenario, out=self.folder / "r")
        origin = self.origin("r")
        self.assertIn("given: track.yaml", [i["path"] for i in origin["inputs"]])
        self.assertIn("'duration_s': 0.05", origin["command"])

    def test_every_function_that_writes_a_folder_notes_it(self):
        rig = {"rig": "cylinder", "model": "single_cylinder", "signal": {
            "duration_s": 2, "sample_s": 0.01, "actuator_m": {
                "kind": "ramp", "amplitude_m": 1e-4, "speed_m_s": -5e-5, "start_s": 1}}}
        study = {"scenario": "curve_r550", "analysis": "curving",
                 "axes": [{"key": "scenario.bogie", "values": ["phs"]}],
                 "outputs": ["totals.T_gamma_N"]}
        calls = {
            "modes": lambda out: phs.modes("phs", out=out),
            "stability": lambda out: phs.stability("rigid_link", from_m_s=20, to_m_s=30, speeds=2,
                                                   out=out),
            "curving": lambda out: phs.curving("phs", [550], out=out),
            "loads": lambda out: phs.loads("phs", out=out),
            "rig": lambda out: phs.rig(rig, out=out),
            "sweep": lambda out: phs.sweep(study, out=out)}
        for name, call in calls.items():
            with self.subTest(name):
                call(self.folder / name)
                origin = self.origin(name)
                self.assertTrue(origin["command"].startswith(f"phs.{name}("), origin["command"])
                self.assertTrue(origin["inputs"])

    def test_two_at_the_same_time_keep_their_own(self):
        def work(bogie):
            phs.run("curve_r550", bogie=bogie, duration_s=0.3, out=self.folder / bogie)
        threads = [threading.Thread(target=work, args=(b,)) for b in ("phs", "rigid_link")]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for bogie, other in (("phs", "rigid_link"), ("rigid_link", "phs")):
            names = [pathlib.Path(i["path"]).name for i in self.origin(bogie)["inputs"]]
            self.assertIn(f"{bogie}.xml", names)
            self.assertNotIn(f"{other}.xml", names)


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
"""The five doors give the same bits: program, LD_PRELOAD, C API, C++ and Python run one scenario,
without and with a callback of one's own that returns zero; every row of every channel is compared.

five_doors.py BUILD [DURATION_S]: the first seconds, without the whole of it. Needs PYTHONPATH."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy as np

import phs

SCENARIO = {"track": "curve_r550", "bogie": "phs", "wheel": "S1002", "rail": "UIC60",
            "creep": "kalker_table", "friction": 0.35, "speed_km_h": 80, "timestep_s": 0.001,
            "record_interval_s": 0.01}
EVERY = 10  # steps of a recorded row
OPTIONS = (f"track=curve_r550;wheel=S1002;rail=UIC60;creep=kalker_table;friction=0.35;"
           f"speed_m_s={80 / 3.6!r};start_s_m=1")


def call(command, **environment):
    run = subprocess.run([str(part) for part in command], text=True, capture_output=True,
                         env={**os.environ, **environment})
    if run.returncode != 0:
        sys.exit(f"{command[0]}: exit code {run.returncode}\n{run.stdout}{run.stderr}")


def of_series(path):
    with h5py.File(path) as file:
        return {name: data[()] for name, data in file["channels"].items()}


def of_host(path):
    names, rows = path.read_bytes().split(b"\n", 1)
    names = names.decode().split(",")
    table = np.frombuffer(rows).reshape(-1, len(names))
    return dict(zip(names, table.T))


class Doors:
    def __init__(self, build, scratch, scenario):
        self.build, self.scratch = build, scratch
        self.scenario = scratch / "scenario.yaml"
        self.scenario.write_text(json.dumps(scenario))
        self.steps = 0
        self.plugin = build / "plugin/libphs_mujoco.so"
        self.model = build.parent.parent / "bogie_xml/phs.xml"

    def program(self, zero):
        out, calls = self.scratch / f"program{zero}", self.scratch / "calls"
        environment = {"LD_PRELOAD": str(self.build / "tests/doors/libzero_callback.so"),
                       "ZERO_CALLBACK_CALLS": str(calls)} if zero else {}
        call([self.build / "src/cli/phs", "simulate", self.scenario, "--out", out, "--quiet"],
             **environment)
        if zero and int(calls.read_text()) < self.steps:
            sys.exit("program: the callback was not called")
        return of_series(out / "timeseries.h5")

    def preload(self, zero):
        out = self.scratch / "preload"
        call([self.build / "tests/doors/host_preload", self.model, out, self.steps, EVERY]
             + ["zero"] * zero, LD_PRELOAD=str(self.plugin), PHS_OPTIONS=OPTIONS)
        return of_host(out)

    def c_api(self, zero):
        out = self.scratch / "c"
        call([self.build / "tests/doors/host_c", self.model, out, self.steps, EVERY, OPTIONS]
             + ["zero"] * zero)
        return of_host(out)

    def cpp(self, zero):
        call([self.build / "tests/doors/cpp_door", self.scenario, self.scratch / "cpp"]
             + ["zero"] * zero)
        return of_series(self.scratch / "cpp.h5")

    def python(self, zero):
        calls = []

        def nothing(time, state):
            calls.append(time)
            return {"lead_wheelset": (0.0, 0.0, 0.0)}

        own = {"controller": lambda time, state: {}, "forces": nothing} if zero else {}
        run = phs.run(self.scenario, **own)
        if zero and len(calls) < self.steps:
            sys.exit("python: the callback was not called")
        return {name: run[name] for name in run}


def differences(name, reference, other, least):
    """What differs from the reference in bits, in words."""
    if len(other) < least:
        return [f"{name}: {len(other)} channels, expected {least} at least"]
    found = []
    for channel, values in other.items():
        expected = reference.get(channel)
        if expected is None or expected.shape != values.shape:
            found.append(f"{name}: {channel}: not the same rows")
        elif not np.array_equal(expected.view(np.int64), np.ascontiguousarray(values).view(np.int64)):
            at = int(np.flatnonzero(expected != values)[0]) if (expected != values).any() else 0
            found.append(f"{name}: {channel}: row {at}: {values[at]!r}, program {expected[at]!r}")
    return found


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    scenario = dict(SCENARIO)
    if len(sys.argv) > 2:
        scenario["duration_s"] = float(sys.argv[2])
    with tempfile.TemporaryDirectory() as scratch:
        doors = Doors(build, pathlib.Path(scratch), scenario)
        reference = doors.program(False)
        rows = len(reference["t_s"])
        doors.steps = (rows - 1) * EVERY
        instant = len(doors.c_api(False))  # all but the books of energy, which belong to a run
        faults = [] if instant > 60 else [f"only {instant} channels of an instant"]
        for name, door, least in (("program", doors.program, len(reference)),
                                  ("LD_PRELOAD", doors.preload, instant),
                                  ("C API", doors.c_api, instant),
                                  ("C++", doors.cpp, len(reference)),
                                  ("Python", doors.python, len(reference))):
            for zero in (False, True):
                if zero or name != "program":
                    found = differences(f"{name}{' with zero' * zero}", reference, door(zero), least)
                    faults += found[:3]
        moved = np.ptp(reference["lead_lateral_m"])
        if moved == 0:
            faults.append("nothing moved")
    print("\n".join(faults) or f"{rows} rows, {len(reference)} channels ({instant} of the instant): "
          "the same bits through five doors, without and with a callback that returns zero")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

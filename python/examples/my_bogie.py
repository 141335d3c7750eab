#!/usr/bin/env python3
"""My bogie: a bogie file of one's own, with a controller and a force of one's own in the run.

The bogie is a copy of a shipped one here; edit my_bogie.xml and run again.
Run it: python3 my_bogie.py [FOLDER]."""
import shutil
import sys
from pathlib import Path

import numpy as np

import phs

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
mine = folder / "my_bogie.xml"
if not mine.exists():  # a start: the shipped bogie with all that it includes
    shutil.copytree(phs.data_folder() / "bogie_xml", folder, dirs_exist_ok=True)
    shutil.copy(folder / "phs.xml", mine)

WIND_N = 20e3  # on the frame, to the left


def wind(time, state):
    """A gust sideways in the bogie's own axes. A pure function: it is asked several times a step."""
    gust = WIND_N * np.clip(time - 1, 0, 1)
    return {"frame": state.rotation("frame") @ [0, gust, 0]}


def cruise(time, state):
    """Traction instead of the speed hold of the scenario: proportional, limited."""
    error = 80 / 3.6 - state["speed_m_s"]
    torque = np.clip(20e3 * error, -5e3, 5e3)
    return {name: torque for name in state.actuators}


calm = phs.run("curve_r550", bogie=mine, duration_s=4)
blown = phs.run("curve_r550", bogie=mine, duration_s=4, forces=wind, controller=cruise)
shift = blown["lead_lateral_m"][-1] - calm["lead_lateral_m"][-1]
print(f"the gust moves the leading wheelset by {1e3 * shift:.2f} mm to the left; "
      f"speed at the end {blown['speed_m_s'][-1]:.3f} m/s")
assert shift > 0

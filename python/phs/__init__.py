"""Passive Hydraulic Steering on MuJoCo, from Python (docs/python.md).

>>> r = phs.run("curve_r550", duration_s=0.5)
>>> print(r)
<phs.Run phs: ok, 104 channels>
"""

from . import plot
from ._analyses import (contact_functions, contact_patches, contact_wheelset, curving, identify,
                        loads, modes, rig, stability)
from ._errors import Error, NoSuchName
from ._inputs import data_folder
from ._own import State
from ._phs import version as __version__
from ._results import (Comparison, Curving, Identification, Loads, Modes, Rig, Run, Stability,
                       load)
from ._runs import compare, run
from ._sweeps import Sweep, sweep

__all__ = [
    "Comparison", "Curving", "Error", "Identification", "Loads", "Modes", "NoSuchName", "Rig", "Run",
    "Stability", "State", "Sweep", "__version__", "compare", "contact_functions", "contact_patches",
    "contact_wheelset", "curving", "data_folder", "identify", "load", "loads", "modes", "plot", "rig", "run",
    "stability", "sweep",
]

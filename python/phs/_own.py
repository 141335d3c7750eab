"""Own controllers and forces: what a function sees, and how its answer goes into the step."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from ._channels import Array
from ._errors import Error, no_such


class State:
    """The state of the moment, as a controller or a force sees it. Arrays are read only and hold
    the next moment's numbers in the next call: copy what shall stay.

    Positions and speeds are those of now. Channels (`state["lead_lateral_m"]`) are those of the
    instant before, one step ago, since the forces of now come after the functions.
    """

    def __init__(self, names: Mapping[str, Any], arrays: Mapping[str, Array]) -> None:
        #: positions of all freedoms, in the order of MuJoCo [m, rad, quaternions]
        self.qpos = arrays["qpos"]
        #: speeds of all freedoms [m/s, rad/s]
        self.qvel = arrays["qvel"]
        #: activations: friction and other states of the PHS
        self.act = arrays["act"]
        self._xpos, self._xmat = arrays["xpos"], arrays["xmat"]
        self._values = arrays["channels"]
        self._channel = {name: i for i, name in enumerate(names["channels"])}
        self._body: Mapping[str, int] = names["bodies"]
        self._joint: Mapping[str, tuple[int, int, bool]] = names["joints"]
        self._actuator: Mapping[str, int] = names["actuators"]

    def __getitem__(self, channel: str) -> float:
        at = self._channel.get(channel)
        if at is None:
            raise no_such("channel", channel, self._channel)
        return float(self._values[at])

    @property
    def channels(self) -> list[str]:
        """Names of the channels of an instant."""
        return list(self._channel)

    @property
    def bodies(self) -> list[str]:
        """Names of the bodies."""
        return list(self._body)

    @property
    def actuators(self) -> list[str]:
        """Names of the actuators that a controller may set: all but the cylinders."""
        return list(self._actuator)

    def position(self, body: str) -> Array:
        """Origin of a body in the world [m]."""
        row: Array = self._xpos[self._find_body(body)]
        return row

    def rotation(self, body: str) -> Array:
        """Axes of a body in the world, as columns: rotation @ (in the body) = in the world."""
        axes: Array = self._xmat[self._find_body(body)]
        return axes

    def joint(self, name: str) -> float:
        """Position of a slide or hinge [m, rad]."""
        return float(self.qpos[self._find_joint(name)[0]])

    def joint_speed(self, name: str) -> float:
        """Speed of a slide or hinge [m/s, rad/s]."""
        return float(self.qvel[self._find_joint(name)[1]])

    def _find_body(self, name: str) -> int:
        if name not in self._body:
            raise no_such("body", name, self._body)
        return self._body[name]

    def _find_actuator(self, name: str) -> int:
        if name not in self._actuator:
            raise no_such("actuator", name, self._actuator)
        return self._actuator[name]

    def _find_joint(self, name: str) -> tuple[int, int, bool]:
        known = [joint for joint, (_, _, simple) in self._joint.items() if simple]
        if name not in known:
            raise no_such("joint", name, known)
        return self._joint[name]


#: (time [s], state) -> {actuator: control}
Controller = Callable[[float, State], Mapping[str, float]]
#: (time [s], state) -> {body: (fx, fy, fz) or (fx, fy, fz, mx, my, mz)}
Forces = Callable[[float, State], Mapping[str, npt.ArrayLike]]

Step = Callable[[float], tuple[list[tuple[int, float]], list[tuple[int, tuple[float, ...]]]]]


def begin(controller: Controller | None,
          forces: Forces | None) -> Callable[[Mapping[str, Any], Mapping[str, Array]], Step] | None:
    """What the compiled half calls at the begin of each run; None without own functions."""
    if controller is None and forces is None:
        return None

    def begin_run(names: Mapping[str, Any], arrays: Mapping[str, Array]) -> Step:
        state = State(names, arrays)

        def step(time: float) -> Any:
            return (_controls(controller, time, state) if controller else [],
                    _wrenches(forces, time, state) if forces else [])

        return step

    return begin_run


def _controls(controller: Controller, time: float, state: State) -> list[tuple[int, float]]:
    answer = _mapping("controller", controller(time, state))
    return [(state._find_actuator(name), _finite("controller", name, [value])[0])
            for name, value in answer.items()]


def _wrenches(forces: Forces, time: float,
              state: State) -> list[tuple[int, tuple[float, ...]]]:
    wrenches = []
    for name, value in _mapping("forces", forces(time, state)).items():
        numbers = _finite("forces", name, np.asarray(value, dtype=float).ravel().tolist())
        if len(numbers) not in (3, 6):
            raise Error(f"forces: {name}", f"{len(numbers)} numbers",
                        "3 (force, N) or 6 (force, moment, N m), world axes", "")
        wrenches.append((state._find_body(name), tuple(numbers) + (0.0,) * (6 - len(numbers))))
    return wrenches


def _mapping(what: str, answer: object) -> Mapping[str, Any]:
    if answer is None:
        return {}
    if not isinstance(answer, Mapping):
        raise Error(what, f"returned {type(answer).__name__}", "a dict from names to numbers", "")
    return answer


def _finite(what: str, name: str, values: Sequence[float]) -> list[float]:
    numbers = [float(value) for value in values]
    if not all(math.isfinite(x) for x in numbers):
        raise Error(f"{what}: {name}", "gave a number that is not finite", "finite numbers", "")
    return numbers

"""phs.run and phs.compare."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from os import fspath
from typing import Any

from . import _own, _phs
from ._call import called
from ._inputs import FileLike, Inputs, Named, Progress, result_path
from ._results import Comparison, Run, run_of_curve


def run(scenario: FileLike, *, bogie: Named | None = None, phs: FileLike | None = None,
        track: FileLike | None = None, controller: _own.Controller | None = None,
        forces: _own.Forces | None = None, verify: bool = False, out: Named | None = None,
        csv: bool = False, overwrite: bool = False, progress: Progress | None = None,
        **changes: Any) -> Run:
    """One bogie on one track: `phs simulate`.

    `scenario` is a shipped name, a YAML file, or its content as a dict; further keywords replace
    its keys (docs/scenarios.md). `track` and `phs` may be dicts, too: the content of their files.
    `controller` and `forces` are functions of (time, State), asked several times a step (see
    docs/python.md). With `out` the result directory of the program is written. `verify` runs half
    the step beside. Ctrl-C stops the run; nothing is written then.

    >>> r = phs.run("curve_r550", duration_s=0.5)
    >>> r.status, len(r["t_s"]), r.units["lead_lateral_m"]
    ('ok', 51, 'm')
    >>> phs.run("curve_r550", frction=0.2)
    Traceback (most recent call last):
      ...
    phs.Error: scenario: frction: unknown key; allowed: …; did you mean 'friction'?
    """
    changes.update(bogie=bogie, phs=phs, track=track)
    asked = {"bogies": [], "compare": False, "verify": verify, "csv": csv,
             "call": called("run", scenario, controller=controller, forces=forces, verify=verify,
                            out=out, csv=csv, overwrite=overwrite, **changes)}
    curve = _curve(scenario, changes, asked, controller, forces, out, overwrite, progress)
    return run_of_curve(curve, 0, json.loads(curve.single()), result_path(out))


def compare(scenario: FileLike, bogies: Sequence[Named], *, phs: FileLike | None = None,
            track: FileLike | None = None, controller: _own.Controller | None = None,
            forces: _own.Forces | None = None, verify: bool = False, out: Named | None = None,
            csv: bool = False, overwrite: bool = False, progress: Progress | None = None,
            **changes: Any) -> Comparison:
    """The same run with several bogies: `phs compare`. Arguments as in run.

    A bogie may name a PHS model of its own, "phs@model.yaml"; "all" stands for every shipped one.

    >>> c = phs.compare("curve_r550", ["phs", "rigid_link"], duration_s=0.2)
    >>> list(c), c["phs"].status
    (['phs', 'rigid_link'], 'ok')
    """
    changes.update(phs=phs, track=track)
    asked = {"bogies": [fspath(bogie) for bogie in bogies], "compare": True, "verify": verify,
             "csv": csv,
             "call": called("compare", scenario, bogies, controller=controller, forces=forces,
                            verify=verify, out=out, csv=csv, overwrite=overwrite, **changes)}
    curve = _curve(scenario, changes, asked, controller, forces, out, overwrite, progress)
    data = json.loads(curve.compared())
    runs = {bogie: run_of_curve(curve, i, data["bogies"][bogie], result_path(out))
            for i, bogie in enumerate(curve.names())}
    return Comparison(data, runs, result_path(out))


def _curve(scenario: FileLike, changes: Mapping[str, Any], asked: dict[str, Any],
           controller: _own.Controller | None, forces: _own.Forces | None, out: Named | None,
           overwrite: bool, progress: Progress | None) -> _phs.Curve:
    with Inputs() as inputs:
        name, text = inputs.scenario(scenario, changes)
        asked.update(scenario=name, changes=text, out=fspath(out) if out else "",
                     overwrite=overwrite, given=inputs.folder)
        return _phs.run_curve(asked, _own.begin(controller, forces), progress)

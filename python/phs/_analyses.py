"""phs.modes, phs.stability, phs.curving, phs.loads, phs.rig, phs.identify, phs.contact."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from os import PathLike, fspath
from pathlib import Path
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from . import _phs
from ._call import called
from ._channels import Array
from ._errors import Error, no_such
from ._inputs import FileLike, Inputs, Named, Progress, result_path
from ._out import Out
from ._results import Curving, Identification, Loads, Modes, Rig, Stability

#: columns by name: numbers, or texts
Columns = dict[str, Union[Array, list[str]]]


def modes(bogie: Named, *, beside: Sequence[Named] = (), phs: FileLike | None = None,
          track: FileLike | None = None, frequency_Hz: float | None = None,
          out: Named | None = None, overwrite: bool = False, progress: Progress | None = None,
          **changes: Any) -> Modes:
    """Stiffness and damping of the axle modes: `phs modes`. `beside`: further bogies. Here and in
    the other analyses further keywords are keys of a scenario, e.g. phs_parameters.

    >>> m = phs.modes("phs")
    >>> m.stiffness["bending"] < m.stiffness["shear"]
    True
    """
    scenario = {"bogie": bogie, "phs": phs, "track": track, **changes}
    options: dict[str, Any] = {"beside": [fspath(b) for b in beside],
                               "frequency_Hz": frequency_Hz}
    options["call"] = called("modes", bogie, beside=beside, phs=phs, track=track,
                             frequency_Hz=frequency_Hz, out=out, overwrite=overwrite, **changes)
    data = _analyse(_phs.modes, scenario, options, out, overwrite, progress)
    result = Modes(data[0], result_path(out))
    result.beside = tuple(Modes(other, result_path(out)) for other in data[1:])
    return result


def stability(bogie: Named, *, phs: FileLike | None = None, track: FileLike | None = None,
              from_m_s: float | None = None, to_m_s: float | None = None,
              speeds: int | None = None, ramp: bool = False, ramp_from_m_s: float | None = None,
              ramp_to_m_s: float | None = None, ramp_rate_m_s2: float | None = None,
              out: Named | None = None, overwrite: bool = False,
              progress: Progress | None = None, **changes: Any) -> Stability:
    """Eigenvalues over speed and critical speeds: `phs stability`. `ramp`: the limit cycle, too.

    >>> s = phs.stability("rigid_link", from_m_s=20, to_m_s=30, speeds=2)
    >>> sorted(set(s.eigenvalues["speed_m_s"].tolist()))
    [20.0, 30.0]
    """
    scenario = {"bogie": bogie, "phs": phs, "track": track, **changes}
    options: dict[str, Any] = {
        "from_m_s": from_m_s, "to_m_s": to_m_s, "speeds": speeds, "ramp": ramp,
        "ramp_from_m_s": ramp_from_m_s, "ramp_to_m_s": ramp_to_m_s,
        "ramp_rate_m_s2": ramp_rate_m_s2}
    options["call"] = called("stability", bogie, phs=phs, track=track, out=out,
                             overwrite=overwrite, **{**options, **changes})
    return Stability(_analyse(_phs.stability, scenario, options, out, overwrite, progress),
                     result_path(out))


def curving(bogies: Named | Sequence[Named], radii_m: Sequence[float] | npt.ArrayLike = (), *,
            track: FileLike | None = None, speed_limit_km_h: float | None = None,
            cant_m: float | None = None, deficiency_m: float | None = None, time_run: bool = False,
            out: Named | None = None, overwrite: bool = False,
            progress: Progress | None = None, **changes: Any) -> Curving:
    """Steady state in curves of many radii, without a run in time: `phs curving`.

    >>> c = phs.curving(["phs", "rigid_link"], [550])
    >>> abs(c.column("phs", "angle_of_attack_lead_rad")) < abs(
    ...     c.column("rigid_link", "angle_of_attack_lead_rad"))
    array([ True])
    """
    several: Sequence[Named] = [bogies] if isinstance(bogies, (str, PathLike)) else bogies
    options: dict[str, Any] = {
        "bogies": [fspath(b) for b in several],
        "radii_m": np.asarray(radii_m, dtype=float).ravel().tolist(),
        "speed_limit_km_h": speed_limit_km_h, "cant_m": cant_m,
        "deficiency_m": deficiency_m, "time_run": time_run}
    options["call"] = called("curving", out=out, overwrite=overwrite, track=track,
                             **{**options, **changes})
    data = _analyse(_phs.curving, {"track": track, **changes}, options, out, overwrite, progress)
    return Curving(data, result_path(out))


def loads(bogie: Named, *, phs: FileLike | None = None, track: FileLike | None = None,
          out: Named | None = None, overwrite: bool = False, progress: Progress | None = None,
          **changes: Any) -> Loads:
    """The standard load cases on the axle boxes, and which part gives first: `phs loads`."""
    scenario = {"bogie": bogie, "phs": phs, "track": track, **changes}
    options = {"call": called("loads", bogie, phs=phs, track=track, out=out, overwrite=overwrite,
                              **changes)}
    return Loads(_analyse(_phs.loads, scenario, options, out, overwrite, progress), result_path(out))


def rig(manifest: FileLike, *, out: Named | None = None, overwrite: bool = False) -> Rig:
    """A declared model driven by measured or generated motion: `phs rig`.

    `manifest` is a name, a YAML file or its content as a dict; `data` in the dict may be a dict of
    arrays (docs/rig.md). Without `out` the files live as long as the result.
    """
    with Inputs() as inputs, Out(out) as place:
        path = inputs.manifest(manifest)
        text, _ = _phs.rig(path, place.name, overwrite,
                           called("rig", manifest, out=out, overwrite=overwrite), inputs.folder)
        return place.keep(Rig(json.loads(text), Path(place.name)))


def identify(manifest: FileLike, *, out: Named | None = None, overwrite: bool = False,
             threads: int = 2, max_effects: int = 3, between: Sequence[str] = (),
             progress: Progress | None = None) -> Identification:
    """Find the physical effect that a declared model lacks: `phs identify`. As rig.

    `between`: two effects that the designed next test is to tell apart."""
    with Inputs() as inputs, Out(out) as place:
        path = inputs.manifest(manifest)
        call = called("identify", manifest, out=out, overwrite=overwrite, threads=threads,
                      max_effects=max_effects, between=list(between))
        text, _ = _phs.identify(path, place.name, overwrite, threads, max_effects, list(between),
                                progress, call, inputs.folder)
        return place.keep(Identification(json.loads(text), Path(place.name)))


def contact_patches(cases: Named | Mapping[str, Any], *, method: str = "") -> Columns:
    """Patches with creepages in, creep forces out: `phs contact --cases`.

    `cases` is a CSV file or its columns: a_mm, b_mm, FN_N, mu, G_MPa, nu, xi, eta,
    phi_rad_per_mm. The columns come back with Fx_N, Fy_N, Mz_Nmm, the forces on the rail.

    >>> t = phs.contact_patches({"a_mm": [6.0], "b_mm": [6.0], "FN_N": [1e5], "mu": [0.3],
    ...     "G_MPa": [82e3], "nu": [0.28], "xi": [1e-4], "eta": [0.0], "phi_rad_per_mm": [0.0]})
    >>> t["Fx_N"][0] < 0
    True
    """
    return _phs.contact_patches(_cases(cases), _law(method))


def contact_wheelset(cases: Named | Mapping[str, Any], *, wheel: Named | None = None,
                     rail: Named | None = None, side: str = "", method: str = "",
                     **pair: float) -> Columns:
    """A wheelset placed on track, contact patches out: `phs contact --wheelset`.

    `cases` is a CSV file, CONTACT's input file, or columns: y_mm, Fz_N or z_mm, yaw_rad, vs_mm_s,
    vpitch_rad_s … Further keywords: gauge_m, gauge_height_m, cant_rad, flange_back_distance_m,
    flange_back_position_m, radius_m, mu, shear_modulus_Pa, poisson_ratio.
    """
    if side not in ("", "left", "right"):
        raise no_such("side", side, ["left", "right"])
    return _phs.contact_wheelset(_cases(cases), _pair(wheel, rail, pair), side, _law(method))


def contact_functions(wheel: Named, rail: Named, *, reach_m: float = 10e-3,
                      step_m: float = 0.1e-3, load_N: float = 0.0,
                      **pair: float) -> tuple[Columns, Array, Array]:
    """Radius difference, contact angles and conicity of a pair: `phs contact --functions`.

    Gives (table over the lateral position, amplitudes [m], equivalent conicities).

    >>> table, amplitude, conicity = phs.contact_functions("S1002", "UIC60", cant_rad=0.025)
    >>> bool(conicity[0] > 0), len(amplitude) == len(conicity)
    (True, True)
    """
    for name, value, low, high in (("reach_m", reach_m, 2e-3, 40e-3), ("step_m", step_m, 1e-5, 1e-3),
                                   ("load_N", load_N, 0.0, 1e6)):
        if not low <= value <= high:
            raise Error(name, f"{value:g} is out of range", f"{low:g} … {high:g}", "")
    return _phs.contact_functions(_pair(wheel, rail, pair), reach_m, step_m, load_N)


def _analyse(function: Callable[[dict[str, Any], Progress | None], str],
             scenario: Mapping[str, Any], options: Mapping[str, Any], out: Named | None,
             overwrite: bool, progress: Progress | None) -> Any:
    with Inputs() as inputs:
        track = inputs.file("track", scenario.get("track"))
        # Speed and track are the analysis's own; a scenario cannot be read without.
        _, text = inputs.scenario({"track": "none", "speed_m_s": 20}, {**scenario, "track": None})
        asked = {**options, "scenario": text, "track": track or None,
                 "out": fspath(out) if out else None, "overwrite": overwrite,
                 "given": inputs.folder}
        return json.loads(function({k: v for k, v in asked.items() if v is not None}, progress))


def _cases(cases: Named | Mapping[str, Any]) -> str | dict[str, Any]:
    return dict(cases) if isinstance(cases, Mapping) else fspath(cases)


def _pair(wheel: Named | None, rail: Named | None, numbers: Mapping[str, float]) -> dict[str, Any]:
    known = ["gauge_m", "gauge_height_m", "cant_rad", "flange_back_distance_m",
             "flange_back_position_m", "radius_m", "mu", "shear_modulus_Pa", "poisson_ratio"]
    for name in numbers:
        if name not in known:
            raise no_such("keyword", name, known)
    pair: dict[str, Any] = {name: float(value) for name, value in numbers.items()}
    if wheel is not None:
        pair["wheel"] = fspath(wheel)
    if rail is not None:
        pair["rail"] = fspath(rail)
    return pair


def _law(method: str) -> str:
    if method and method not in _phs.creep_laws():
        raise no_such("method", method, _phs.creep_laws())
    return method

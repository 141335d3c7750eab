"""What the functions return, and what `load` finds in a result directory."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from ._channels import Array, ChannelSource, FileChannels, find
from ._errors import Error, no_such

Json = dict[str, Any]


class Run(Mapping[str, Array]):
    """One bogie on one track: a mapping from channel names to arrays, and its summary.

    Channels of a result directory are read from its HDF5 file when they are asked for.
    """

    def __init__(self, bogie: str, summary: Json, source: ChannelSource,
                 path: Path | None) -> None:
        #: name of the run: its bogie
        self.bogie = bogie
        #: summary.json as a dict (docs/results.md)
        self.summary = summary
        #: the result directory, or None
        self.path = path
        self._source = source

    def __getitem__(self, name: str) -> Array:
        return find(self._source, name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._source.described())

    def __len__(self) -> int:
        return len(self._source.described())

    def __contains__(self, name: object) -> bool:
        return name in self._source.described()

    def __repr__(self) -> str:
        where = f", {self.path}" if self.path else ""
        return f"<phs.Run {self.bogie}: {self.status}, {len(self)} channels{where}>"

    @property
    def status(self) -> str:
        """ok, derailed or diverged."""
        return str(self.summary["status"])

    @property
    def reason(self) -> str:
        """Why it ended before the end of the track; empty if it did not."""
        return str(self.summary.get("reason", ""))

    @property
    def steady(self) -> Json:
        """Means over the last third of the first arc; empty if the run did not get there."""
        return dict(self.summary.get("steady_curve") or {})

    @property
    def units(self) -> Mapping[str, str]:
        """{channel: unit}."""
        return MappingProxyType({n: unit for n, (unit, _) in self._source.described().items()})

    @property
    def texts(self) -> Mapping[str, str]:
        """{channel: what it is}."""
        return MappingProxyType({n: text for n, (_, text) in self._source.described().items()})

    @property
    def report(self) -> Path | None:
        """The report of the result directory."""
        return _report(self.path)


class Comparison(Mapping[str, Run]):
    """The same run with several bogies: a mapping from their names to the runs."""

    def __init__(self, data: Json, runs: dict[str, Run], path: Path | None) -> None:
        #: compare.json as a dict
        self.data = data
        #: the result directory, or None
        self.path = path
        self._runs = runs

    def __getitem__(self, bogie: str) -> Run:
        if bogie not in self._runs:
            raise no_such("bogie", bogie, self._runs)
        return self._runs[bogie]

    def __iter__(self) -> Iterator[str]:
        return iter(self._runs)

    def __len__(self) -> int:
        return len(self._runs)

    def __repr__(self) -> str:
        return f"<phs.Comparison {', '.join(self._runs)}>"

    @property
    def ratios(self) -> Json:
        """{"A_over_B": the same numbers divided}."""
        return dict(self.data["ratios"])

    @property
    def report(self) -> Path | None:
        """The report of the result directory."""
        return _report(self.path)


class Analysis:
    """A result that is one JSON file: its members by name, `data` as a whole."""

    #: the JSON file of a result directory
    file = ""

    def __init__(self, data: Any, path: Path | None = None) -> None:
        #: the JSON file as a dict
        self.data: Any = data
        #: the result directory, or None
        self.path = path

    @classmethod
    def of_file(cls, path: Path) -> Analysis:
        """From a result directory."""
        return cls(_read_json(path / cls.file), path)

    def __getitem__(self, key: str) -> Any:
        if key not in self.data:
            raise no_such(f"{type(self).__name__.lower()} member", key, self.data)
        return self.data[key]

    def __repr__(self) -> str:
        return f"<phs.{type(self).__name__}>"

    @property
    def report(self) -> Path | None:
        """The report of the result directory."""
        return _report(self.path)


class Modes(Analysis):
    """Stiffness and damping of the axle modes of a bogie (modes.json)."""

    file = "modes.json"
    #: modes of the bogies of `beside`
    beside: tuple[Modes, ...] = ()

    @property
    def stiffness(self) -> dict[str, float]:
        """{bending, shear [N m/rad], traction, antiphase [N/m]} at the large amplitude."""
        return {mode: _first_number(self.data[mode], "stiffness_")
                for mode in ("bending", "shear", "traction", "antiphase")}


class Stability(Analysis):
    """Eigenvalues over speed and critical speeds (stability.json)."""

    file = "stability.json"

    @property
    def critical_speed_m_s(self) -> float:
        """The linear one; NaN if there is none in the scan."""
        value = self.data["critical_speed_m_s"]
        return float("nan") if value is None else float(value)

    @property
    def eigenvalues(self) -> dict[str, Array]:
        """{speed_m_s, real_1_s, imag_rad_s}, one value each per eigenvalue."""
        return _columns(self.data["eigenvalues"])


class Curving(Analysis):
    """Steady states over radius (curving.json)."""

    file = "curving.json"

    def __getitem__(self, bogie: str) -> list[Json]:
        if bogie not in self.data["bogies"]:
            raise no_such("bogie", bogie, self.data["bogies"])
        return list(self.data["bogies"][bogie])

    def column(self, bogie: str, key: str) -> Array:
        """One number of every radius, e.g. `angle_of_attack_lead_rad`; NaN where there is none."""
        rows = self[bogie]
        if rows and not any(key in row for row in rows):
            raise no_such("number", key, rows[0])
        return np.array([_number(row.get(key)) for row in rows])


class Loads(Analysis):
    """The standard load cases on a bogie (loads.json)."""

    file = "loads.json"


class RigResult(Analysis):
    """A rig run or an identification (result.json) with its tables."""

    file = "result.json"

    def table(self, name: str) -> dict[str, Array]:
        """`predicted`, `measured` or `baseline` as columns, read from its CSV file."""
        if self.path is None or not (self.path / f"{name}.csv").is_file():
            known = sorted(p.stem for p in self.path.glob("*.csv")) if self.path else []
            raise no_such("table", name, known)
        return _read_csv(self.path / f"{name}.csv")

    @property
    def predicted(self) -> dict[str, Array]:
        """The columns of predicted.csv."""
        return self.table("predicted")

    @property
    def measured(self) -> dict[str, Array]:
        """The columns of measured.csv: the data as used."""
        return self.table("measured")


class Rig(RigResult):
    """A declared model driven by measured or generated motion."""


class Identification(RigResult):
    """What `identify` found."""

    @property
    def effects(self) -> list[Json]:
        """The accepted effects, strongest first; empty when the declared model suffices."""
        return list(self.data["effects"])

    @property
    def model(self) -> Path | None:
        """The corrected PHS model: a file for run, compare and rig."""
        path = self.path / "model.yaml" if self.path else None
        return path if path and path.is_file() else None


def run_of_curve(curve: Any, index: int, summary: Json, path: Path | None) -> Run:
    """A run just made."""
    from ._channels import MemoryChannels

    return Run(curve.names()[index], summary, MemoryChannels(curve, index), path)


def load(directory: str | Path) -> Any:
    """The result in a directory that the program or this package has written.

    Gives a Run, Comparison, Modes, Stability, Curving, Loads, Rig, Identification or Sweep. Channels
    are read from HDF5 when they are asked for.

    >>> phs.load("nowhere")
    Traceback (most recent call last):
      ...
    phs.Error: nowhere: is no directory; allowed: a result directory of phs
    """
    path = Path(directory)
    if not path.is_dir():
        raise Error(str(directory), "is no directory", "a result directory of phs", "")
    if (path / "summary.json").is_file():
        summary = _read_json(path / "summary.json")
        return Run(str(summary["bogie"]), summary, FileChannels(path / "timeseries.h5"), path)
    if (path / "compare.json").is_file():
        data = _read_json(path / "compare.json")
        runs = {bogie: Run(bogie, summary, FileChannels(path / f"{bogie}_timeseries.h5"), path)
                for bogie, summary in data["bogies"].items()}
        return Comparison(data, runs, path)
    for kind in (Modes, Stability, Curving, Loads):
        if (path / kind.file).is_file():
            return kind.of_file(path)
    if (path / "sweep.csv").is_file():
        from ._sweeps import Sweep

        return Sweep(path)
    if (path / "result.json").is_file():
        data = _read_json(path / "result.json")
        return (Identification if "effects" in data else Rig)(data, path)
    raise Error(str(directory), "holds no result of phs",
                "summary.json, compare.json, modes.json, stability.json, curving.json, loads.json, "
                "result.json or sweep.csv", "")


def _report(path: Path | None) -> Path | None:
    page = path / "report.html" if path else None
    return page if page and page.is_file() else None


def _read_json(path: Path) -> Any:
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as fault:
        raise Error(str(path), f"cannot be read ({fault})", "a JSON file of phs", "") from fault


def _read_csv(path: Path) -> dict[str, Array]:
    with path.open(encoding="utf-8") as file:
        names = next(line for line in file if not line.startswith("#")).strip().split(",")
        cells = [line.rstrip("\n").split(",") for line in file if not line.startswith("#")]
    columns: dict[str, Array] = {}
    for i, name in enumerate(names):
        columns[name] = np.array([_number(row[i]) for row in cells])
    return columns


def _number(value: Any) -> float:
    try:
        return float("nan") if value is None or value == "" else float(value)
    except (TypeError, ValueError):
        return float("nan")


def _first_number(row: Json, prefix: str) -> float:
    return float(next(value for key, value in row.items() if key.startswith(prefix)))


def _columns(rows: list[Json]) -> dict[str, Array]:
    return {key: np.array([_number(row[key]) for row in rows]) for key in (rows[0] if rows else {})}

"""phs.sweep: many runs of one scenario or rig, and the table they give."""

from __future__ import annotations

import csv
import json
import sqlite3
import subprocess
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _phs
from ._call import called
from ._errors import Error, no_such
from ._inputs import FileLike, Inputs, Named, Progress
from ._out import Out

#: numbers, or texts where a column holds texts
Column = npt.NDArray[Any]


class Sweep(Mapping[str, Column]):
    """The table of a sweep (sweep.csv): a mapping from columns to arrays, one value per run.

    Columns: `run`, the axes, `seed` where runs have one, `status`, the outputs, `reason`. A run that
    did not end well has NaN as its outputs.
    """

    def __init__(self, path: Path) -> None:
        #: the result directory
        self.path = path
        described = _described(path / "index.sqlite")
        #: {column: unit}
        self.units: Mapping[str, str] = MappingProxyType(
            {name: unit for name, (unit, _) in described.items()})
        self._columns = _read(path / "sweep.csv", {n: kind for n, (_, kind) in described.items()})

    def __getitem__(self, name: str) -> Column:
        if name not in self._columns:
            raise no_such("column", name, self._columns)
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __contains__(self, name: object) -> bool:
        return name in self._columns

    def __repr__(self) -> str:
        return f"<phs.Sweep {self.ok.size} runs, {int(self.ok.sum())} ok>"

    @property
    def ok(self) -> npt.NDArray[np.bool_]:
        """True for each run that ended well: `table["sum_Y_N"][table.ok]`."""
        return np.asarray(self["status"] == "ok")

    @property
    def report(self) -> Path | None:
        """The report of the result directory; none where there is nothing to draw."""
        page = self.path / "report.html"
        return page if page.is_file() else None


def sweep(study: FileLike, *, out: Named | None = None, workers: int = 0, resume: bool = False,
          overwrite: bool = False, progress: Progress | None = None) -> Sweep:
    """Many runs of one scenario or rig on all cores: `phs sweep`. The same table, to the bit.

    `study` is a name, a YAML file or its content as a dict (docs/sweep.md); `scenario` or `rig` in
    the dict may be a dict, `cases` a dict of columns. Each run is made by one of `workers` processes (one per
    core without it). Ctrl-C keeps in OUT.unfinished what is made; `resume=True` goes on from there.

    >>> t = phs.sweep({"scenario": "curve_r550", "analysis": "curving",
    ...     "axes": [{"key": "scenario.bogie", "values": ["phs", "rigid_link"]}],
    ...     "outputs": ["totals.T_gamma_N"]})
    >>> t["bogie"].tolist(), bool(t["T_gamma_N"][0] < t["T_gamma_N"][1])
    (['phs', 'rigid_link'], True)
    """
    if workers < 0:
        raise Error("workers", f"{workers} is out of range", "0 (one per core) or more", "")
    if resume and isinstance(study, Mapping):
        raise Error("resume", "the study is a dict, which is a new file in every call",
                    "a study in a file", "write it to a file and give its path")
    if resume and not out:
        raise Error("resume", "does not know what to go on with", "out=DIR as before", "")
    with Inputs() as inputs, Out(out) as place:
        call = called("sweep", study, out=out, workers=workers or None, resume=resume,
                      overwrite=overwrite)
        made = _in_own_process({"study": _study(inputs, study), "out": place.name,
                                "workers": workers, "resume": resume, "overwrite": overwrite,
                                "call": call, "given": inputs.folder}, progress)
        if not made["all"]:
            raise Error(place.name, f"stopped after {made['done']} runs", "", "resume=True goes on")
        return place.keep(Sweep(Path(place.name)))


def _study(inputs: Inputs, given: FileLike) -> str:
    if not isinstance(given, Mapping):
        return inputs.file("study", given)
    whole = dict(given)
    if isinstance(whole.get("scenario"), Mapping):
        scenario = dict(whole["scenario"])
        for key in ("track", "phs"):
            if isinstance(scenario.get(key), Mapping):
                scenario[key] = inputs.file(key, scenario[key])
        whole["scenario"] = inputs.file("scenario", scenario)
    if isinstance(whole.get("rig"), Mapping):
        whole["rig"] = inputs.manifest(whole["rig"])
    if "cases" in whole:
        whole["cases"] = _cases(inputs, whole["cases"])
    return inputs.file("study", whole)


def _cases(inputs: Inputs, given: Named | Mapping[str, Any]) -> str:
    """As Inputs.table; here columns may hold texts, e.g. names of bogies."""
    if not isinstance(given, Mapping):
        return inputs.table("cases", given)
    columns = {name: [str(v) for v in np.asarray(values).ravel()] for name, values in given.items()}
    if len({len(values) for values in columns.values()}) != 1:
        raise Error("cases", "has columns of different length", "as many values in each", "")
    path = inputs.path("cases.csv")
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(zip(*columns.values()))
    return str(path)


# Workers are forked, which a process with threads must not do: NumPy alone may have some. So the
# job has a process of its own, which loads nothing but the compiled half. It ends when its standard
# input does: because the work shall stop, or because this process is gone.
_JOB = """
import json, os, select, signal, sys
sys.path.append(sys.argv[1])
phs = __import__("_phs")
signal.signal(signal.SIGINT, signal.SIG_IGN)
asked = json.loads(sys.argv[2])
def tell(share):
    try:
        print(share, flush=True)
    except BrokenPipeError:  # nobody listens any more; the workers die with this process
        os._exit(1)
    return not select.select([0], [], [], 0)[0]
print(phs.sweep(asked["study"], asked["out"], asked["workers"], asked["resume"],
                asked["overwrite"], tell, asked["call"], asked["given"]), flush=True)
"""


def _in_own_process(asked: Mapping[str, Any], progress: Progress | None) -> dict[str, Any]:
    command = [sys.executable, "-I", "-c", _JOB, str(Path(_phs.__file__).parent), json.dumps(asked)]
    last = ""
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                          text=True, encoding="utf-8") as job:
        assert job.stdin is not None and job.stdout is not None
        try:
            for line in job.stdout:
                last = line
                if progress is not None and not line.startswith("{"):
                    progress(float(line))
        finally:
            job.stdin.close()
            job.stdout.read()  # what it still says while it stops
    if not last.startswith("{"):
        raise Error("sweep", f"its process ended with exit code {job.returncode}", "", "")
    answer: dict[str, Any] = json.loads(last)
    if "error" in answer:
        where, what, allowed, mend = (_of_python(part) for part in answer["error"])
        raise Error(where, what, allowed, mend)
    return answer


def _of_python(text: str) -> str:
    """Options of the program as keywords."""
    for option, keyword in (("--resume", "resume=True"), ("--force", "overwrite=True"),
                            ("--out", "out"), ("--workers", "workers")):
        text = text.replace(option, keyword)
    return text


def _described(index: Path) -> dict[str, tuple[str, str]]:
    """{column: (unit, kind)}."""
    try:
        with sqlite3.connect(f"{index.absolute().as_uri()}?mode=ro", uri=True) as database:
            rows = database.execute("SELECT name, unit, kind FROM columns").fetchall()
    except sqlite3.Error as fault:
        raise Error(str(index), f"cannot be read ({fault})", "the result of a sweep", "") from fault
    database.close()
    return {name: (unit, kind) for name, unit, kind in rows}


def _read(table: Path, kinds: Mapping[str, str]) -> dict[str, Column]:
    with table.open(encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file))
    if not rows:
        raise Error(str(table), "is empty", "the table of a sweep", "")
    columns: dict[str, Column] = {}
    for i, name in enumerate(rows[0]):
        cells = [row[i] for row in rows[1:]]
        columns[name] = _column(cells, kinds.get(name, ""))
        columns[name].flags.writeable = False
    return columns


def _column(cells: list[str], kind: str) -> Column:
    """An output is numbers, NaN where it is empty; an axis where all its cells are numbers."""
    if kind == "output":
        return np.array([float(cell) if cell else np.nan for cell in cells])
    try:
        return np.array([float(cell) for cell in cells])
    except ValueError:
        return np.array(cells, dtype=np.str_)

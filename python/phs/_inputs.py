"""Inputs given as dicts and arrays instead of files: written to a folder of their own, which lives
as long as the work. The readers of the libraries read them, so nothing is checked twice."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Callable, Mapping
from os import PathLike, fspath
from pathlib import Path
from types import TracebackType
from typing import Any, Union

import numpy as np

from . import _phs
from ._errors import Error

Named = Union[str, "PathLike[str]"]
#: a name, a path, or the content of the file as a dict
FileLike = Union[Named, Mapping[str, Any]]
#: hears the share done, 0 to 1; what it raises stops the work
Progress = Callable[[float], None]


class Inputs:
    """Gives files for what was handed over, and takes the folder's name out of error messages.

    >>> with Inputs() as inputs:
    ...     print(inputs.file("track", "curve_r550"))
    ...     print(Path(inputs.file("track", {"gauge_m": 1.067})).read_text())
    curve_r550
    {"gauge_m": 1.067}
    """

    def __init__(self) -> None:
        self._folder: tempfile.TemporaryDirectory[str] | None = None

    def __enter__(self) -> Inputs:
        return self

    def __exit__(self, kind: type[BaseException] | None, fault: BaseException | None,
                 trace: TracebackType | None) -> None:
        if self._folder is None:
            return
        prefix = self._folder.name + "/"
        self._folder.cleanup()
        if isinstance(fault, Error) and prefix in str(fault):
            raise Error(*(part.replace(prefix, "") for part in
                          (fault.where, fault.what, fault.allowed, fault.mend))) from None

    def path(self, name: str) -> Path:
        """A file that is not there yet."""
        if self._folder is None:
            self._folder = tempfile.TemporaryDirectory(prefix="phs-")
        return Path(self._folder.name) / name

    @property
    def folder(self) -> str:
        """Where the files made of dicts and columns are; empty while there is none."""
        return self._folder.name if self._folder else ""

    def file(self, what: str, given: FileLike | None) -> str:
        """The name or path as it is; of a dict a file. Empty for None."""
        if given is None:
            return ""
        if not isinstance(given, Mapping):
            return fspath(given)
        path = self.path(f"{what}.yaml")
        path.write_text(to_json(given), encoding="utf-8")
        return str(path)

    def table(self, what: str, given: Named | Mapping[str, Any]) -> str:
        """The path as it is, made absolute where it is there; of columns a CSV file."""
        if not isinstance(given, Mapping):
            path = Path(fspath(given))
            return str(path.absolute()) if path.exists() else fspath(given)
        columns = {name: np.asarray(values, dtype=float).ravel() for name, values in given.items()}
        lengths = {len(values) for values in columns.values()}
        if len(lengths) != 1:
            raise Error(what, "has columns of different length",
                        "as many values in each", "")
        path = self.path(f"{what}.csv")
        with path.open("w", encoding="utf-8") as file:
            file.write(",".join(columns) + "\n")
            for row in zip(*columns.values()):
                file.write(",".join(repr(float(x)) if np.isfinite(x) else "" for x in row) + "\n")
        return str(path)

    def scenario(self, given: FileLike, changes: Mapping[str, Any]) -> tuple[str, str]:
        """(name, changes as text) of a scenario; tracks and PHS models may be dicts themselves."""
        whole = dict(given) if isinstance(given, Mapping) else {}
        name = "" if isinstance(given, Mapping) else fspath(given)
        whole.update({key: value for key, value in changes.items() if value is not None})
        if isinstance(whole.get("friction"), str):
            whole["friction"] = {"condition": whole["friction"]}
        for key in ("track", "phs"):
            if isinstance(whole.get(key), Mapping):
                whole[key] = self.file(key, whole[key])
        return name, to_json(whole) if whole or not name else ""

    def manifest(self, given: FileLike) -> str:
        """A manifest; its data may be columns, its model a dict."""
        if not isinstance(given, Mapping):
            return fspath(given)
        whole = dict(given)
        if isinstance(whole.get("model"), Mapping):
            whole["model"] = self.file("model", whole["model"])
        if "data" in whole:
            whole["data"] = self.table("data", whole["data"])
        if "runs" in whole:
            whole["runs"] = [{**run, "data": self.table(f"data{i}", run["data"])}
                             for i, run in enumerate(whole["runs"])]
        return self.file("manifest", whole)


def data_folder() -> Path:
    """The folder of what ships: bogie_xml/, models/.

    >>> (phs.data_folder() / "models" / "tracks" / "curve_r550.yaml").is_file()
    True
    """
    return Path(_phs.find_data("bogie", "bogie_xml", "phs", [".xml"])).absolute().parent.parent


def result_path(out: Named | None) -> Path | None:
    """The result directory asked for."""
    return Path(out) if out else None


def to_json(value: Mapping[str, Any]) -> str:
    """JSON on one line, which is YAML too; arrays become lists, paths texts.

    >>> to_json({"at_m": np.array([0.5, 1.0]), "n": np.int64(3), "data": Path("a.csv")})
    '{"at_m": [0.5, 1.0], "n": 3, "data": "a.csv"}'
    """
    def plain(item: Any) -> Any:
        if isinstance(item, np.ndarray):
            return item.tolist()
        if isinstance(item, np.generic):
            return item.item()
        if isinstance(item, PathLike):
            return fspath(item)
        if isinstance(item, Mapping):
            return dict(item)
        raise Error("input", f"{type(item).__name__} cannot be written to a file",
                    "numbers, texts, lists, arrays, dicts", "")

    return json.dumps(value if isinstance(value, dict) else dict(value), default=plain)

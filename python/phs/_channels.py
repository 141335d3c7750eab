"""Where the channels of a run come from: the memory of the run just made, or an HDF5 file."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from ._errors import Error, no_such

Array = npt.NDArray[np.float64]


class ChannelSource(Protocol):
    """Names, units and texts at once; values when they are asked for."""

    def described(self) -> dict[str, tuple[str, str]]:
        """{name: (unit, text)} in the order of the columns."""

    def read(self, name: str) -> Array:
        """The values of one channel, read only."""


class MemoryChannels:
    """Of a run just made: views into the memory of the run."""

    def __init__(self, curve: Any, run: int) -> None:
        self._curve, self._run = curve, run
        rows = curve.channels(run)
        self._index = {name: i for i, (name, _, _) in enumerate(rows)}
        self._described = {name: (unit, text) for name, unit, text in rows}

    def described(self) -> dict[str, tuple[str, str]]:
        return self._described

    def read(self, name: str) -> Array:
        values: Array = self._curve.column(self._run, self._index[name])
        return values


class FileChannels:
    """Of an HDF5 file: opened when the first name or value is asked for, each channel read once."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._described: dict[str, tuple[str, str]] | None = None
        self._read: dict[str, Array] = {}

    def _open(self) -> Any:
        import h5py  # only here: a run in memory needs no HDF5

        try:
            return h5py.File(self._path, "r")
        except OSError as fault:
            raise Error(str(self._path), f"cannot be read ({fault})",
                        "the HDF5 file of a run", "") from fault

    def described(self) -> dict[str, tuple[str, str]]:
        if self._described is None:
            with self._open() as file:
                if "channels" not in file:
                    raise Error(str(self._path), "holds no group 'channels'", "a file of phs", "")
                order = {name: _place(dataset)
                         for name, dataset in file["channels"].items()}
                self._described = {
                    name: (_text(file["channels"][name].attrs.get("unit", "")),
                           _text(file["channels"][name].attrs.get("description", "")))
                    for name in sorted(order, key=lambda n: order[n])}
        return self._described

    def read(self, name: str) -> Array:
        if name not in self._read:
            with self._open() as file:
                values = np.asarray(file["channels"][name][()], dtype=np.float64)
            values.flags.writeable = False
            self._read[name] = values
        return self._read[name]


def _text(value: Any) -> str:
    return value.decode() if isinstance(value, bytes) else str(value)


def _place(dataset: Any) -> int:
    """The column of a channel, which the file notes beside it."""
    return int(_text(dataset.attrs.get("index", "0")) or 0)


def find(source: ChannelSource, name: str) -> Array:
    """The channel `name`, or an error that names the nearest one."""
    if name not in source.described():
        raise no_such("channel", name, source.described())
    return source.read(name)

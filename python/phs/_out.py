"""Where results go that come as files."""

from __future__ import annotations

import shutil
import tempfile
import weakref
from os import fspath
from typing import TypeVar

from ._inputs import Named

_Kept = TypeVar("_Kept")


class Out:
    """The result directory asked for, or one of its own that goes with the result."""

    def __init__(self, out: Named | None) -> None:
        self._own = "" if out else tempfile.mkdtemp(prefix="phs-")
        self.name = fspath(out) if out else f"{self._own}/result"

    def __enter__(self) -> Out:
        return self

    def keep(self, result: _Kept) -> _Kept:
        """The directory goes when the result goes."""
        if self._own:
            weakref.finalize(result, shutil.rmtree, self._own, ignore_errors=True)
            self._own = ""
        return result

    def __exit__(self, *_: object) -> None:
        if self._own:
            shutil.rmtree(self._own, ignore_errors=True)

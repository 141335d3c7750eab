"""A call as text, for origin.json beside its result."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike, fspath
from typing import Any

import numpy as np

_LONGEST = 200  # of one argument; what a longer one holds stands among the inputs, with its digest


def called(function: str, *given: Any, **named: Any) -> str:
    """The call as it would be written again; arguments left at None, False or nothing stay away.

    >>> called("run", "curve_r550", bogie="phs", verify=False, out="r", friction=0.2)
    "phs.run('curve_r550', bogie='phs', out='r', friction=0.2)"
    >>> called("modes", {"a": [1.0] * 400}, controller=print)
    "phs.modes({'a': […]}, controller=<print>)"
    """
    words = [_text(value) for value in given]
    words += [f"{name}={_text(value)}" for name, value in named.items() if _is_set(value)]
    return f"phs.{function}({', '.join(words)})"


def _is_set(value: Any) -> bool:
    if value is None or value is False:
        return False
    return not (isinstance(value, (str, Sequence, Mapping)) and len(value) == 0)


def _text(value: Any) -> str:
    if callable(value):
        return f"<{getattr(value, '__name__', type(value).__name__)}>"
    if isinstance(value, PathLike):
        return repr(fspath(value))
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if isinstance(value, np.generic):
        value = value.item()
    text = _items(value)
    if len(text) <= _LONGEST:
        return text
    return "{…}" if isinstance(value, Mapping) else text[0] + "…" + text[-1]


def _items(value: Any) -> str:
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{key!r}: {_text(item)}" for key, item in value.items()) + "}"
    if isinstance(value, Sequence) and not isinstance(value, str):
        return "[" + ", ".join(_text(item) for item in value) + "]"
    return repr(value)

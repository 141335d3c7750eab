"""Errors of the package: one line that says where, what, what is allowed and how to mend it."""

from __future__ import annotations

import difflib
from typing import Iterable


class Error(ValueError):
    """Bad input, or a run that cannot be made.

    >>> raise Error("scenario: friction", "5 is too large", "0.01 to 1", "")
    Traceback (most recent call last):
      ...
    phs.Error: scenario: friction: 5 is too large; allowed: 0.01 to 1
    """

    def __init__(self, where: str, what: str, allowed: str = "", mend: str = "") -> None:
        #: file:line, key or argument
        self.where = where.removeprefix("--")
        #: what is wrong
        self.what = what
        #: what would be accepted
        self.allowed = allowed
        #: what to do
        self.mend = mend
        super().__init__(self.where, what, allowed, mend)

    def __str__(self) -> str:
        line = f"{self.where}: {self.what}" if self.where else self.what
        if self.allowed:
            line += f"; allowed: {self.allowed}"
        if self.mend:
            line += f"; {self.mend}"
        return line


class NoSuchName(Error, KeyError):
    """A name that is not there. Also a KeyError, so that mappings behave as mappings do."""


Error.__module__ = NoSuchName.__module__ = "phs"  # as users know them


def no_such(kind: str, name: object, known: Iterable[str]) -> NoSuchName:
    """The error for a name that is not among `known`, with the nearest one.

    >>> print(no_such("channel", "lead_latral_m", ["lead_lateral_m", "t_s"]))
    channel 'lead_latral_m': is not there; allowed: lead_lateral_m, t_s; did you mean 'lead_lateral_m'?
    """
    names = list(known)
    near = difflib.get_close_matches(str(name), names, n=1)
    shown = names if len(names) <= 12 else names[:12] + [f"… ({len(names)} in all)"]
    return NoSuchName(f"{kind} {name!r}", "is not there", ", ".join(shown),
                      f"did you mean {near[0]!r}?" if near else "")

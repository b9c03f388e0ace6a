"""Studies by name."""

from __future__ import annotations

import importlib
from pathlib import Path

from experiments.errors import unknown
from experiments.generalization.inquiry import Inquiry, inquiry_of

NAMES = (
    "transfer",
    "heterogeneity",
    "actors",
    "newcomers",
    "homes",
    "teachers",
    "drift",
    "robots",
    "cross_play",
    "suite",
    "deep",
    "tuning",
)
"""Each is a module of this package with an `INQUIRY`."""


def inquiry(name: str) -> Inquiry:
    """Returns a study by its name, or by the path of a Python file of one's own.

    Raises:
        ExperimentError: If there is no such study; names the nearest.
    """
    if name.endswith(".py"):
        return inquiry_of(Path(name))
    if name not in NAMES:
        raise unknown("study", name, (*NAMES, "FILE.py"))
    module = importlib.import_module(f"experiments.generalization.{name}")
    found: Inquiry = module.INQUIRY
    return found

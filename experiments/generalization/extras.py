"""What of a study can be run here: networks need the extra `deep`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from importlib.util import find_spec

from experiments.errors import ExperimentError
from experiments.generalization.inquiry import Inquiry
from experiments.phases.records import Phases

PACKAGES = ("torch", "stable_baselines3")
"""Of the extra."""


def runnable(inquiry: Inquiry) -> tuple[Inquiry, str]:
    """Leaves out the networks of a study where the extra is not installed.

    Args:
        inquiry: What is asked.

    Returns:
        What remains, without contrasts that need what is left out; and a line that says
        what that is, empty if it is nothing.

    Raises:
        ExperimentError: If nothing remains.
    """
    if all(find_spec(package) for package in PACKAGES):
        return inquiry, ""
    left_out = [each for each in inquiry.conditions if needs_extra(each)]
    if not left_out:
        return inquiry, ""
    rest = tuple(each for each in inquiry.conditions if not needs_extra(each))
    names = dict.fromkeys(
        each.factors.get("learner", each.name).partition(",")[0] for each in left_out
    )
    line = (
        f"{inquiry.name}: without {' and '.join(names)}, {len(left_out)} of "
        f"{len(inquiry.conditions)} conditions; pip install 'polite-household[deep]' "
        "adds them."
    )
    if not rest:
        raise ExperimentError(line)
    contrasts = tuple(
        each
        for each in inquiry.contrasts
        if _is_there(each.more, rest) and _is_there(each.less, rest)
    )
    return replace(inquiry, conditions=rest, contrasts=contrasts), line


def needs_extra(condition: Phases) -> bool:
    """Whether a condition's learner is a network."""
    return condition.learner.startswith("experiments.deep.")


def _is_there(side: Mapping[str, object], conditions: tuple[Phases, ...]) -> bool:
    """Whether a condition is left whose rows one side of a contrast compares."""
    return any(
        all(factors[name] == side[name] for name in factors if name in side)
        for factors in (each.factors for each in conditions)
    )

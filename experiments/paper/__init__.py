"""The paper's experiments and ours, by number. A new one is a module and a line."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from experiments.errors import unknown
from experiments.paper import e1, e2, e3, e4, e5, e6
from experiments.paper.experiment import Experiment, PaperFigure, comparison

EXPERIMENTS: Mapping[int, Experiment] = {
    module.EXPERIMENT.number: module.EXPERIMENT for module in (e1, e2, e3, e4, e5, e6)
}
"""Every experiment that can be reproduced."""

OF_PAPER = tuple(number for number, one in EXPERIMENTS.items() if one.of_paper)
"""Numbers of those that are the paper's; the factorial and the sensitivity table are
about these."""

__all__ = [
    "EXPERIMENTS",
    "OF_PAPER",
    "Experiment",
    "PaperFigure",
    "comparison",
    "select",
]


def select(numbers: Sequence[int]) -> tuple[Experiment, ...]:
    """Returns experiments by number, in the paper's order; all if none is named.

    Raises:
        ExperimentError: If there is no experiment of that number.
    """
    for number in numbers:
        if number not in EXPERIMENTS:
            raise unknown("experiment", number, EXPERIMENTS)
    return tuple(EXPERIMENTS[number] for number in sorted(set(numbers) or EXPERIMENTS))

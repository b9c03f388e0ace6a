"""What a generalization study is: a question, its conditions, what is expected of them.

A file of one's own is a study if it has an `INQUIRY`:

    household study my_study.py
"""

from __future__ import annotations

import hashlib
import importlib.util
from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec

from experiments.analysis.preregistered import MOST, Contrast, Result
from experiments.errors import ExperimentError
from experiments.phases.records import Phases
from experiments.phases.robots import can_be_kept
from experiments.phases.trial import describe_phases, describe_training, run, train
from experiments.running.study import Study, Trial

if TYPE_CHECKING:
    import polars
    from matplotlib.figure import Figure


@dataclass(frozen=True, kw_only=True)
class Inquiry:
    """A study: settings, build, score and figure."""

    name: str
    """Name of the study, and of its folder."""

    question: str
    """What is asked, in one sentence."""

    conditions: tuple[Phases, ...]
    """What is compared. All have the same factors."""

    contrasts: tuple[Contrast, ...] = ()
    """What is expected, named before it is run; at most 6."""

    seeds: int = 20
    """How many seeds it is run with, unless somebody wants another number."""

    draw: Callable[[polars.DataFrame], Figure] | None = None
    """Draws the study's figure from its table."""

    say: Callable[[polars.DataFrame, tuple[Result, ...]], tuple[str, ...]] | None = None
    """Says what was found in sentences made from the numbers, beside those on the
    contrasts."""

    def __post_init__(self) -> None:
        """Checks contrasts and factors."""
        if len(self.contrasts) > MOST:
            raise ExperimentError(
                f"study {self.name!r}: {len(self.contrasts)} contrasts; allowed: at "
                f"most {MOST}."
            )
        if len({tuple(each.factors) for each in self.conditions}) > 1:
            raise ExperimentError(f"study {self.name!r}: conditions differ in factors.")


def studies(inquiry: Inquiry, seeds: tuple[int, ...]) -> tuple[Study, ...]:
    """Returns what is run for an inquiry: shared trainings first, then all trials.

    Args:
        inquiry: What is asked.
        seeds: Of each condition.
    """
    started = _shared_trainings(inquiry)
    before = f"{inquiry.name}/training"
    distinct = {each.name: each for each in started.values()}

    def start(trial: Trial) -> tuple[str, Trial] | None:
        training = started.get(trial.condition.name)
        if training is None:
            return None
        return before, replace(trial, condition=training)

    trials = Study(
        name=inquiry.name,
        conditions=inquiry.conditions,
        seeds=seeds,
        run=run,
        describe=describe_phases,
        start=start,
    )
    if not distinct:
        return (trials,)
    trainings = Study(
        name=before,
        conditions=tuple(distinct.values()),
        seeds=seeds,
        run=train,
        describe=describe_training,
    )
    return trainings, trials


def _shared_trainings(inquiry: Inquiry) -> Mapping[str, Phases]:
    """Condition -> its training as a condition, where two or more share it."""
    digests = {
        each.name: _digest(each)
        for each in inquiry.conditions
        if can_be_kept(each) and each.training.decisions
    }
    times = Counter(digests.values())
    return {
        each.name: replace(
            each, name=f"{each.learner}-{digests[each.name]}", factors={}
        )
        for each in inquiry.conditions
        if times[digests.get(each.name, "")] > 1
    }


def _digest(condition: Phases) -> str:
    """Short, and the same for conditions that share their training."""
    plain = msgspec.json.encode(describe_training(condition), order="sorted")
    return hashlib.sha256(plain).hexdigest()[:12]


def inquiry_of(file: Path) -> Inquiry:
    """Returns the study that a Python file of one's own holds.

    Raises:
        ExperimentError: If the file cannot be run or has no `INQUIRY`.
    """
    specification = importlib.util.spec_from_file_location(file.stem, file)
    if specification is None or specification.loader is None or not file.is_file():
        raise ExperimentError(f"study {file}: no such Python file.")
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    inquiry = getattr(module, "INQUIRY", None)
    if not isinstance(inquiry, Inquiry):
        raise ExperimentError(
            f"study {file}: has no INQUIRY, an experiments.generalization.Inquiry."
        )
    return inquiry

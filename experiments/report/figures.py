"""Draws all figures of an experiment from its stored results."""

from __future__ import annotations

from pathlib import Path

from experiments import figures
from experiments.paper import EXPERIMENTS, Experiment, comparison
from experiments.report.records import DrawnFigure
from experiments.running.store import Results
from experiments.running.study import Study


def stored_study(experiment: Experiment, results: Results) -> Study:
    """Returns the study with the seeds that it was last prepared for."""
    return experiment.study(tuple(results.read_study()["seeds"]))


def draw(number: int, out: Path) -> tuple[DrawnFigure, ...]:
    """Draws the figures of a finished experiment into `figures`.

    Args:
        number: Of the experiment.
        out: The directory of all results.
    """
    experiment = EXPERIMENTS[number]
    results = Results(out / experiment.name)
    frame = results.read(stored_study(experiment, results))
    parts = [(f.name, f.caption, f.columns(frame)) for f in experiment.figures]
    compared = (
        "All conditions: the sum of all touches, and how many caresses and taps a "
        "minute brings."
    )
    name = f"{experiment.name}_rewards"
    parts.append((name, compared, comparison(experiment, frame)))
    return tuple(
        DrawnFigure(
            name=name,
            caption=caption,
            svgs=figures.inline(columns, name),
            files=figures.save(columns, out / "figures" / name),
        )
        for name, caption, columns in parts
    )

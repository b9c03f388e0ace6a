"""Stores what a study found: findings.json, the table of all trials, the figure."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from experiments.generalization.findings import Findings, findings
from experiments.generalization.inquiry import Inquiry
from experiments.running.files import to_json, write_text, write_whole
from experiments.running.store import Results
from experiments.running.study import Study

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def store(
    inquiry: Inquiry, study: Study, out: Path
) -> tuple[Findings, tuple[Path, ...]]:
    """Analyzes the stored trials of a study and writes what was found.

    Args:
        inquiry: What was asked.
        study: Its trials.
        out: The directory that holds the directory of the study.

    Returns:
        The findings and the files.

    Raises:
        ExperimentError: If a trial is missing or damaged.
    """
    results = Results(out / study.name)
    frame = results.read(study)
    found = findings(inquiry, frame)
    files = [results.directory / "findings.json"]
    write_text(files[0], to_json({"format": 2, "findings": found}))
    if inquiry.draw is not None:
        files += _drawn(inquiry.draw(frame), results.directory)
    return found, tuple(files)


def _drawn(figure: Figure, directory: Path) -> list[Path]:
    files = [directory / "figure.svg", directory / "figure.png"]
    for file in files:
        write_whole(file, partial(_save, figure, file.suffix.removeprefix(".")))
    return files


def _save(figure: Figure, kind: str, path: Path) -> None:
    plain = {"svg": {"Date": None, "Creator": None}, "png": {"Software": None}}
    figure.savefig(path, format=kind, metadata=plain[kind])

"""From stored results to findings, figures, replays and the report.

DIR/experiment_1/...                      the stored trials
DIR/claims.json                           every claim and what came of it
DIR/figures/figure_3.svg, .png, ...       the paper's figures
DIR/replays/experiment_1_seed_12.html     the typical seed, to be looked at; .rrd, .mp4
DIR/report.html                           all of it, in one file
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from experiments.analysis import measures
from experiments.analysis.evaluation import evaluations
from experiments.errors import ExperimentError
from experiments.paper import EXPERIMENTS, Experiment
from experiments.report.beside import Helpers, beside
from experiments.report.figures import draw, stored_study
from experiments.report.html import write_report
from experiments.report.maps import ablation_tables, drawn_maps, teacher_table
from experiments.report.records import Played, Published, Reproduced
from experiments.report.replays import play
from experiments.report.study_tables import summarize_factorial, summarize_sensitivity
from experiments.running.engine import Engine
from experiments.running.files import (
    make_directory,
    remove_remains,
    to_json,
    write_text,
)
from experiments.running.store import Results
from household.replay.web_viewer import place_viewer

Say = Callable[[str], None]
"""Tells people what is going on."""


def publish(
    out: Path, say: Say = lambda doing: None, engine: Engine | None = None
) -> Published:
    """Analyzes all finished experiments in a directory and writes the report.

    Args:
        out: What `household reproduce --out` was given.
        say: Is told what is being done, in a few words.
        engine: Where figures are drawn and trials recorded; None: on each core.

    Raises:
        ExperimentError: If there is no finished experiment.
    """
    finished, unfinished = _finished(out)
    for folder in (out / "figures", out / "replays"):
        make_directory(folder)
        remove_remains(folder)
    with beside(engine) as helpers:
        reproduced = _reproduced(finished, out, helpers, say)
    say("Writing the report")
    published = Published(
        reproduced=reproduced,
        unfinished=unfinished,
        factorial=summarize_factorial(out),
        sensitivity=summarize_sensitivity(
            out, {part.experiment.number: part.frame for part in reproduced}
        ),
        maps=drawn_maps(out),
        ablations=ablation_tables(out),
        teachers=teacher_table(out),
        claims_file=out / "claims.json",
        report_file=out / "report.html",
    )
    plain = [finding.plain() for finding in published.findings]
    write_text(published.claims_file, to_json(plain))
    write_report(published, published.report_file)
    return published


def _reproduced(
    experiments: Sequence[Experiment], out: Path, helpers: Helpers, say: Say
) -> tuple[Reproduced, ...]:
    """Analyzes experiments here, while others draw their figures and record."""
    viewer = helpers.begin("the viewer of replays", place_viewer, out / "replays")
    drawn = {
        each.number: helpers.begin(
            f"figures of experiment {each.number}", draw, each.number, out
        )
        for each in experiments
    }
    analyzed = []
    for each in experiments:
        say(f"Analyzing experiment {each.number}")
        analyzed.append(_analyze(each, out, helpers))
    parts = []
    for number, (part, played) in zip(drawn, analyzed, strict=True):
        say(f"Drawing the figures of experiment {number}")
        figures = drawn[number]()
        say(f"Recording and filming experiment {number}")
        parts.append(part(figures=figures, played=played()))
    viewer()
    return tuple(parts)


def _finished(out: Path) -> tuple[Sequence[Experiment], tuple[str, ...]]:
    finished, unfinished = [], []
    for experiment in EXPERIMENTS.values():
        results = Results(out / experiment.name)
        if not results.study_file.exists():
            continue
        trials = stored_study(experiment, results).trials()
        faults = [fault for trial in trials if (fault := results.fault(trial))]
        if faults:
            unfinished.append(
                f"Experiment {experiment.number} is left out: {len(faults)} of "
                f"{len(trials)} trials are missing or damaged ({faults[0]})."
            )
        else:
            finished.append(experiment)
    if not finished:
        hint = unfinished[0] if unfinished else "No results there."
        raise ExperimentError(f"{out}: nothing to report. {hint}")
    return finished, tuple(unfinished)


def _analyze(
    experiment: Experiment, out: Path, helpers: Helpers
) -> tuple[Callable[..., Reproduced], Callable[[], Played]]:
    """Everything that is computed here, and what waits for the typical trial."""
    results = Results(out / experiment.name)
    study = stored_study(experiment, results)
    frame = results.read(study)
    typical = measures.typical_seed(frame, experiment.reference)
    what = f"the replay of experiment {experiment.number}"
    played = helpers.begin(what, play, experiment.number, typical, out)
    part = partial(
        Reproduced,
        experiment=experiment,
        study=study,
        document=results.read_study(),
        frame=frame,
        findings=experiment.check(frame),
        evaluations=evaluations(
            frame,
            tuple(c.name for c in experiment.all_conditions),
            experiment.target_situations,
            experiment.further,
        ),
        tables=tuple(make(frame) for make in experiment.tables),
        typical_seed=typical,
    )
    return part, played

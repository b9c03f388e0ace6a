"""From stored results to findings, figures, replays and the report.

DIR/experiment_1/...                      the stored trials
DIR/claims.json                           every claim and what came of it
DIR/figures/figure_3.svg, .png, ...       the paper's figures
DIR/replays/experiment_1_seed_12.rrd      the typical seed, to be looked at
DIR/report.html                           all of it, in one file
"""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Future
from pathlib import Path

from experiments.analysis import measures
from experiments.analysis.evaluation import evaluations
from experiments.errors import ExperimentError
from experiments.paper import EXPERIMENTS, Experiment
from experiments.report.figures import draw, stored_study
from experiments.report.html import write_report
from experiments.report.records import DrawnFigure, Published, Reproduced
from experiments.report.study_tables import summarize_factorial, summarize_sensitivity
from experiments.running.engine import ctrl_c_held_back, open_engine, result_of
from experiments.running.replays import record
from experiments.running.store import Results, make_directory, to_json, write_text
from experiments.running.study import Trial


def publish(out: Path) -> Published:
    """Analyzes all finished experiments in a directory and writes the report.

    Args:
        out: What `household reproduce --out` was given.

    Raises:
        ExperimentError: If there is no finished experiment.
    """
    finished, unfinished = _finished(out)
    make_directory(out / "figures")
    make_directory(out / "replays")
    reproduced = _reproduced(finished, out)
    published = Published(
        reproduced=reproduced,
        unfinished=unfinished,
        factorial=summarize_factorial(out),
        sensitivity=summarize_sensitivity(
            out, {part.experiment.number: part.frame for part in reproduced}
        ),
        claims_file=out / "claims.json",
        report_file=out / "report.html",
    )
    plain = [finding.plain() for finding in published.findings]
    write_text(published.claims_file, to_json(plain))
    write_report(published, published.report_file)
    return published


def _reproduced(experiments: Sequence[Experiment], out: Path) -> tuple[Reproduced, ...]:
    """Analyzes experiments here, while other processes draw their figures."""
    executor = open_engine().open()
    try:
        with ctrl_c_held_back():
            drawn = [executor.submit(draw, each.number, out) for each in experiments]
        pairs = zip(experiments, drawn, strict=True)
        return tuple(_analyze(each, out, figures) for each, figures in pairs)
    finally:
        with ctrl_c_held_back():
            executor.shutdown(cancel_futures=True)


def _finished(out: Path) -> tuple[Sequence[Experiment], tuple[str, ...]]:
    finished, unfinished = [], []
    for experiment in EXPERIMENTS.values():
        results = Results(out / experiment.name)
        if not results.study_file.exists():
            continue
        trials = stored_study(experiment, results).trials()
        missing = results.missing(trials)
        if missing:
            unfinished.append(
                f"Experiment {experiment.number} is left out: {len(missing)} of "
                f"{len(trials)} trials are missing."
            )
        else:
            finished.append(experiment)
    if not finished:
        hint = unfinished[0] if unfinished else "No results there."
        raise ExperimentError(f"{out}: nothing to report. {hint}")
    return finished, tuple(unfinished)


def _analyze(
    experiment: Experiment, out: Path, drawn: Future[tuple[DrawnFigure, ...]]
) -> Reproduced:
    results = Results(out / experiment.name)
    study = stored_study(experiment, results)
    frame = results.read(study)
    typical = measures.typical_seed(frame, experiment.reference)
    replay = out / "replays" / f"{experiment.name}_seed_{typical}.rrd"
    condition = experiment.condition(experiment.reference)
    for other in set(replay.parent.glob(f"{experiment.name}_seed_*.rrd")) - {replay}:
        other.unlink()  # typical no more, now that there are other seeds
    if not replay.exists():
        record(Trial(condition=condition, seed=typical), replay)
    return Reproduced(
        experiment=experiment,
        study=study,
        document=results.read_study(),
        frame=frame,
        findings=experiment.check(frame),
        evaluations=evaluations(
            frame,
            tuple(c.name for c in experiment.conditions),
            experiment.target_situations,
            experiment.further,
        ),
        figures=result_of(drawn),
        tables=tuple(make(frame) for make in experiment.tables),
        typical_seed=typical,
        replay=replay,
    )

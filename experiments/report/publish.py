"""From stored results to findings, figures, replays and the report.

DIR/experiment_1/...                      the stored trials
DIR/claims.json                           every claim and what came of it
DIR/figures/figure_3.svg, .png, ...       the paper's figures
DIR/replays/experiment_1_seed_12.rrd      the typical seed, to be looked at
DIR/report.html                           all of it, in one file
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from experiments.analysis import measures
from experiments.analysis.evaluation import evaluations
from experiments.errors import ExperimentError
from experiments.paper import EXPERIMENTS, Experiment
from experiments.report.figures import FiguresOf, drawing, stored_study
from experiments.report.html import write_report
from experiments.report.maps import ablation_tables, drawn_maps, teacher_table
from experiments.report.records import Published, Reproduced
from experiments.report.study_tables import summarize_factorial, summarize_sensitivity
from experiments.running.files import (
    make_directory,
    remove_remains,
    to_json,
    write_text,
)
from experiments.running.replays import record
from experiments.running.store import Results
from experiments.running.study import Trial


def publish(out: Path) -> Published:
    """Analyzes all finished experiments in a directory and writes the report.

    Args:
        out: What `household reproduce --out` was given.

    Raises:
        ExperimentError: If there is no finished experiment.
    """
    finished, unfinished = _finished(out)
    for folder in (out / "figures", out / "replays"):
        make_directory(folder)
        remove_remains(folder)
    reproduced = _reproduced(finished, out)
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
    for part in reproduced:  # last: they are large, and nothing else needs them
        _record(part)
    return published


def _reproduced(experiments: Sequence[Experiment], out: Path) -> tuple[Reproduced, ...]:
    """Analyzes experiments here, while other processes draw their figures."""
    with drawing([each.number for each in experiments], out) as figures_of:
        return tuple(_analyze(each, out, figures_of) for each in experiments)


def _record(part: Reproduced) -> None:
    """Records the typical trial, if that is not there yet."""
    experiment, replay = part.experiment, part.replay
    for other in set(replay.parent.glob(f"{experiment.name}_seed_*.rrd")) - {replay}:
        other.unlink()  # typical no more, now that there are other seeds
    if not replay.exists():
        condition = experiment.condition(experiment.reference)
        record(Trial(condition=condition, seed=part.typical_seed), replay)


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


def _analyze(experiment: Experiment, out: Path, figures_of: FiguresOf) -> Reproduced:
    results = Results(out / experiment.name)
    study = stored_study(experiment, results)
    frame = results.read(study)
    typical = measures.typical_seed(frame, experiment.reference)
    replay = out / "replays" / f"{experiment.name}_seed_{typical}.rrd"
    return Reproduced(
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
        figures=figures_of(experiment.number),
        tables=tuple(make(frame) for make in experiment.tables),
        typical_seed=typical,
        replay=replay,
    )

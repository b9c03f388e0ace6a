"""Maps of claims and 2 x 2 ablations, as far as they were run, for people."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from experiments import figures
from experiments.analysis.claims import Finding
from experiments.analysis.deciding import HOLDS
from experiments.analysis.statistics import Estimate
from experiments.analysis.tables import Cell, Table
from experiments.figures.heat_map import HeatMap, Spot
from experiments.paper import OF_PAPER
from experiments.report.format import (
    VERDICTS,
    finding_threshold,
    finding_value,
    format_interval,
    format_number,
)
from experiments.report.records import (
    AblationSummary,
    DrawnFigure,
    DrawnMap,
    FindingsOfMap,
)
from experiments.running.files import make_directory
from experiments.running.store import Results
from experiments.running.study import Study
from experiments.studies import teachers
from experiments.studies.ablations import ABLATIONS, OUTCOMES, Ablation
from experiments.studies.maps import MAPS, Map, as_text


def drawn_maps(out: Path) -> tuple[DrawnMap, ...]:
    """Draws every map whose trials are all there.

    Args:
        out: The directory of all results; figures are put into its `figures`.
    """
    drawn = []
    for mapped in MAPS.values():
        seeds = _seeds(out, f"maps/{mapped.name}")
        study = mapped.study(seeds) if seeds else None
        if study is not None and _is_whole(out, study):
            found = mapped.findings(Results(out / study.name).read(study))
            drawn.append(_drawn(mapped, found, len(seeds), out))
    return tuple(drawn)


def _drawn(mapped: Map, found: FindingsOfMap, n_seeds: int, out: Path) -> DrawnMap:
    name = f"map_{mapped.name}"
    columns = tuple(_column(mapped, found, id) for id in mapped.ids)
    make_directory(out / "figures")
    figure = DrawnFigure(
        name=name,
        caption=(
            f"{mapped.title}. Experiment {mapped.number}, {mapped.base.name}, "
            f"{n_seeds} seeds in each cell. Framed: the claim holds; ?: undecided. "
            "The dot: the experiment itself."
        ),
        svgs=figures.inline(columns, name),
        files=figures.save(columns, out / "figures" / name),
    )
    return DrawnMap(mapped=mapped, found=found, n_seeds=n_seeds, figure=figure)


def _column(mapped: Map, found: FindingsOfMap, id: str) -> figures.Column:
    chart = heat_map(mapped, found, id)
    claim = found[id, mapped.usual]
    return figures.Column(
        title=f"{id}: {claim.claim.unit}, holds if {finding_threshold(claim)}",
        panels=(
            figures.Panel(label=mapped.up.label, draw=chart.draw, height=chart.height),
        ),
        across=mapped.across.label,
        is_scale=False,
    )


def heat_map(mapped: Map, found: FindingsOfMap, id: str) -> HeatMap:
    """Returns a claim's cells as they are drawn."""
    return HeatMap(
        across=tuple(map(as_text, mapped.across.levels)),
        up=tuple(map(as_text, mapped.up.levels)),
        spots=tuple(
            tuple(
                _spot(found[id, (x, y)], is_usual=(x, y) == mapped.usual)
                for x in mapped.across.levels
            )
            for y in mapped.up.levels
        ),
    )


def _spot(finding: Finding, *, is_usual: bool) -> Spot:
    value = finding.estimate.value
    return Spot(
        text=f"{finding_value(finding)}\n{_sign(finding)}",
        shade=value if value == value else 0.0,
        framed=finding.verdict == HOLDS,
        dotted=is_usual,
    )


def teacher_table(out: Path) -> Table | None:
    """Returns every claim under every teacher, as far as they were run.

    Args:
        out: The directory of all results.
    """
    rows: list[tuple[str, tuple[Cell, ...]]] = []
    n_seeds = 0
    for number in OF_PAPER:
        seeds = _seeds(out, f"maps/teachers_{number}")
        study = teachers.study(number, seeds) if seeds else None
        if study is not None and _is_whole(out, study):
            found = teachers.findings(number, Results(out / study.name).read(study))
            rows += map(_under_each, zip(*found.values(), strict=True))
            n_seeds = len(seeds)
    if not rows:
        return None
    return Table(
        name="teachers",
        title="Claims by teachers",
        header=("claim", *teachers.TEACHERS),
        rows=tuple(rows),
        note=(
            f"{n_seeds} seeds. People give feedback like the teacher that is named "
            "(docs/people.md) and do all else as in the experiment. Framed: another "
            "verdict than with the experiment's own people."
        ),
    )


def _under_each(found: tuple[Finding, ...]) -> tuple[str, tuple[Cell, ...]]:
    """A claim's row: what came of it with each teacher, the own people first."""
    own, claim = found[0].verdict, found[0].claim
    return f"{claim.id}, {claim.condition}, {finding_threshold(found[0])}", tuple(
        Cell(
            text=f"{finding_value(one)} {_sign(one)}",
            shade=0.5 if one.verdict != own else None,
            marked=one.verdict != own,
        )
        for one in found
    )


def _sign(finding: Finding) -> str:
    return VERDICTS[finding.verdict].partition(" ")[0]


def ablation_tables(out: Path) -> tuple[AblationSummary, ...]:
    """Returns every ablation whose trials are all there.

    Args:
        out: The directory of all results.
    """
    found = []
    for ablation in ABLATIONS.values():
        seeds = _seeds(out, f"maps/{ablation.name}")
        study = ablation.study(seeds) if seeds else None
        if study is not None and _is_whole(out, study):
            found.append(_tables(ablation, out, study))
    return tuple(found)


def _tables(ablation: Ablation, out: Path, study: Study) -> AblationSummary:
    frame = Results(out / study.name).read(study)
    first, second = ablation.factors.values()
    rows = tuple(
        (
            f"{one}, {other}".replace("_", " "),
            tuple(
                Cell(
                    text=_with_interval(estimate, outcome),
                    shade=None if outcome == "reward" else estimate.value,
                )
                for outcome in OUTCOMES
                for estimate in (ablation.estimate(frame, outcome, one, other),)
            ),
        )
        for one in first
        for other in second
    )
    effects = {outcome: ablation.effects(frame, outcome) for outcome in OUTCOMES}
    names = tuple(effects["right"])
    what = {
        name: f"{name}: {levels[1]} instead of {levels[0]}"
        for name, levels in ablation.factors.items()
    }
    return AblationSummary(
        table=Table(
            name=ablation.name,
            title=f"{ablation.title}: {' x '.join(ablation.factors)}".replace("_", " "),
            header=(", ".join(ablation.factors).replace("_", " "), *OUTCOMES.values()),
            rows=rows,
            note=f"Mean of {len(study.seeds)} seeds with its 95 % interval.",
        ),
        effects=Table(
            name=f"{ablation.name}_effects",
            title="What each adds",
            header=("difference", *OUTCOMES.values()),
            rows=tuple(
                (
                    what.get(name, f"{name}: more together").replace("_", " "),
                    tuple(_difference(effects, outcome, name) for outcome in OUTCOMES),
                )
                for name in names
            ),
            note=(
                "Paired by seed, averaged over the levels of the other; framed where "
                "the whole interval is on one side of 0. The last row: how much more "
                "the first adds with the second than without it."
            ),
        ),
    )


def _difference(
    effects: Mapping[str, Mapping[str, Estimate]], outcome: str, name: str
) -> Cell:
    estimate = effects[outcome][name]
    return Cell(
        text=_with_interval(estimate, outcome),
        marked=estimate.low > 0.0 or estimate.high < 0.0,
    )


def _with_interval(estimate: Estimate, outcome: str) -> str:
    is_share = outcome != "reward"
    value = format_number(estimate.value, is_share=is_share)
    return f"{value} ({format_interval(estimate, is_share=is_share)})"


def _seeds(out: Path, name: str) -> tuple[int, ...]:
    """The seeds that a study was prepared for; none if it was not."""
    results = Results(out / name)
    if not results.study_file.exists():
        return ()
    return tuple(results.read_study()["seeds"])


def _is_whole(out: Path, study: Study) -> bool:
    return not Results(out / study.name).missing(study.trials())

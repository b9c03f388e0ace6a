"""The report: one HTML file for people; films and pictures lie beside it."""

from __future__ import annotations

from math import nan
from pathlib import Path
from typing import Any

from experiments.analysis.claims import Finding, overall
from experiments.analysis.statistics import Estimate
from experiments.paper.quotes import QUOTES
from experiments.report.format import (
    finding_interval,
    finding_references,
    finding_remarks,
    finding_threshold,
    finding_value,
    format_interval,
    format_number,
    format_verdict,
    tally,
)
from experiments.report.reasons import reasons
from experiments.report.records import FactorialSummary, Played, Published, Reproduced
from experiments.running.files import to_json, write_text

_TEMPLATES = Path(__file__).parent / "templates"


def write_report(published: Published, path: Path) -> None:
    """Writes the report.

    Args:
        published: What came out.
        path: Where to.
    """
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    environment = Environment(
        loader=FileSystemLoader(_TEMPLATES),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters |= {
        "value": finding_value,
        "interval": finding_interval,
        "floor": lambda finding: _reference(finding, finding.floor),
        "ceiling": lambda finding: _reference(finding, finding.ceiling),
        "reasons": reasons,
        "references": finding_references,
        "remarks": finding_remarks,
        "threshold": finding_threshold,
        "verdict": format_verdict,
    }
    template = environment.get_template("report.html.j2")
    write_text(path, template.render(_context(published)))


def _context(published: Published) -> dict[str, Any]:
    ids = dict(sorted(overall(published.findings).items()))
    root = published.report_file.parent
    return {
        "verdicts": ids,
        "of_paper": tally(published.findings_of(paper=True)),
        "own": tally(own) if (own := published.findings_of(paper=False)) else "",
        "unfinished": published.unfinished,
        "parts": [_part(part, root) for part in published.reproduced],
        "factorial": [_factorial(one) for one in published.factorial],
        "silence": _silence(published.factorial),
        "sensitivity": published.sensitivity,
        "maps": published.maps,
        "ablations": published.ablations,
        "teachers": published.teachers,
        "session": published.reproduced[-1].document["sessions"][-1],
    }


def _part(part: Reproduced, root: Path) -> dict[str, Any]:
    return {
        "experiment": part.experiment,
        "claims": _claims(part.findings),
        "figures": part.figures,
        "files": {
            figure.name: [_link(file, root) for file in figure.files]
            for figure in part.figures
        },
        "methods": _methods(part),
        "tables": part.tables,
        "n_seeds": len(part.study.seeds),
        "seeds": _ranges(part.study.seeds),
        "typical_seed": part.typical_seed,
        "played": _played(part.played, root),
        "sessions": part.document["sessions"],
        "configuration": to_json(part.document["configuration"]),
    }


def _played(played: Played, root: Path) -> dict[str, str]:
    """Returns where a trial to be looked at is found from the report."""
    paths = {
        "recording": played.recording,
        "page": played.page,
        "film": played.film,
        "picture": played.picture,
    }
    return {
        what: path.relative_to(root).as_posix() if path else ""
        for what, path in paths.items()
    }


def _link(file: Path, root: Path) -> dict[str, str]:
    """Returns where a file is found from the report, and which kind of file it is."""
    return {
        "path": file.relative_to(root).as_posix(),
        "kind": file.suffix.removeprefix(".").upper(),
    }


def _claims(findings: tuple[Finding, ...]) -> list[dict[str, Any]]:
    """Returns the claims in order of their ids, each with all its conditions."""
    claims: dict[str, dict[str, Any]] = {}
    for finding in sorted(findings, key=lambda one: one.claim.id):
        claim = finding.claim
        entry: dict[str, Any] = {
            "id": claim.id,
            "text": claim.text,
            "reading": claim.reading,
            "quote": QUOTES.get(claim.id),
        }
        known = claims.setdefault(claim.id, entry | {"rows": [], "compared": []})
        known["rows"].append((finding, _scale(finding)))
        known["compared"] += _compared(finding)
    return list(claims.values())


def _reference(finding: Finding, estimate: Estimate | None) -> str:
    """Returns what a reference reaches on the measure of a claim."""
    value = nan if estimate is None else estimate.value
    return format_number(value, is_share=finding.claim.is_share)


def _compared(finding: Finding) -> list[dict[str, str]]:
    """Returns what was measured on other conditions, in words."""
    is_share = finding.claim.is_share
    return [
        {
            "condition": name,
            "value": format_number(estimate.value, is_share=is_share),
            "interval": format_interval(estimate, is_share=is_share),
        }
        for name, estimate in finding.compared.items()
    ]


def _factorial(summary: FactorialSummary) -> dict[str, Any]:
    findings = (*summary.findings, *summary.silence)
    return {"summary": summary, "rows": [(one, _scale(one)) for one in findings]}


def _silence(factorial: tuple[FactorialSummary, ...]) -> dict[str, list[int]]:
    """Returns on which experiments the social rate is better than skip_silence.

    Judged at the paper's levels of the other factors, by the whole interval.
    """
    verdicts: dict[str, list[int]] = {"better": [], "worse": [], "neither": []}
    for summary in factorial:
        estimate = summary.silence[0].estimate
        sign = "neither"
        if estimate.low > 0:
            sign = "better"
        elif estimate.high < 0:
            sign = "worse"
        verdicts[sign].append(summary.number)
    return verdicts


def _methods(part: Reproduced) -> list[dict[str, Any]]:
    """Returns the evaluations as a table: a row per measure, a cell per condition."""
    rows: dict[tuple[str, str], list[dict[str, str]]] = {}
    for one in part.evaluations:
        cell = {
            "condition": one.condition,
            "value": format_number(one.estimate.value, is_share=one.is_share),
            "interval": format_interval(one.estimate, is_share=one.is_share),
        }
        rows.setdefault((one.method, one.measure), []).append(cell)
    return [
        {"method": method, "measure": measure, "cells": cells}
        for (method, measure), cells in rows.items()
    ]


def _scale(finding: Finding) -> dict[str, Any]:
    """Returns where value, interval and threshold lie on a line from 0 to 100."""
    estimate, threshold = finding.estimate, finding.claim.threshold
    references = [one for one in (finding.floor, finding.ceiling) if one is not None]
    points = [estimate.low, estimate.high, estimate.value, threshold, 0.0]
    points += [one.value for one in references]
    known = [point for point in points if point == point]
    low, high = min(known), max(known)
    if finding.claim.is_share and low >= 0.0:
        low, high = 0.0, 1.0
    width = (high - low) or 1.0

    def place(point: float) -> float | None:
        return round(100 * (point - low) / width, 2) if point == point else None

    least = 0.0 if finding.claim.least is None else place(finding.claim.least)
    upper = finding.claim.rule in ("at least", "above")
    return {
        "value": place(estimate.value),
        "low": place(estimate.low),
        "high": place(estimate.high),
        "threshold": place(threshold),
        "wanted": [place(threshold), 100.0] if upper else [least, place(threshold)],
        "references": [place(one.value) for one in references],
    }


def _ranges(seeds: tuple[int, ...]) -> str:
    ordered = sorted(seeds)
    if ordered == list(range(ordered[0], ordered[-1] + 1)):
        return f"{ordered[0]} to {ordered[-1]}"
    return ", ".join(map(str, ordered))

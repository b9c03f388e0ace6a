"""The report's part on generalization: from stored findings to pages for people.

DIR/NAME/findings.json, figure.svg     what `household study NAME --out DIR` wrote
DIR/generalization.html                all of it, in one file
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import msgspec

from experiments.analysis.preregistered import ALPHA
from experiments.errors import ExperimentError
from experiments.generalization.learners import GRID
from experiments.generalization.names import NAMES
from experiments.running.files import write_text
from experiments.studies.people import STUDIES as OTHERS

PAGE = "generalization.html"

FORMAT = 2
"""Of findings.json."""

GRID_STUDY, GRID_CASE = "transfer", {"new": "swap"}
"""Which scores the table of representation and pooling shows, at 0 touches."""

SHOWN = tuple(name for name in NAMES if name != "tuning")
"""The shipped studies that have findings."""

_TEMPLATES = Path(__file__).parent / "templates"


@dataclass(frozen=True, kw_only=True)
class Part:
    """One study as people read it."""

    name: str
    question: str
    seeds: int
    trials: int
    found: tuple[str, ...]
    """Contrasts that came out, as expected or the other way round."""

    not_found: tuple[str, ...]
    """Contrasts that did not."""

    further: tuple[str, ...]
    """What else the numbers say."""

    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    figure: str
    """As SVG; empty without one."""

    @property
    def headline(self) -> str:
        """One sentence to stand under the figure: the first thing that was found."""
        return next(iter(self.found or self.further or self.not_found), "")


def has_studies(directory: Path) -> bool:
    """Whether a directory holds findings of generalization studies."""
    return bool(_studies(directory))


def write_page(directory: Path) -> Path:
    """Writes the page from all studies that a directory holds.

    Returns:
        The page.

    Raises:
        ExperimentError: If there are no findings, or they are damaged.
    """
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    environment = Environment(
        loader=FileSystemLoader(_TEMPLATES),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    template = environment.get_template("generalization.html.j2")
    write_text(directory / PAGE, template.render(context(directory)))
    return directory / PAGE


def context(directory: Path) -> dict[str, Any]:
    """Returns what the page says.

    Args:
        directory: That holds a directory for each study.

    Raises:
        ExperimentError: If there are no findings, or they are damaged.
    """
    documents = {
        name: _read(directory / name / "findings.json") for name in _studies(directory)
    }
    if not documents:
        raise ExperimentError(f"{directory}: no findings of studies there.")
    missing = [name for name in SHOWN if name not in documents]
    return {
        "parts": [
            _part(document, directory / name) for name, document in documents.items()
        ],
        # Who has run studies of its own alone does not ask for ours.
        "missing": missing if len(missing) < len(SHOWN) else [],
        "grid": grid(documents.get(GRID_STUDY)),
    }


def _studies(directory: Path) -> list[str]:
    """Names of the studies whose findings a directory holds: ours, then one's own."""
    there = {file.parent.name for file in directory.glob("*/findings.json")}
    ours = [name for name in SHOWN if name in there]
    return ours + sorted(there - {*NAMES, *OTHERS})


def grid(
    document: Mapping[str, Any] | None,
) -> tuple[Sequence[str], Mapping[str, Sequence[str]]]:
    """Returns the table of results: representation by pooling over people.

    Args:
        document: Findings of the study on transfer; None: an empty table.

    Returns:
        The levels of pooling, and for each representation a score for each level; empty
        where the two do not go together.
    """
    pooling = tuple(dict.fromkeys(level for _, level in GRID.values()))
    scores = {
        one["factors"]["learner"]: one["greedy"]
        for one in (document["conditions"] if document else ())
        if one["touches"] == 0 and GRID_CASE.items() <= one["factors"].items()
    }
    table: dict[str, list[str]] = {}
    for learner, (representation, level) in GRID.items():
        row = table.setdefault(representation, [""] * len(pooling))
        if learner in scores:
            row[pooling.index(level)] = interval(scores[learner])
    return pooling, table


def interval(estimate: Mapping[str, Any]) -> str:
    """Returns a stored estimate with its interval: `0.42 [0.31, 0.50]`."""
    value, low, high = (estimate[key] for key in ("value", "low", "high"))
    if value is None:
        return ""
    if low is None or high is None:
        return f"{value:z.2f}"
    return f"{value:z.2f} [{low:z.2f}, {high:z.2f}]"


def _part(document: Mapping[str, Any], directory: Path) -> Part:
    contrasts = document["contrasts"]
    said = document["sentences"]
    verdicts = [
        "not found" if each["adjusted"] > ALPHA else "found" for each in contrasts
    ]
    by_contrast = list(zip(verdicts, said, strict=False))
    figure = directory / "figure.svg"
    factors = list(document["conditions"][0]["factors"])
    return Part(
        name=document["study"].replace("_", " "),
        question=document["question"],
        seeds=document["seeds"],
        trials=document["trials"],
        found=tuple(text for verdict, text in by_contrast if verdict == "found"),
        not_found=tuple(text for verdict, text in by_contrast if verdict != "found"),
        further=tuple(said[len(contrasts) :]),
        header=(*factors, "touches", "greedy", "as deployed", "best constant"),
        rows=tuple(_row(each) for each in document["conditions"]),
        figure=_inline(figure, document["study"]) if figure.is_file() else "",
    )


def _row(finding: Mapping[str, Any]) -> tuple[str, ...]:
    constant = finding["best_constant"]
    return (
        *finding["factors"].values(),
        str(finding["touches"]),
        interval(finding["greedy"]),
        interval(finding["deployed"]),
        "" if constant is None else f"{constant:.2f}",
    )


def _inline(figure: Path, name: str) -> str:
    """A figure as it can stand in a page beside others."""
    svg = figure.read_text("utf-8")
    body = svg[svg.index("<svg") :]
    body = re.sub(r' (?:width|height)="[\d.]+pt"', "", body, count=2)
    body = re.sub(r"<metadata>.*?</metadata>", "", body, flags=re.DOTALL)
    return re.sub(r'(\bid="|href="#|url\(#)', rf"\g<1>{name}-", body)


def _read(file: Path) -> dict[str, Any]:
    try:
        document: dict[str, Any] = msgspec.json.decode(file.read_bytes(), type=dict)
        found: dict[str, Any] = document["findings"]
    except (OSError, KeyError, msgspec.DecodeError) as error:
        raise ExperimentError(f"{file}: damaged ({error}).") from error
    if document.get("format") != FORMAT:
        raise ExperimentError(f"{file}: of another format; run the study again.")
    return found

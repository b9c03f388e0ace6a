"""The page docs/many_people.md: what a robot must represent.

Run as `python -m experiments.docs_tools.many_people RUNS PAGE` after

    household study crowd --seeds 20 --out RUNS
    household study plenty --seeds 10 --out RUNS
    household study strangers --seeds 20 --out RUNS
"""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from experiments.docs_tools.pages import number, render

FACTORS: Mapping[str, str] = {
    "crowd": "people",
    "plenty": "mistakes",
    "strangers": "heterogeneity",
}
"""Study -> what it varies beside the learner."""

Findings = dict[tuple[str, str], Mapping[str, Any]]
"""By learner and by the level of what a study varies."""


def page(documents: Mapping[str, Sequence[Mapping[str, Any]]]) -> str:
    """Returns the page.

    Args:
        documents: The findings of each study, as stored.
    """
    studies = {name: _by_factor(name, documents[name]) for name in FACTORS}
    actors = studies["crowd"]
    learners = _levels(actors, 0)
    best = max(
        learners,
        key=lambda one: min(actors[one, n]["greedy"]["value"] for n in ("8", "12")),
    )
    ahead = {
        n: actors[best, n]["greedy"]["value"]
        - actors["canonical", n]["greedy"]["value"]
        for n in ("8", "12")
    }
    return render(
        "many_people.md.j2",
        **studies,
        learners=learners,
        **{factor: _levels(studies[name], 1) for name, factor in FACTORS.items()},
        seeds={
            name: max(one["greedy"]["n"] for one in found.values())
            for name, found in studies.items()
        },
        best=best,
        best_8=number(actors[best, "8"]["greedy"]["value"]),
        best_12=number(actors[best, "12"]["greedy"]["value"]),
        ahead_8=number(ahead["8"]),
        ahead_12=number(ahead["12"]),
    )


def _by_factor(study: str, findings: Sequence[Mapping[str, Any]]) -> Findings:
    return {
        (one["factors"]["learner"], one["factors"][FACTORS[study]]): one
        for one in findings
    }


def _levels(findings: Findings, factor: int) -> list[str]:
    """The levels of the learner (0) or of what is varied (1), in order."""
    return list(dict.fromkeys(key[factor] for key in findings))


if __name__ == "__main__":
    runs, out = Path(sys.argv[1]), Path(sys.argv[2])
    stored = {
        name: json.loads((runs / name / "findings.json").read_text("utf-8"))["findings"]
        for name in FACTORS
    }
    out.write_text(page(stored), encoding="utf-8")

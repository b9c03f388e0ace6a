"""The page docs/validation.md: published figures of people beside simulated ones.

Run as `python -m experiments.docs_tools.validation RUNS PAGE` after

    household validate --out RUNS
"""

from __future__ import annotations

import json
import sys
from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import groupby
from pathlib import Path
from typing import Any

from experiments.docs_tools.pages import render

Stored = Mapping[str, Any]
"""A finding as it was stored."""


def page(document: Mapping[str, Any]) -> str:
    """Returns the page.

    Args:
        document: What `household validate` wrote.
    """
    groups: Mapping[str, Sequence[Stored]] = document["groups"]
    everything = [one for group in groups.values() for one in group]
    return render(
        "validation.md.j2",
        groups={name: by_figure(group) for name, group in groups.items()},
        verdicts=Counter(one["verdict"] for one in everything),
        total=len(everything),
    )


def by_figure(group: Sequence[Stored]) -> list[tuple[Stored, list[Stored]]]:
    """Returns each published figure with what was found in every scene.

    Args:
        group: Findings in any order.
    """
    first: dict[str, int] = {}
    for place, one in enumerate(group):
        first.setdefault(one["published"]["name"], place)
    ordered = sorted(group, key=lambda one: first[one["published"]["name"]])
    return [
        (found[0]["published"], found)
        for _, each in groupby(ordered, key=lambda one: one["published"]["name"])
        if (found := list(each))
    ]


if __name__ == "__main__":
    runs, out = Path(sys.argv[1]), Path(sys.argv[2])
    stored = json.loads((runs / "validation.json").read_text("utf-8"))
    out.write_text(page(stored), encoding="utf-8")

"""The page docs/suite.md: every scenario family, its demand and its reference scores.

Run as `python -m experiments.docs_tools.suite RUNS PAGE` after

    household check --suite --out RUNS
    household evaluate random --out RUNS
"""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from experiments.docs_tools.pages import render

REFERENCES = ("random", "best constant", "population", "persona", "lookahead")


def page(suite: Mapping[str, Any], evaluation: Mapping[str, Any]) -> str:
    """Returns the page.

    Args:
        suite: What `household check --suite` wrote.
        evaluation: What `household evaluate random` wrote.
    """
    return render(
        "suite.md.j2",
        suite=suite,
        families=evaluation["evaluation"]["families"],
        seeds=len(evaluation["evaluation"]["seeds"]),
        rows=_rows,
    )


def _rows(family: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Returns the policies of a family's table and what they are called there."""
    best = f"always {family['best_constant']}"
    return [(name, best if name == "best constant" else name) for name in REFERENCES]


if __name__ == "__main__":
    runs, out = Path(sys.argv[1]), Path(sys.argv[2])
    documents = (
        json.loads((runs / f"{name}.json").read_text("utf-8"))
        for name in ("suite", "evaluation")
    )
    out.write_text(page(*documents), encoding="utf-8")

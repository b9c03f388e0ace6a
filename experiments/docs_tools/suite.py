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

from jinja2 import Environment, FileSystemLoader, StrictUndefined

REFERENCES = ("random", "best constant", "population", "persona", "lookahead")


def page(suite: Mapping[str, Any], evaluation: Mapping[str, Any]) -> str:
    """Returns the page.

    Args:
        suite: What `household check --suite` wrote.
        evaluation: What `household evaluate random` wrote.
    """
    templates = FileSystemLoader(Path(__file__).parent / "templates")
    environment = Environment(
        loader=templates, undefined=StrictUndefined, keep_trailing_newline=True
    )
    environment.filters |= {
        "estimate": _estimate,
        "interval": _interval,
        "number": _number,
    }
    return environment.get_template("suite.md.j2").render(
        suite=suite,
        families=evaluation["evaluation"]["families"],
        seeds=len(evaluation["evaluation"]["seeds"]),
        rows=_rows,
    )


def _rows(family: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Returns the policies of a family's table and what they are called there."""
    best = f"always {family['best_constant']}"
    return [(name, best if name == "best constant" else name) for name in REFERENCES]


def _estimate(estimate: Mapping[str, Any]) -> str:
    return f"{_number(estimate['value'])} [{_interval(estimate)}]"


def _interval(estimate: Mapping[str, Any]) -> str:
    if estimate["low"] is None:
        return ""
    return f"{_number(estimate['low'])}, {_number(estimate['high'])}"


def _number(value: float | None) -> str:
    return "" if value is None else f"{value + 0.0:.2f}"


if __name__ == "__main__":
    runs, out = Path(sys.argv[1]), Path(sys.argv[2])
    documents = (
        json.loads((runs / f"{name}.json").read_text("utf-8"))
        for name in ("suite", "evaluation")
    )
    out.write_text(page(*documents), encoding="utf-8")

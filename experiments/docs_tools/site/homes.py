"""A page for each shipped home: plan, spaces, and who lives there in which scenario."""

from __future__ import annotations

import json
from collections import defaultdict
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from experiments.docs_tools.home_scores import SEEDS, Row, rows
from experiments.docs_tools.pages import render
from experiments.docs_tools.site.pages import area, words, write
from household.config.toml import shipped
from household.home.floorplan import load_floorplan
from household.scenario.family import load_family
from household.scenario.reading import read_scenario

if TYPE_CHECKING:
    from household.scenario.scenario import Scenario


def write_homes(folder: Path) -> None:
    """Writes `homes/index.md` and a page for each shipped home.

    Args:
        folder: The site's; its pictures are there already, and in `scores` what
            `experiments.docs_tools.home_scores` stored.
    """
    scores = _scores(folder / "scores" / "scenarios.json")
    plans = [load_floorplan(name) for name in shipped("home")]
    at_home = _scenarios()
    write(folder / "homes" / "index.md", render("homes.md.j2", plans=plans, **TOOLS))
    for plan in plans:
        page = render(
            "home.md.j2",
            plan=plan,
            size=(plan.upper - plan.lower).tolist(),
            scenarios=at_home[plan.name],
            families=_families(plan.name),
            scores=scores,
            seeds=len(SEEDS),
            **TOOLS,
        )
        write(folder / "homes" / f"{plan.name}.md", page)


TOOLS = {"words": words, "area": area}
"""What the templates call."""


def _scenarios() -> Mapping[str, Sequence[Scenario]]:
    """The shipped scenarios, by their home."""
    found: dict[str, list[Scenario]] = defaultdict(list)
    for name in shipped("scenario"):
        scenario = read_scenario(name)
        found[scenario.plan.name].append(scenario)
    return found


def _scores(file: Path) -> Mapping[str, Sequence[Row]]:
    """The reference scores in each scenario; none where none are stored."""
    if not file.exists():
        return {}
    stored = json.loads(file.read_text("utf-8"))
    return {scenario: list(rows(of_seeds)) for scenario, of_seeds in stored.items()}


def _families(home: str) -> Sequence[str]:
    """The families whose households live in it."""
    names = shipped("family")
    return [name for name in names if home in load_family(name).home.shipped]

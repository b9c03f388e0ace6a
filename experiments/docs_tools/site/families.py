"""A page for each scenario family: demand, households, what is polite, scores."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from experiments.docs_tools.pages import render
from experiments.docs_tools.site.pages import area, table_under, words, write
from household.config.toml import shipped
from household.scenario.family import draw, load_family
from household.view.floorplan_svg import draw as draw_plan

if TYPE_CHECKING:
    from household.scenario.family import Family
    from household.scenario.scenario import PersonSpec, Scenario

SEEDS = (0, 1, 2, 3)
"""Households of each family that its page lists; the first one is drawn."""


def write_families(folder: Path) -> None:
    """Writes `families/index.md`, a page for each family, and their pictures.

    Args:
        folder: The site's; its `suite.md` has the scores.
    """
    admission = {
        row["family"]: row
        for row in table_under(folder / "suite.md", "The admission rule")
    }
    scores = _scores(folder / "suite.md")
    families = [load_family(name) for name in shipped("family")]
    index = render("families.md.j2", families=families, words=words)
    write(folder / "families" / "index.md", index)
    for family in families:
        households = [draw(family, seed) for seed in SEEDS]
        pictures = folder / "pictures"
        pictures.mkdir(exist_ok=True)
        draw_plan(households[0].plan, pictures / f"family_{family.name}.svg")
        page = render(
            "family.md.j2",
            family=family,
            words=words,
            polite=polite(family),
            households=list(zip(SEEDS, map(_household, households), strict=True)),
            admission=admission.get(family.name),
            scores=scores.get(family.name, ()),
        )
        write(folder / "families" / f"{family.name}.md", page)


def polite(family: Family) -> Sequence[tuple[str, str, str]]:
    """Returns what people like best: activity, while attending, while absorbed."""
    return [
        (activity, _best(norm.attending), _best(norm.absorbed))
        for activity, norm in family.norms.items()
    ]


def _best(values: Mapping[str, float]) -> str:
    """The behaviors of the highest value."""
    best = max(values.values(), default=0.0)
    return ", ".join(name for name, value in values.items() if value == best)


def _household(scenario: Scenario) -> Mapping[str, object]:
    plan = scenario.plan
    return {
        "rooms": len(plan.rooms),
        "area": sum(area(room) for room in plan.rooms),
        "people": ", ".join(map(_person, scenario.people)),
        "robots": len(scenario.robots),
    }


def _person(person: PersonSpec) -> str:
    """As in "ada (warm)"; the seed in the name of somebody drawn is left out."""
    persona = person.persona
    kind = persona if isinstance(persona, str) else persona.name
    return f"{person.name.split('_')[0]} ({kind})"


def _scores(page: Path) -> Mapping[str, Sequence[Mapping[str, str]]]:
    """The reference scores by family; its name stands in the first of its rows."""
    found: dict[str, list[Mapping[str, str]]] = {}
    name = ""
    for row in table_under(page, "Reference scores"):
        name = row["family"] or name
        found.setdefault(name, []).append(row)
    return found

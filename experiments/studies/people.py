"""What must a robot represent to learn from many people, and to meet new ones?

One robot lives in a household, learns, is frozen and probed. Two studies are on homes
in which every role wants another behavior, one on the shipped norms.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import msgspec

from experiments.phases.norms import BEHAVIORS, HEARD, own_norms
from experiments.running.study import Condition, Study
from experiments.studies.drawn import Households, describe_learner, score
from household.config.toml import packaged, read_toml
from household.scenario.persona import Persona

EXPLORATION: Mapping[str, Any] = {
    "name": "seek_company",
    "among": {"name": "upper_confidence", "width": 0.3},
}
"""How all learners explore, so that they differ in what they represent alone. Upper
confidence was chosen on seeds 1000 to 1005 among softmax (.05, .2, .5), epsilon-greedy
(.1, .3) and upper confidence (.3, .7): best for views within hearing; the others hardly
depend on it. Seeking company came later, when the robot had been alone at 38 % of its
choices (median of seeds 1000 to 1029, 8 people), which it made at random then (nested
views on seeds 1000 to 1079: .73 with it, .63 without)."""

LEARNERS: Mapping[str, tuple[str, Mapping[str, Any]]] = {
    "whole situation": ("designated", {"representation": "named"}),
    "canonical": ("designated", {"representation": "canonical"}),
    "canonical without names": ("designated", {"representation": "nameless"}),
    "set of views": ("designated", {"representation": "view_set"}),
    "views": ("full_sharing", {"representation": "views", "counts": "exposures"}),
    "views within hearing": (
        "full_sharing",
        {"representation": "audible_views", "counts": "exposures"},
    ),
    "views within hearing, nested": (
        "full_sharing",
        {"representation": "nested_views", "counts": "exposures"},
    ),
    "views within hearing, by touches": (
        "full_sharing",
        {"representation": "audible_views", "counts": "touches"},
    ),
    "views within hearing, hierarchical": (
        "hierarchical_thompson",
        {"representation": "audible_views", "counts": "exposures"},
    ),
    "views per person": (
        "full_sharing",
        {"representation": "person_views", "counts": "exposures"},
    ),
}
"""What is represented, and where it is not the usual, what silence teaches and how
people are pooled -> learner of the catalog and its settings. All credit designated
pairs; views are pooled fully, and silence counts as no touch."""

PEOPLE = (1, 2, 4, 8, 12)
HETEROGENEITY = (0.0, 0.25)
MISTAKES = (0.0, 0.1)

HALF_HOUR, CHOICES_5000 = 1_500, 33_000
"""Decisions that a robot learns for: 25 minutes; and as many as 5,000 choices take."""


def _family(
    home: Mapping[str, Any], norms: Mapping[str, Any], persona: Mapping[str, Any]
) -> dict[str, Any]:
    """The households of a study, as plain data."""
    return {
        "name": "many_people",
        "demand": "Do what the people who perceive it want in their roles",
        "home": home,
        "people": [1, 12],
        "personas": [persona],
        "residents": [{"schedule": read_toml(packaged("scenario/schedule.toml"))}],
        "behaviors": list(BEHAVIORS),
        "norms": norms,
        "situation": {"attention": "robot", "hears": HEARD},
    }


def _persona(mistakes: float) -> dict[str, Any]:
    """Somebody with the usual constants of a persona, but for mistakes."""
    persona: dict[str, Any] = msgspec.to_builtins(
        Persona(name="plain", mistakes=mistakes)
    )
    return persona


VILLA: Mapping[str, Any] = {"shipped": ["villa"]}
GENERATED: Mapping[str, Any] = {"rooms": [8, 8], "room_area": [15.0, 15.0]}


def crowd(seeds: tuple[int, ...]) -> tuple[Study, ...]:
    """Returns one study for each number of people: 25 minutes in the villa."""
    return tuple(
        _study(
            f"crowd/{people}",
            Households(
                family=_family(VILLA, own_norms(), _persona(0.0)),
                draw={"n_people": people, "n_robots": 1, "heterogeneity": 0.3},
                decisions=HALF_HOUR,
            ),
            {"people": str(people)},
            seeds,
        )
        for people in PEOPLE
    )


def plenty(seeds: tuple[int, ...]) -> tuple[Study, ...]:
    """Returns one study for each share of mistakes: 5,000 choices with 8 people."""
    return tuple(
        _study(
            f"plenty/mistakes_{mistakes:.2f}",
            Households(
                family=_family(GENERATED, own_norms(), _persona(mistakes)),
                draw={"n_people": 8, "n_robots": 1, "heterogeneity": 0.3},
                decisions=CHOICES_5000,
            ),
            {"mistakes": f"{mistakes:g}"},
            seeds,
        )
        for mistakes in MISTAKES
    )


def strangers(seeds: tuple[int, ...]) -> tuple[Study, ...]:
    """Returns one study for each heterogeneity: frozen, among people with new names."""
    return tuple(
        _study(
            f"strangers/h_{h:.2f}",
            Households(
                family=_family(GENERATED, own_norms(), _persona(0.0)),
                draw={"n_people": 4, "n_robots": 1, "heterogeneity": h},
                decisions=HALF_HOUR,
                anew=("people",),
            ),
            {"heterogeneity": f"{h:g}"},
            seeds,
        )
        for h in HETEROGENEITY
    )


def _folder(name: str) -> str:
    return name.replace(",", "").replace(" ", "_")


def _study(
    study: str,
    households: Households,
    factors: Mapping[str, str],
    seeds: tuple[int, ...],
) -> Study:
    """Every representation in households of one kind."""
    return Study(
        name=study,
        conditions=tuple(
            Condition(
                name=_folder(name),
                scenario="own_norms",
                learner=learner,
                learner_overrides={**settings, "exploration": EXPLORATION},
                factors={"learner": name, **factors},
            )
            for name, (learner, settings) in LEARNERS.items()
        ),
        seeds=seeds,
        run=partial(score, households=households),
        describe=describe_learner,
    )


STUDIES: Mapping[str, Callable[[tuple[int, ...]], tuple[Study, ...]]] = {
    "crowd": crowd,
    "plenty": plenty,
    "strangers": strangers,
}
"""Name -> what is run with which seeds."""

"""What must a robot represent to learn from many people, and to meet new ones?

Three studies on one kind of household: each role wants another behavior, all people by
themselves depart from that by the same share, one robot lives with them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache, partial
from typing import Any

from experiments.running.study import Condition, Study
from experiments.studies.drawn import Households, describe_learner, score

BEHAVIORS = ("sleep", "play", "say_hello", "follow", "ask", "retreat")

WANTED: Mapping[str, str] = {
    "working": "ask",
    "reading": "retreat",
    "sleeping": "sleep",
    "playing": "play",
    "entering": "say_hello",
    "calling": "sleep",
    "unknown": "follow",
}
"""Role -> the behavior that people want in it."""

LIKED, DISLIKED = 0.8, -0.6
"""What a norm gives to the behavior that is wanted, and to all others."""

REPRESENTATIONS: Mapping[str, tuple[str, Mapping[str, Any]]] = {
    "named": ("designated", {"representation": "named"}),
    "canonical": ("designated", {"representation": "canonical"}),
    "nameless": ("designated", {"representation": "nameless"}),
    "view set": ("designated", {"representation": "view_set"}),
    "views": ("expected_touch", {"representation": "views"}),
    "views within hearing": ("expected_touch", {"representation": "audible_views"}),
    "views per person": ("expected_touch", {"representation": "person_views"}),
}
"""Name -> learner of the catalog and its settings."""

PEOPLE = (1, 2, 4, 8, 12)
HETEROGENEITY = (0.0, 0.25)
MISTAKES = (0.0, 0.1)

HALF_HOUR, CHOICES_5000 = 1_500, 33_000
"""Decisions that a robot learns for: 25 minutes; and as many as 5,000 choices take."""


@cache
def _family(home: tuple[tuple[str, Any], ...], mistakes: float) -> dict[str, Any]:
    """The household of all three studies, as plain data."""
    import msgspec

    from household.config.toml import packaged, read_toml
    from household.scenario.persona import Persona

    person = Persona(name="plain", mistakes=mistakes)
    norm = {
        role: {
            behavior: LIKED if behavior == wanted else DISLIKED
            for behavior in BEHAVIORS
        }
        for role, wanted in WANTED.items()
    }
    return {
        "name": "own_norms",
        "demand": "Do what the people who perceive it want in their roles",
        "home": dict(home),
        "people": [1, 12],
        "personas": [msgspec.to_builtins(person)],
        "residents": [{"schedule": read_toml(packaged("scenario/schedule.toml"))}],
        "behaviors": list(BEHAVIORS),
        "norms": {
            role: {"attending": values, "absorbed": values}
            for role, values in norm.items()
        },
        "situation": {"attention": "robot", "hears": 75.0},
    }


VILLA = (("shipped", ("villa",)),)
GENERATED = (("rooms", (8, 8)), ("room_area", (15.0, 15.0)))


def actors(seeds: tuple[int, ...]) -> tuple[Study, ...]:
    """Returns one study for each number of people in the villa."""
    return tuple(
        _study(
            f"actors/{people}",
            Households(
                family=_family(VILLA, 0.0),
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
                family=_family(GENERATED, mistakes),
                draw={"n_people": 8, "n_robots": 1, "heterogeneity": 0.3},
                decisions=CHOICES_5000,
            ),
            {"mistakes": f"{mistakes:g}"},
            seeds,
        )
        for mistakes in MISTAKES
    )


def newcomers(seeds: tuple[int, ...]) -> tuple[Study, ...]:
    """Returns one study for each heterogeneity: frozen, among people with new names."""
    return tuple(
        _study(
            f"newcomers/h_{h:.2f}",
            Households(
                family=_family(GENERATED, 0.0),
                draw={"n_people": 4, "n_robots": 1, "heterogeneity": h},
                decisions=HALF_HOUR,
                anew=("people",),
            ),
            {"heterogeneity": f"{h:g}"},
            seeds,
        )
        for h in HETEROGENEITY
    )


def _study(
    name: str,
    households: Households,
    factors: Mapping[str, str],
    seeds: tuple[int, ...],
) -> Study:
    """Every representation in households of one kind."""
    return Study(
        name=name,
        conditions=tuple(
            Condition(
                name=representation.replace(" ", "_"),
                scenario="own_norms",
                learner=learner,
                learner_overrides=settings,
                factors={"representation": representation, **factors},
            )
            for representation, (learner, settings) in REPRESENTATIONS.items()
        ),
        seeds=seeds,
        run=partial(score, households=households),
        describe=describe_learner,
    )


STUDIES: Mapping[str, Callable[[tuple[int, ...]], tuple[Study, ...]]] = {
    "actors": actors,
    "plenty": plenty,
    "newcomers": newcomers,
}
"""Name -> what is run with which seeds."""

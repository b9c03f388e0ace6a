"""The learners that studies compare: points of a grid of representation and pooling.

All credit designated pairs. How each explores was tuned on the split `validation`, with
the same settings tried for each, and the settings of networks with as many
(`tuning.py`); the winners lie in `tuned.json`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import msgspec

TUNED = Path(__file__).parent / "tuned.json"

Settings = tuple[str, Mapping[str, Any]]


def _situations(representation: str, **further: object) -> Settings:
    return "designated", {"representation": representation, **further}


def _people(representation: str, pooling: str, counts: str = "exposures") -> Settings:
    return "full_sharing", {
        "representation": representation,
        "pooling": pooling,
        "counts": counts,
    }


LEARNERS: Mapping[str, Settings] = {
    "whole situation": _situations("named"),
    "canonical": _situations("canonical"),
    "adaptive analogy": _situations("named", analogy="adaptive"),
    "canonical without names": _situations("nameless"),
    "set of views": _situations("view_set"),
    "views": _people("views", "full"),
    "within hearing, none": _people("audible_views", "none"),
    "within hearing, full": _people("audible_views", "full"),
    "within hearing, hierarchical": _people("audible_views", "hierarchical_rates"),
    "within hearing, adaptive": _people("audible_views", "adaptive"),
    "within hearing, by touches": _people("audible_views", "full", "touches"),
    "nested": _people("nested_views", "full"),
    "per person": _people("person_views", "full"),
}
"""What is represented, and how people are pooled -> learner of the catalog and its
settings. Where it is not said, views are pooled fully, and silence counts as no
touch."""

NETWORKS: Mapping[str, Settings] = {
    "network per person": ("experiments.deep.per_person:network", {}),
    "PPO": ("experiments.deep.ppo:ppo", {"n_epochs": 10}),
}
"""Neural baselines (extra `deep`) -> who makes them, and settings that were not
tuned."""

GRID: Mapping[str, tuple[str, str]] = {
    "whole situation": ("whole situation", "none"),
    "canonical": ("whole situation", "full"),
    "adaptive analogy": ("whole situation", "adaptive"),
    "within hearing, none": ("views within hearing", "none"),
    "within hearing, full": ("views within hearing", "full"),
    "within hearing, hierarchical": ("views within hearing", "hierarchical"),
    "within hearing, adaptive": ("views within hearing", "adaptive"),
    "views": ("views", "full"),
    "set of views": ("set of views", "full"),
    "nested": ("nested views", "full"),
    "per person": ("person's views", "full"),
}
"""Learner -> its place in the table of results: what is represented, and how far people
are taken for alike. A swap of roles is full pooling of whole situations."""

FEW = (
    "whole situation",
    "canonical",
    "adaptive analogy",
    "within hearing, none",
    "within hearing, full",
    "within hearing, hierarchical",
    "within hearing, adaptive",
    "nested",
)
"""For studies that vary much else: one of each kind."""

REFERENCES = ("random", "persona", "population")


def slug(name: str) -> str:
    """Returns a name as it can be a folder."""
    return name.replace(",", "").replace(" ", "_").lower()


def settings(names: Iterable[str] = LEARNERS) -> dict[str, Settings]:
    """Returns learners by name with their settings, as they were tuned."""
    return {name: with_setting(name, tuned()[name]) for name in names}


def with_setting(name: str, setting: Mapping[str, Any]) -> Settings:
    """Returns a learner with what is tuned: a table's exploration, all of a network."""
    if name in NETWORKS:
        learner, further = NETWORKS[name]
        return learner, {**further, **setting}
    learner, further = LEARNERS[name]
    return learner, {**further, "exploration": dict(setting)}


@cache
def tuned() -> Mapping[str, Mapping[str, Any]]:
    """Returns how each table explores, and the settings of each network."""
    document = msgspec.json.decode(TUNED.read_bytes())
    winners: Mapping[str, Mapping[str, Any]] = document["winners"]
    return winners

"""Frames: what observations have room for, so that households can share one layout."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from household.compiled.arrays import Indices
from household.scenario.scenario import Scenario

CLOSE = ("near", "hears")
"""Relations to the robot that a scenario may choose, as `SituationModel` calls them."""


@dataclass(frozen=True, slots=True)
class Frame:
    """What observations have room for.

    Attributes:
        people: Slots for people.
        robots: Slots for robots, the one that observes included.
        behaviors: What any of the robots can choose, in the order of their numbers.
        close: Which relations of `CLOSE` are observed.
    """

    people: int
    robots: int
    behaviors: tuple[str, ...]
    close: tuple[str, ...]

    def codes(self, behaviors: Sequence[str]) -> Indices:
        """The number of each of a household's own behaviors."""
        return np.array([self.behaviors.index(name) for name in behaviors], np.intp)


def frame_of(scenario: Scenario) -> Frame:
    """What a scenario asks for."""
    return Frame(
        people=scenario.slots.people or len(scenario.people),
        robots=scenario.slots.robots or len(scenario.robots),
        behaviors=scenario.behaviors,
        close=close_of(scenario),
    )


def common_frame(scenarios: Sequence[Scenario]) -> Frame:
    """The smallest frame that has room for all of some scenarios."""
    frames = [frame_of(scenario) for scenario in scenarios]
    named = dict.fromkeys(name for frame in frames for name in frame.behaviors)
    return Frame(
        people=max(frame.people for frame in frames),
        robots=max(frame.robots for frame in frames),
        behaviors=tuple(named),
        close=tuple(n for n in CLOSE if any(n in frame.close for frame in frames)),
    )


def close_of(scenario: Scenario) -> tuple[str, ...]:
    """Which of the relations in `CLOSE` situations hold."""
    model = scenario.situation
    return tuple(name for name in CLOSE if getattr(model, name) is not None)

"""Households of any size, and what steps them."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from itertools import cycle, islice
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from household.environment import Household
    from household.home.floorplan import FloorPlan

APART = 0.7
"""Least distance between robots at the beginning [m]."""

FOREVER = 10**9
"""Decisions in an episode that does not end."""


BEINGS = 6
"""Four people and two robots of the usual household; as many as the peers move."""


def evening() -> Household:
    """Returns the usual household, of four people and two robots."""
    from household import household_v0

    return household_v0.parallel_env("evening", max_cycles=FOREVER)


def household(
    n_people: int, n_robots: int, home: str | FloorPlan = "villa"
) -> Household:
    """Returns a household with people of all shipped personas.

    Args:
        n_people: 1 to 64.
        n_robots: 1 to 16.
        home: Where they live.
    """
    from household import household_v0
    from household.config.toml import shipped

    personas = islice(cycle(sorted(shipped("persona"))), n_people)
    people = [{"name": f"p{i}", "persona": kind} for i, kind in enumerate(personas)]
    robots = [{"position": spot} for spot in _spots(home, n_robots)]
    return household_v0.parallel_env(
        "evening", home=home, people=people, robots=robots, max_cycles=FOREVER
    )


def _spots(home: str | FloorPlan, n: int) -> list[tuple[float, float]]:
    """Places for robots, spread over the home by chance, always the same."""
    from household.home.floorplan import FloorPlan, load_floorplan
    from household.home.navigation.routes import routes_of

    plan = home if isinstance(home, FloorPlan) else load_floorplan(home)
    routes, entrance = routes_of(plan), np.array(plan.regions[0].center)
    spots: list[tuple[float, float]] = []
    for x, y in np.random.default_rng(0).permutation(routes.centers()).tolist():
        apart = all(math.dist((x, y), other) >= APART for other in spots)
        if apart and routes.connects(np.array([x, y]), entrance):
            spots.append((x, y))
            if len(spots) == n:
                break
    return spots


DRAWN = 5000
"""Steps for which actions are drawn; afterwards the same actions come again."""


@dataclass
class Stepping:
    """Steps a parallel environment with random actions, one step for each call.

    Every agent gets another action in every step.
    """

    env: Any
    """A PettingZoo parallel environment, also inside wrappers."""

    rng: np.random.Generator = field(default_factory=lambda: np.random.default_rng(0))
    """Draws the actions."""

    def __post_init__(self) -> None:
        """Begins an episode."""
        self.env.reset(seed=0)
        self._actions = cycle(self._drawn())

    def _drawn(self) -> list[dict[str, int]]:
        """Returns the actions of each step."""
        agents = self.env.agents
        actions = self.env.action_space(agents[0]).n
        rows = self.rng.integers(actions, size=(DRAWN, len(agents))).tolist()
        return [dict(zip(agents, row, strict=True)) for row in rows]

    def __call__(self) -> None:
        """Makes a step."""
        self.env.step(next(self._actions))


@dataclass
class PatientStepping(Stepping):
    """Steps a household in which robots finish what they do, as learning robots do.

    A robot that goes on with its behavior gets no action.
    """

    def _drawn(self) -> list[dict[str, int]]:
        """Returns the actions of each step, from how long every behavior takes."""
        scenario = self.env.unwrapped.scenario
        takes = [
            math.ceil(b.duration / scenario.decision_period)
            for b in scenario.repertoire
        ]
        steps: list[dict[str, int]] = [{} for _ in range(DRAWN)]
        for agent in self.env.agents:
            step = 0
            while step < DRAWN:
                behavior = int(self.rng.integers(len(takes)))
                steps[step][agent] = behavior
                step += takes[behavior]
        return steps

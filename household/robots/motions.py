"""Motions: where a robot goes while it does a behavior.

Each motion is a function of a robot and the crowd, called once in each decision period:
it may send the robot somewhere or turn it.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from household.compiled.arrays import Floats
from household.compiled.jit import compiled
from household.motion.crowd import Crowd
from household.scenario.behavior import Motion

COMPANY = 0.9
"""Distance at which a robot that follows someone stops [m]."""

SPIN = math.radians(90.0)
"""How far a dancing robot turns in one second [rad]."""

STROLL = 2.0
"""How far a wandering robot walks in one direction at most [m]."""


@dataclass(slots=True)
class Mover:
    """A robot that moves.

    Attributes:
        body: Index of its body in the crowd; people come before robots.
        n_people: How many people there are.
        spots: Middles of the activity regions, shape (n_regions, 2) [m].
        rng: The robot's own random stream.
        period: Between two calls [s].
        begins: Whether the behavior begins in this decision period.
    """

    body: int
    n_people: int
    spots: Floats
    rng: np.random.Generator
    period: float
    begins: bool = False


def still(mover: Mover, crowd: Crowd) -> None:
    """Stays where it is."""
    if mover.begins:
        crowd.halt(mover.body)


def spin(mover: Mover, crowd: Crowd) -> None:
    """Turns on the spot."""
    still(mover, crowd)
    crowd.heading[mover.body] += SPIN * mover.period


def wander(mover: Mover, crowd: Crowd) -> None:
    """Strolls from point to point."""
    if mover.begins or not crowd.walks(mover.body):
        turn, share = mover.rng.random(2).tolist()
        angle, reach = 2 * math.pi * turn, 0.5 + (STROLL - 0.5) * share
        x, y = crowd.where[mover.body]
        goal = (x + reach * math.cos(angle), y + reach * math.sin(angle))
        crowd.send(mover.body, goal)


def follow(mover: Mover, crowd: Crowd) -> None:
    """Keeps close to the nearest person."""
    person = _nearest(crowd.position, mover.body, mover.n_people)
    goal = crowd.where[person]
    if math.dist(goal, crowd.where[mover.body]) <= COMPANY:
        crowd.halt(mover.body)
    elif not crowd.is_bound_for(mover.body, goal):
        crowd.send(mover.body, goal)


def retreat(mover: Mover, crowd: Crowd) -> None:
    """Goes to the activity region that is farthest from everybody."""
    if mover.begins:
        spot = _loneliest(mover.spots, crowd.position, mover.n_people)
        x, y = mover.spots[spot].tolist()
        crowd.send(mover.body, (x, y))


def fetch(mover: Mover, crowd: Crowd) -> None:
    """Goes to some activity region, then to the nearest person."""
    if mover.begins:
        x, y = mover.spots[mover.rng.integers(len(mover.spots))].tolist()
        crowd.send(mover.body, (x, y))
    elif not crowd.walks(mover.body):
        follow(mover, crowd)


@compiled
def _nearest(position: Floats, body: int, n_people: int) -> int:
    """Index of the person that is nearest to a body."""
    nearest, least = 0, np.inf
    for i in range(n_people):
        dx, dy = position[i, 0] - position[body, 0], position[i, 1] - position[body, 1]
        if dx * dx + dy * dy < least:
            nearest, least = i, dx * dx + dy * dy
    return nearest


@compiled
def _loneliest(spots: Floats, position: Floats, n_people: int) -> int:
    """Index of the spot that is farthest from the person nearest to it."""
    loneliest, most = 0, -1.0
    for k in range(len(spots)):
        away = np.inf
        for i in range(n_people):
            dx, dy = spots[k, 0] - position[i, 0], spots[k, 1] - position[i, 1]
            away = min(away, dx * dx + dy * dy)
        if away > most:
            loneliest, most = k, away
    return loneliest


MOTIONS: dict[Motion, Callable[[Mover, Crowd], None]] = {
    "still": still,
    "spin": spin,
    "wander": wander,
    "follow": follow,
    "retreat": retreat,
    "fetch": fetch,
}

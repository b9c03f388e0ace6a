"""Noticing: what a robot saw of somebody who comes to touch it.

Robots know where people are and where they look (docs/deviations.md, 15), not what they
think. So that somebody came is read off where bodies were, never off the moment at
which a person made up its mind; and a movement is noticed late and not exactly.
"""

import math
from collections.abc import Sequence
from typing import Annotated

import numpy as np

from household.compiled.arrays import Floats
from household.compiled.jit import bind, compiled
from household.scenario.scenario import PerceptionModel
from household.state import Stateful

LOOKS_BACK, MOST = 60.0, 600
"""How far back a robot remembers where people were [s], and so many moments at most."""

STANDS = 0.1
"""Up to this speed a body counts as standing, such as one that others push [m/s]; the
slowest people walk at 0.46 m/s (RiMEA's guideline)."""


class Noticing(Stateful):
    """Remembers where everybody was, and when the robots noticed what.

    Args:
        model: How late and how exactly a movement is noticed.
        n: How many people and robots there are.
        period: Time between two moments [s].
    """

    STATE = ("_track", "_decision", "_rngs")

    def __init__(self, model: PerceptionModel, n: int, period: float) -> None:
        self._late, self._noise = model.notice_delay, model.notice_noise
        self._period, self._decision = period, 0
        # A ring: the newest moment takes the place of the oldest.
        self._track = np.zeros((min(math.ceil(LOOKS_BACK / period), MOST), n, 2))
        self._length = len(self._track)
        self._coming_for = bind(_coming_for, self._track, period)
        self._rngs: list[np.random.Generator] = []

    def begin(self, rngs: Sequence[np.random.Generator]) -> None:
        """Begins a new episode.

        Args:
            rngs: A stream for each person.
        """
        self._rngs = list(rngs)

    def remember(self, decision: int, position: Floats) -> None:
        """Remembers where everybody is.

        Args:
            decision: Which moment it is, from 0.
            position: Shape (n, 2) [m].
        """
        self._decision = decision
        self._track[decision % self._length] = position

    def touch(
        self, person: int, robot: int, position: Floats, now: float, attends: float
    ) -> tuple[float | None, float | None]:
        """When a robot that is touched noticed what led to it.

        Args:
            person: Index of who touches it.
            robot: Index of its body, among people and robots.
            position: Where everybody is, shape (n, 2) [m].
            now: [s], after the last moment that was remembered.
            attends: Since when the person turns to the robot, NaN if it does not [s].

        Returns:
            When it noticed that the person came, None if it did not come walking; and
            that the person turned to it, None if it does not attend [s].
        """
        decision, period = self._decision, self._period
        elapsed = now - decision * period
        periods = self._coming_for(decision, person, robot, position, elapsed)
        rng = self._rngs[person]
        # Both are always drawn, so that one shifts nothing of the other.
        approach, turn = rng.standard_normal(), rng.standard_normal()
        came = math.nan if periods < 0 else (decision - periods) * period
        return self._noticed(came, approach, now), self._noticed(attends, turn, now)

    def _noticed(self, when: float, error: float, now: float) -> float | None:
        """When a movement was noticed, at the latest now."""
        if math.isnan(when):
            return None
        return min(max(float(when) + self._late + self._noise * error, 0.0), now)


@compiled
def _coming_for(
    track: Annotated[Floats, "n_moments", "n", 2],
    period: float,
    decision: int,
    i: int,
    j: int,
    position: Annotated[Floats, "n", 2],
    elapsed: float,
) -> int:
    """For how many whole periods, before the present one, somebody has been coming.

    It comes as long as it walks and gets nearer to where the robot was. Who goes the
    other way at first, to get around something, is not seen coming before it turns.

    Args:
        track: Where everybody was at the moments until now, a ring.
        period: Between these moments [s].
        decision: The latest of them.
        i: Index of the person.
        j: Index of the robot's body.
        position: Where everybody is now, shape (n, 2) [m].
        elapsed: Time since the latest moment [s].

    Returns:
        0 if it set out at the latest moment, -1 if it does not come at all.
    """
    x, y = position[i]
    periods, lasted = -1, elapsed
    for k in range(min(decision + 1, len(track))):
        where = track[(decision - k) % len(track)]
        before = math.hypot(where[j, 0] - where[i, 0], where[j, 1] - where[i, 1])
        after = math.hypot(where[j, 0] - x, where[j, 1] - y)
        walked = math.hypot(x - where[i, 0], y - where[i, 1])
        if walked <= STANDS * lasted or after >= before:
            break
        periods, lasted = k, period
        x, y = where[i]
    return periods

"""Reading situations off activities and attention, as each robot sees them."""

from functools import lru_cache
from itertools import product

import numpy as np
from numpy.typing import NDArray

from household.activity import ACTIVITY_NAMES
from household.compiled.arrays import Mask
from household.perception.canonical import Relation
from household.perception.proximity import Close
from household.perception.situation import Situation
from household.scenario.scenario import Scenario

KEPT = 1024
"""How many situations, and how many parts of them, are cached, as they recur."""


class SituationReader:
    """Composes the situation that each robot sees.

    Args:
        scenario: Names everybody, and says which relations situations hold.
    """

    def __init__(self, scenario: Scenario) -> None:
        self._people, robots = scenario.person_names, scenario.robot_names
        self._robots, model = robots, scenario.situation
        self._attention = model.attention
        self._has_close = model.near is not None or model.hears is not None
        # Who may play what, sorted by name.
        self._parts = [
            (i, [(name, role) for role in ACTIVITY_NAMES])
            for name, i in sorted((name, i) for i, name in enumerate(self._people))
        ]
        # The possible relations, in the order of the bytes of `_looks`: for each robot,
        # or once for all of them where they see the same.
        everybody = (*self._people, *robots)
        relations: dict[str, list[list[Relation]]] = {
            "none": [[]],
            "robot": [list(product(self._people, [robot])) for robot in robots],
            "all": [list(product(everybody, everybody))],
        }
        self._relations = relations[self._attention]
        self._alike = len(robots) // len(self._relations)
        self._plays = lru_cache(maxsize=KEPT)(self._make_plays)
        self._held = lru_cache(maxsize=KEPT)(self._find_held)
        self._situations = lru_cache(maxsize=KEPT)(self._make_situations)

    def seen(
        self, activity: NDArray[np.int_], attends: Mask, close: Close | None = None
    ) -> tuple[Situation, ...]:
        """The situation as each robot sees it.

        Args:
            activity: The role of each person, shape (n_people,).
            attends: Who attends to whom, people first, shape (n, n).
            close: Who is near the robots and who would hear them; None: nobody.
        """
        roles, looks = activity.tobytes(), self._looks(attends)
        if not self._has_close or close is None:
            return self._situations(roles, looks)
        near, hears = close.near.tobytes("F"), close.hears.tobytes("F")
        return self._situations(roles, looks, near, hears)

    def _looks(self, attends: Mask) -> bytes:
        """Which of the possible relations hold, one byte for each."""
        if self._attention == "robot":
            n = len(self._people)
            return attends[:n, n:].tobytes("F")
        return attends.tobytes() if self._attention == "all" else b""

    def _make_situations(
        self, activity: bytes, looks: bytes, near: bytes = b"", hears: bytes = b""
    ) -> tuple[Situation, ...]:
        """The situation of each robot."""
        if near or hears:
            far = self._make_situations(activity, looks)
            return tuple(
                Situation(
                    each.plays,
                    each.attends,
                    self._find_close(near, robot),
                    self._find_close(hears, robot),
                )
                for robot, each in enumerate(far)
            )
        size, plays = len(self._relations[0]), self._plays(activity)
        seen = [
            Situation(plays, self._held(looks[size * view : size * (view + 1)], view))
            for view in range(len(self._relations))
        ]
        return tuple(seen * self._alike)

    def _find_close(self, holds: bytes, robot: int) -> frozenset[Relation]:
        """Pairs of people and one robot for which a relation holds."""
        n = len(self._people)
        held = zip(self._people, holds[n * robot : n * (robot + 1)], strict=True)
        return frozenset((name, self._robots[robot]) for name, is_so in held if is_so)

    def _find_held(self, looks: bytes, view: int) -> frozenset[Relation]:
        """The relations that hold, as seen from one point of view."""
        relations = self._relations[view]
        # Few of them hold: to look for those is faster than to go through all.
        held, at = [], looks.find(1)
        while at >= 0:
            held.append(relations[at])
            at = looks.find(1, at + 1)
        return frozenset(held)

    def _make_plays(self, activity: bytes) -> tuple[tuple[str, str], ...]:
        """Who plays which role, as situations have it."""
        roles = np.frombuffer(activity, np.int_).tolist()
        return tuple([parts[roles[i]] for i, parts in self._parts])

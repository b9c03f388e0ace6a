"""Reading situations off activities and attention, as each robot sees them."""

from collections.abc import Callable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from household.activity import ACTIVITY_NAMES
from household.perception.situation import Situation
from household.scenario import Scenario

Mask = NDArray[np.bool_]

KEPT = 4096
"""So many situations are remembered: they recur, and each is put together once."""

LOOKS: dict[str, Callable[[Mask, int, int], Mask]] = {
    "none": lambda attends, n_people, target: attends[:0],
    "robot": lambda attends, n_people, target: attends[:n_people, target],
    "all": lambda attends, n_people, target: attends,
}
"""Who attends to whom in situations, by the scenario's name for it."""


class SituationReader:
    """Puts the situation together that each robot sees.

    Args:
        scenario: Names everybody, and says which relations situations hold.
    """

    def __init__(self, scenario: Scenario) -> None:
        self._names = (*scenario.person_names, *scenario.robot_names)
        self._n_people = len(scenario.people)
        self._attention = scenario.situation.attention
        self._looks = LOOKS[self._attention]
        self._plays = lru_cache(maxsize=KEPT)(self._make_plays)
        self._situation = lru_cache(maxsize=KEPT)(self._make_situation)

    def seen_by(
        self, robot: int, activity: NDArray[np.int_], attends: Mask
    ) -> Situation:
        """The situation as one robot sees it.

        Args:
            robot: Index of the robot.
            activity: The role of each person, shape (n_people,).
            attends: Who attends to whom, people first, shape (n, n).
        """
        target = self._n_people + robot
        looks = self._looks(attends, self._n_people, target)
        return self._situation(activity.tobytes(), looks.tobytes(), target)

    def _make_situation(
        self, activity: bytes, attends: bytes, target: int
    ) -> Situation:
        """The situation that these roles and this attention make."""
        names = self._names
        relations = np.flatnonzero(np.frombuffer(attends, np.bool_)).tolist()
        if self._attention == "all":
            pairs = [divmod(pair, len(names)) for pair in relations]
        else:
            pairs = [(observer, target) for observer in relations]
        attended = frozenset((names[i], names[j]) for i, j in pairs)
        return Situation(self._plays(activity), attended)

    def _make_plays(self, activity: bytes) -> tuple[tuple[str, str], ...]:
        """Who plays which role, as situations have it."""
        roles = [ACTIVITY_NAMES[role] for role in np.frombuffer(activity, np.int_)]
        return Situation.of(dict(zip(self._names, roles, strict=False))).plays

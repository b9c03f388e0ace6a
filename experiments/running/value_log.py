"""The Q-values of the situations that a robot met, as they were last looked at."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from household.perception.situation import Situation
from learners.learner import Learner

Predicate = Callable[[Situation], bool]
"""Tells whether a situation is one that is meant."""


class ValueLog:
    """Looks at Q-values where they may matter, and finds what has changed.

    Args:
        followed: Situations that are looked at each time, once they were met.
    """

    def __init__(self, followed: Sequence[Predicate] = ()) -> None:
        self._is_followed = followed
        self._followed: list[Situation] = []
        self._values: dict[Situation, list[float]] = {}

    def values(self, learner: Learner, situation: Situation) -> list[float]:
        """Returns the values of a situation as last seen; one never met is met now."""
        known = self._values.get(situation)
        return self._meet(learner, situation) if known is None else known

    def changes(
        self, learner: Learner, situations: Iterable[Situation]
    ) -> Iterator[tuple[Situation, int, float]]:
        """Looks at some situations and at the followed ones.

        Yields:
            Situation, behavior and value of each Q-value that is not what it was.
        """
        for situation in dict.fromkeys([*situations, *self._followed]):
            before = self._values.get(situation)
            if before is None:
                self._meet(learner, situation)
                continue
            values = learner.q_values(situation).tolist()
            if values == before:
                continue
            self._values[situation] = values
            for behavior, (value, old) in enumerate(zip(values, before, strict=True)):
                if value != old:
                    yield situation, behavior, value

    def all_changes(self, learner: Learner) -> Iterator[tuple[Situation, int, float]]:
        """Looks at every situation that was met."""
        return self.changes(learner, list(self._values))

    def _meet(self, learner: Learner, situation: Situation) -> list[float]:
        values: list[float] = learner.q_values(situation).tolist()
        self._values[situation] = values
        if any(is_followed(situation) for is_followed in self._is_followed):
            self._followed.append(situation)
        return values

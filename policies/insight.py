"""Insight: what a learner knows as it chooses, and from which touches it knows that."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from dataclasses import dataclass, field
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from household.perception.situation import Situation
from learners.exploration import chances
from learners.learner import Credit, Learner
from learners.representation.parts import Part
from learners.representation.situations import Named
from learners.tabular.base import CreditedLearner
from learners.team import Member

Numbers = NDArray[np.float64]


class Insight(NamedTuple):
    """What a learner knows in a situation.

    Attributes:
        represented: What it takes the situation for, in words; empty: for itself.
        values: What it expects of each behavior, shape (n_behaviors,).
        probabilities: Chance of each, (n_behaviors,); None: not known.
        touches: How many touches taught each, (n_behaviors,); None: not known.
        updates: Updates behind each value, (n_behaviors,); None: not known.
        taught: The last touch that taught it something of this, in words.
        is_first: Whether something in it is met for the first time.
        before: What was best here when it was last met; -1: the same, or nothing.
    """

    represented: str
    values: Numbers
    probabilities: Numbers | None
    touches: Numbers | None
    updates: Numbers | None
    taught: str
    is_first: bool
    before: int


Key = tuple[Hashable, Hashable]
"""A part's key and person."""


@dataclass
class Lesson:
    """What touches taught of one part.

    Attributes:
        touches: How many, by behavior.
        last: Count of all touches when the last one came, and the touch in words.
    """

    touches: Numbers
    last: tuple[int, str] = (0, "")


@dataclass
class Insights:
    """Remembers, for each table, which touches taught what.

    Reading never changes a learner.

    Attributes:
        behaviors: Names of the behaviors.
    """

    behaviors: tuple[str, ...]
    _lessons: dict[int, dict[Key, Lesson]] = field(default_factory=dict)
    _met: dict[str, dict[tuple[Part, ...], int]] = field(default_factory=dict)
    _known: dict[str, set[Hashable]] = field(default_factory=dict)
    _count: int = 0

    def learned(self, learner: Learner, credits: Iterable[Credit]) -> None:
        """Notes what a learner has just made of its touches."""
        core = _core(learner)
        if not isinstance(core, CreditedLearner):
            return
        lessons = self._lessons.setdefault(id(core.table), {})
        for credit in credits:
            if credit.reward is None:
                continue
            self._count += 1
            text = self._told(credit)
            taught = {
                ((part.key, part.person), entry.action)
                for entry, _ in credit.shares
                for part in core.representation.parts(entry.state)
                if part.person in (None, credit.reward.giver)
            }
            for key, action in taught:
                fresh = Lesson(np.zeros(len(self.behaviors)))
                lesson = lessons.setdefault(key, fresh)
                lesson.touches[action] += 1.0
                lesson.last = (self._count, text)

    def of(self, robot: str, learner: Learner, state: Hashable) -> Insight:
        """What a robot's learner knows in a situation.

        Args:
            robot: Its name.
            learner: Its learner.
            state: The situation.
        """
        core = _core(learner)
        if isinstance(learner, Member):
            state = learner.common(state)
        values = core.q_values(state)
        if not isinstance(core, CreditedLearner):
            return Insight("", values, None, None, None, "", is_first=False, before=-1)
        parts = core.representation.parts(state)
        lessons = self._lessons.get(id(core.table), {})
        known = [
            lesson
            for part in parts
            if (lesson := lessons.get((part.key, part.person))) is not None
        ]
        touches = np.zeros(len(values))
        for lesson in known:
            touches += lesson.touches
        estimates = core.estimates(state)
        # A learner that chooses in a way of its own does not ask its rule.
        plain = type(core).act is CreditedLearner.act
        return Insight(
            represented="" if type(core.representation) is Named else _words(parts),
            values=values,
            probabilities=chances(core.exploration, estimates) if plain else None,
            touches=touches,
            updates=np.array(estimates.visits, dtype=np.float64),
            taught=max((lesson.last for lesson in known), default=(0, ""))[1],
            is_first=self._is_first(robot, parts),
            before=self._before(robot, parts, values),
        )

    def _is_first(self, robot: str, parts: tuple[Part, ...]) -> bool:
        known = self._known.setdefault(robot, set())
        keys = {part.key for part in parts}
        new = not keys <= known
        known |= keys
        return new

    def _before(self, robot: str, parts: tuple[Part, ...], values: Numbers) -> int:
        """What was best here before, where something else is now."""
        met = self._met.setdefault(robot, {})
        top = values == values.max()
        if np.count_nonzero(top) > 1:
            return -1  # of two minds
        best = int(values.argmax())
        before = met.get(parts, best)
        met[parts] = best
        return -1 if before == best else before

    def _told(self, credit: Credit) -> str:
        reward = credit.reward
        assert reward is not None
        kind = "caress" if reward.value > 0 else "tap"
        about = credit.designated
        if about is None and credit.shares:
            about = max(credit.shares, key=lambda share: share[1])[0]
        text = f"{kind} by {reward.giver} at {reward.time:.0f} s ({reward.value:+.2f})"
        if about is None:
            return f"{text}, credited to nothing"
        name = self.behaviors[about.action]
        return f"{text}, credited to {name} {reward.time - about.time:.1f} s before"


def _core(learner: Learner) -> Learner:
    """The learner itself, where it is one of a team."""
    return learner.learner if isinstance(learner, Member) else learner


@lru_cache(maxsize=4096)
def _words(parts: tuple[Part, ...]) -> str:
    """Parts in words, as in "ann (reading), ben (playing, attends robot_0)"."""
    told = []
    for part in parts:
        text = _key_words(part.key)
        told.append(text if part.person is None else f"{part.person} ({text})")
    return ", ".join(told) or "nobody"


def _key_words(key: object) -> str:
    if isinstance(key, Situation):
        return str(key)
    if isinstance(key, frozenset):
        return "; ".join(sorted(f"one {_key_words(each)}" for each in key))
    if isinstance(key, tuple):
        if len(key) == 2 and all(isinstance(each, str) for each in key):
            return key[1] if key[0] == "plays" else f"{key[0]} {key[1]}"
        return ", ".join(_key_words(each) for each in key)
    return str(key)

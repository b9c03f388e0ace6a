"""Situations with what the robot observes beside them, for learners that look closer.

A learner with `observes = True` gets `Seen` in place of situations: the situation, and
for each person the slot of the features. Two are equal if their situations are, so that
a history has the same entries as any other learner's.
"""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from household.observation.encodings import layout

if TYPE_CHECKING:
    from household.environment import Household

Slots = Mapping[str, npt.NDArray[np.float32]]


@dataclass(frozen=True)
class Seen:
    """A situation, and the features of each person as it began or was met."""

    situation: Hashable
    slots: Slots = field(compare=False)
    """Name -> its features, shape (n_features,)."""


class Slotted:
    """Takes the features of people out of observations.

    Args:
        env: A household that is observed as features.
    """

    def __init__(self, env: Household) -> None:
        self._names = env.scenario.person_names
        places = layout(env.scenario)
        n_slots = places["person_here"].stop - places["person_here"].start
        self._places = [
            np.arange(place.start, place.stop).reshape(n_slots, -1)
            for name, place in places.items()
            if name.startswith("person_")
        ]

    def seen(self, situation: Hashable, observation: Any) -> Seen:  # noqa: ANN401
        """Returns a situation with the features beside it.

        Args:
            situation: As the robot sees it.
            observation: Its features at the same moment.
        """
        row = np.asarray(observation, dtype=np.float32)
        table = np.concatenate([row[place] for place in self._places], axis=1)
        return Seen(
            situation,
            {name: table[i] for i, name in enumerate(self._names) if table[i, 0]},
        )


class SeeingHome:
    """A household whose situations are `Seen`; all else is as it was."""

    def __init__(self, env: Household) -> None:
        self._env = env
        self._slotted = Slotted(env)
        self._observations: Mapping[str, Any] = {}

    def __getattr__(self, name: str) -> Any:  # noqa: ANN401 - as the household has it
        return getattr(self._env, name)

    def reset(self, seed: int | None = None) -> Any:  # noqa: ANN401 - as above
        """Begins an episode."""
        results = self._env.reset(seed=seed)
        self._observations = results[0]
        return results

    def step(self, actions: dict[str, int], /) -> Any:  # noqa: ANN401 - as above
        """Lets every robot do its behavior for one decision period."""
        results = self._env.step(actions)
        self._observations = results[0]
        return results

    def situation(self, agent: str, /) -> Seen:
        """The situation as the robot sees it, with the features beside it."""
        situation = self._env.situation(agent)
        return self._slotted.seen(situation, self._observations[agent])


def observes(learner: object) -> bool:
    """Whether a learner wants `Seen` in place of situations."""
    return bool(getattr(learner, "observes", False))

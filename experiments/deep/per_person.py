"""A network that predicts each person's touch from its slot of the features.

One network for everybody: what it learns of one person it holds of all who look alike.
A touch belongs to its giver, and to the behavior that designated credit names; silence
of a person during a bout is no touch. What is expected of all who are there is summed.

    household study FILE.py    with the learner `experiments.deep.per_person:network`
"""

from __future__ import annotations

from collections.abc import Hashable
from itertools import pairwise
from pathlib import Path
from typing import cast

import numpy as np
import torch
from numpy.typing import NDArray
from torch import nn

from experiments.deep.repeatable import steady
from experiments.phases.seeing import Seen
from learners import make_learner
from learners.components import made
from learners.errors import SavedFileError
from learners.experience import Experience
from learners.learner import Credit

EPSILON = 0.1
"""Share of choices that are drawn, if nothing else is said."""

HIDDEN = 64
"""Units of each of two layers."""

MEMORY, BATCH, STEPS = 20_000, 64, 4
"""Samples that are kept, samples of a step, and steps after each entry."""

LEARNING_RATE, DECAY = 1e-3, 1e-4
"""Of Adam, and its decay of weights."""


class NetworkPerPerson:
    """A learner that looks at the features of each person.

    Args:
        n_behaviors: Number of behaviors to choose from.
        rng: Draws first weights, batches and exploration.
        epsilon: Share of choices that are drawn.
        learning_rate: Of Adam.
    """

    observes = True

    def __init__(
        self,
        n_behaviors: int,
        rng: np.random.Generator,
        epsilon: float = EPSILON,
        learning_rate: float = LEARNING_RATE,
    ) -> None:
        self.n_behaviors = n_behaviors
        self._epsilon, self._learning_rate = epsilon, learning_rate
        self._rng = rng
        # Its history and its credit rule say which entry a touch is about.
        self._credit = make_learner(
            "designated", n_behaviors, rng, **made({"representation": "named"})
        )
        self._network: nn.Sequential | None = None
        self._slots: list[NDArray[np.float32]] = []
        self._actions: list[int] = []
        self._targets: list[float] = []
        self._samples: dict[tuple[float, Hashable], int] = {}

    @property
    def credits(self) -> tuple[Credit, ...]:
        """What the last touches were believed to be about."""
        return self._credit.credits

    def act(self, state: Hashable) -> int:
        """Chooses a behavior: the best one, or now and then any."""
        if self._rng.random() < self._epsilon:
            return int(self._rng.integers(self.n_behaviors))
        return int(self.q_values(state).argmax())

    def learn(self, experience: Experience) -> None:
        """Learns from one entry of the history."""
        self._credit.learn(experience)
        for name, slot in cast(Seen, experience.state).slots.items():
            self._remember(experience, name, slot)
        for credit in self.credits:
            if credit.reward is None:
                continue
            for entry, weight in credit.shares:
                number = self._samples.get((entry.time, credit.reward.giver))
                if number is not None:
                    self._targets[number] += weight * credit.reward.value
        self._forget()
        self._train()

    def start_episode(self) -> None:
        """Forgets the history but nothing learned."""
        self._credit.start_episode()
        self._samples.clear()

    def q_values(self, state: Hashable) -> NDArray[np.float64]:
        """Sum of what everybody there is expected to give, shape (n_behaviors,)."""
        slots = list(cast(Seen, state).slots.values())
        if self._network is None or not slots:
            return np.zeros(self.n_behaviors)
        with torch.no_grad():
            expected = self._network(torch.from_numpy(np.stack(slots)))
        return expected.sum(dim=0).numpy().astype(np.float64)

    def save(self, path: str | Path) -> None:
        """Not possible: networks are trained in their trial."""
        raise SavedFileError(f"{path}: a network per person cannot be saved")

    def _remember(
        self, experience: Experience, name: str, slot: NDArray[np.float32]
    ) -> None:
        """Notes that somebody was there in a bout, and gave nothing so far."""
        self._samples[experience.time, name] = len(self._targets)
        self._slots.append(slot)
        self._actions.append(experience.action)
        self._targets.append(0.0)

    def _forget(self) -> None:
        """Drops the oldest half of what is kept, once it is too much."""
        if len(self._targets) <= MEMORY:
            return
        half = MEMORY // 2
        for kept in (self._slots, self._actions, self._targets):
            del kept[:half]
        self._samples = {
            key: number - half
            for key, number in self._samples.items()
            if number >= half
        }

    def _train(self) -> None:
        if not self._targets:
            return
        if self._network is None:
            self._begin(len(self._slots[0]))
        network = cast(nn.Sequential, self._network)
        for _ in range(STEPS):
            chosen = self._rng.integers(len(self._targets), size=BATCH).tolist()
            slots = torch.from_numpy(np.stack([self._slots[i] for i in chosen]))
            actions = torch.tensor([self._actions[i] for i in chosen])
            targets = torch.tensor(
                [self._targets[i] for i in chosen], dtype=torch.float32
            )
            expected = network(slots).gather(1, actions[:, None])[:, 0]
            self._optimizer.zero_grad()
            ((expected - targets) ** 2).mean().backward()
            self._optimizer.step()

    def _begin(self, n_features: int) -> None:
        """Makes the network; its first weights come from the learner's generator."""
        steady()
        generator = torch.Generator().manual_seed(int(self._rng.integers(2**31)))
        sizes = (n_features, HIDDEN, HIDDEN, self.n_behaviors)
        layers: list[nn.Module] = []
        for before, after in pairwise(sizes):
            layer = nn.Linear(before, after)
            bound = before**-0.5
            for weights in (layer.weight, layer.bias):
                nn.init.uniform_(weights, -bound, bound, generator=generator)
            layers += [layer, nn.ReLU()]
        self._network = nn.Sequential(*layers[:-1])
        self._optimizer = torch.optim.Adam(
            self._network.parameters(),
            lr=self._learning_rate,
            weight_decay=DECAY,
            fused=True,
        )


def network(
    n_behaviors: int,
    rng: np.random.Generator,
    epsilon: float = EPSILON,
    learning_rate: float = LEARNING_RATE,
) -> NetworkPerPerson:
    """Returns a new learner, as `module:function` names it.

    Args:
        n_behaviors: Number of behaviors to choose from.
        rng: Draws first weights, batches and exploration.
        epsilon: Share of choices that are drawn.
        learning_rate: Of Adam.
    """
    return NetworkPerPerson(n_behaviors, rng, epsilon, learning_rate)

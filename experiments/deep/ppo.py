"""PPO of Stable-Baselines3 as a learner, with people as a set: the generic baseline.

The robot's life is the library's rollout, a choice of a behavior after the other; the
reward of a choice is the sum of the touches that are felt until the next. Who gave
them, and for what, plays no part.
"""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

import numpy as np
import torch
from gymnasium import spaces
from numpy.typing import NDArray
from stable_baselines3 import PPO
from stable_baselines3.common.logger import Logger
from stable_baselines3.common.policies import ActorCriticPolicy

from experiments.deep.deep_sets import HIDDEN, DeepSets, space, table
from experiments.deep.repeatable import drawn_by
from experiments.phases.seeing import Seen
from learners.errors import SavedFileError
from learners.experience import Experience
from learners.learner import Credit

POLICY = {"features_extractor_class": DeepSets, "net_arch": [HIDDEN]}


@dataclass
class _Choice:
    """A choice whose reward is still being felt."""

    people: NDArray[np.float32]
    action: int
    value: torch.Tensor
    log_share: torch.Tensor
    reward: float = 0.0


class PPOLearner:
    """A learner whose policy and updates are those of Stable-Baselines3.

    Args:
        n_behaviors: Number of behaviors to choose from.
        rng: Draws first weights, batches and choices.
        settings: Of `stable_baselines3.PPO`; a step is a choice.
    """

    observes = True
    credits: tuple[Credit, ...] = ()
    """It believes nothing about single touches."""

    def __init__(
        self,
        n_behaviors: int,
        rng: np.random.Generator,
        **settings: Any,  # noqa: ANN401 - the library's
    ) -> None:
        self.n_behaviors = n_behaviors
        self._rng = rng
        self._settings = settings
        self._model: PPO | None = None
        self._open: _Choice | None = None
        self._next: Seen | None = None
        self._first = True

    def act(self, state: Hashable) -> int:
        """Draws a behavior by the policy's shares."""
        return int(self._rng.choice(self.n_behaviors, p=self.q_values(state)))

    def learn(self, experience: Experience) -> None:
        """Learns from one entry of the history."""
        if experience.chosen:
            self._choose(cast(Seen, experience.state), experience.action)
        if self._open is not None:
            self._open.reward += sum(touch.value for touch in experience.rewards)
        self._next = cast(Seen, experience.next_state)

    def start_episode(self) -> None:
        """Ends the choice that the last episode broke off: life would have gone on."""
        if self._open is not None and self._next is not None:
            value, _ = self._evaluate(self._people(self._next), 0)
            self._open.reward += cast(PPO, self._model).gamma * float(value)
            self._keep(value, ends=True)
        self._open, self._next, self._first = None, None, True

    def q_values(self, state: Hashable) -> NDArray[np.float64]:
        """The policy's share of each behavior, shape (n_behaviors,)."""
        seen = cast(Seen, state)
        if self._model is None and not self._begin(seen):
            return np.full(self.n_behaviors, 1.0 / self.n_behaviors)
        policy = cast(PPO, self._model).policy
        policy.set_training_mode(False)
        with torch.no_grad():
            drawn = policy.get_distribution(torch.from_numpy(self._people(seen)[None]))
        shares = drawn.distribution.probs[0].numpy().astype(np.float64)
        return shares / shares.sum()

    def save(self, path: str | Path) -> None:
        """Not possible: networks are trained in their trial."""
        raise SavedFileError(f"{path}: a network cannot be saved")

    def _choose(self, seen: Seen, action: int) -> None:
        """Notes a choice; the one before it is over now."""
        if self._model is None and not self._begin(seen):
            return
        people = self._people(seen)
        # Before anything is learned, so that these are those of who chose.
        value, log_share = self._evaluate(people, action)
        if self._open is not None:
            self._keep(value, ends=False)
        self._open = _Choice(people, action, value, log_share)

    def _evaluate(
        self, people: NDArray[np.float32], action: int
    ) -> tuple[torch.Tensor, torch.Tensor]:
        """What is expected from here on, and the logarithm of an action's share."""
        policy = cast(PPO, self._model).policy
        policy.set_training_mode(False)
        with torch.no_grad():
            value, log_share, _ = policy.evaluate_actions(
                torch.from_numpy(people[None]), torch.tensor([action])
            )
        return value, log_share

    def _keep(self, value: torch.Tensor, *, ends: bool) -> None:
        """Hands over the choice that is over; with enough of them, the library learns.

        Args:
            value: What is expected after it.
            ends: Whether the episode ends with it.
        """
        model, choice = cast(PPO, self._model), cast(_Choice, self._open)
        buffer = model.rollout_buffer
        buffer.add(
            choice.people[None],
            np.array([choice.action]),
            np.array([choice.reward]),
            np.array([self._first]),
            choice.value,
            choice.log_share,
        )
        self._first = ends
        if buffer.full:
            buffer.compute_returns_and_advantage(value, np.array([ends]))
            with drawn_by(self._rng):
                model.train()
            buffer.reset()
            # The policy remembers the last shares that it computed, and learned ones
            # cannot be copied: their gradients hang on them.
            self._evaluate(choice.people, choice.action)

    def _people(self, seen: Seen) -> NDArray[np.float32]:
        n_features = cast(PPO, self._model).observation_space.shape[-1]
        return table(seen.slots, n_features)

    def _begin(self, seen: Seen) -> bool:
        """Makes the model as soon as it is known what is seen of a person."""
        if not seen.slots:
            return False
        n_features = len(next(iter(seen.slots.values())))
        # As its own `load` does: there is no environment that it could run by itself.
        model = PPO(
            ActorCriticPolicy,
            None,
            policy_kwargs=POLICY,
            device="cpu",
            _init_setup_model=False,
            **self._settings,
        )
        model.observation_space = space(n_features)
        model.action_space = spaces.Discrete(self.n_behaviors)
        model.n_envs = 1
        with drawn_by(self._rng):
            model._setup_model()
        model.set_logger(Logger(None, []))
        self._model = model
        return True


def ppo(
    n_behaviors: int,
    rng: np.random.Generator,
    **settings: Any,  # noqa: ANN401 - the library's
) -> PPOLearner:
    """Returns a new learner, as `module:function` names it.

    Args:
        n_behaviors: Number of behaviors to choose from.
        rng: Draws first weights, batches and choices.
        settings: Of `stable_baselines3.PPO`.
    """
    return PPOLearner(n_behaviors, rng, **settings)

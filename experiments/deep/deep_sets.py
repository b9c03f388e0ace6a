"""An encoder to which people are a set: their order and empty slots make no difference.

After Deep Sets (Zaheer et al., 2017): each person is encoded alone, by one network for
all, and what comes out is summed over those who are there.
"""

from __future__ import annotations

import numpy as np
import torch
from gymnasium import spaces
from numpy.typing import NDArray
from stable_baselines3.common.torch_layers import BaseFeaturesExtractor
from torch import nn

from experiments.phases.seeing import Slots
from household.scenario.family import NAMES

MOST = len(NAMES)
"""People that a household can have at most."""

HIDDEN = 64
"""Units of each of two layers."""


def space(n_features: int) -> spaces.Box:
    """Returns the space of tables of people, shape (MOST, n_features).

    Args:
        n_features: Of each person; the first one says that it is there.
    """
    return spaces.Box(-1.0, 1.0, (MOST, n_features), np.float32)


def table(slots: Slots, n_features: int) -> NDArray[np.float32]:
    """Returns the features of all people, shape (MOST, n_features).

    Args:
        slots: The features of those who are there.
        n_features: Of each person.
    """
    rows = np.zeros((MOST, n_features), np.float32)
    for row, features in zip(rows, slots.values(), strict=False):
        row[:] = features
    return rows


class DeepSets(BaseFeaturesExtractor):
    """Encodes tables of people.

    Args:
        observation_space: From `space`.
    """

    def __init__(self, observation_space: spaces.Box) -> None:
        super().__init__(observation_space, features_dim=HIDDEN)
        self._each = nn.Sequential(
            nn.Linear(observation_space.shape[-1], HIDDEN),
            nn.ReLU(),
            nn.Linear(HIDDEN, HIDDEN),
            nn.ReLU(),
        )

    def forward(self, people: torch.Tensor) -> torch.Tensor:
        """Returns the sum of what people are encoded as, shape (batch, HIDDEN).

        Args:
            people: Shape (batch, MOST, n_features).
        """
        there = people[..., :1]
        return (self._each(people) * there).sum(dim=-2)

"""Many homes at once for Stable-Baselines3; needs the extra ``sb3``."""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from stable_baselines3.common.vec_env import VecEnv

from household.errors import HouseholdError
from household.vector.environment import VectorHousehold

Which = int | Iterable[int] | None
"""Robots by their slots; None: all of them."""


class HouseholdVecEnv(VecEnv):
    """Many homes as Stable-Baselines3 wants them: every robot is an environment.

    Infos are empty but at the end of an episode, where they hold what its algorithms
    look for. The action masks are there for ``sb3_contrib.MaskablePPO``.

    Args:
        homes: From `household.vector.make`; ends with this.
    """

    def __init__(self, homes: VectorHousehold) -> None:
        self.homes = homes
        self._actions: NDArray[Any] = np.zeros(homes.num_envs, np.int64)
        self._masks: NDArray[Any] = np.ones((homes.num_envs, len(homes.behaviors)))
        space, actions = homes.single_observation_space, homes.single_action_space
        super().__init__(homes.num_envs, space, actions)

    def seed(self, seed: int | None = None) -> Sequence[int | None]:
        """Draws seeds for the homes at the next reset.

        Returns:
            None for each robot: homes have seeds, and robots share them.
        """
        self._seeds = [seed] + [None] * (self.num_envs - 1)
        return [None] * self.num_envs

    def reset(self) -> NDArray[Any]:
        """Begins an episode in all homes; returns observations."""
        observations, infos = self.homes.reset(seed=self._seeds[0])
        self._reset_seeds()
        self._masks = infos["action_mask"]
        return observations

    def step_async(self, actions: NDArray[Any]) -> None:
        """Takes the actions for `step_wait`."""
        self._actions = actions

    def step_wait(
        self,
    ) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any], list[dict[str, Any]]]:
        """Lets one decision period pass in all homes.

        Returns:
            Observations, rewards, ends of episodes, and infos.
        """
        observations, rewards, _, cut, told = self.homes.step(self._actions)
        self._masks = told["action_mask"]
        infos: list[dict[str, Any]] = [{} for _ in range(self.num_envs)]
        for slot in np.flatnonzero(cut):
            last = told["final_obs"][slot]
            infos[slot] = {"terminal_observation": last, "TimeLimit.truncated": True}
        return observations, rewards.astype(np.float32), cut, infos

    def action_masks(self) -> NDArray[Any]:
        """Which actions are a choice now, shape (num_envs, n_behaviors)."""
        return self._masks

    def close(self) -> None:
        """Ends the homes."""
        self.homes.close()

    def env_method(
        self, method_name: str, *args: object, indices: Which = None, **kwargs: object
    ) -> list[Any]:
        """Calls a method for some robots; there is only `action_masks`."""
        if method_name != "action_masks":
            raise HouseholdError(f"{method_name}: allowed: action_masks")
        return [self._masks[slot] for slot in self._get_indices(indices)]

    def get_attr(self, attr_name: str, indices: Which = None) -> list[Any]:
        """What an attribute of the homes is, for some robots."""
        owner = self if attr_name == "action_masks" else self.homes
        value = getattr(owner, attr_name)
        return [value for _ in self._get_indices(indices)]

    def set_attr(self, attr_name: str, value: object, indices: Which = None) -> None:
        """Homes cannot be changed while they are lived in.

        Raises:
            HouseholdError: Always.
        """
        raise HouseholdError(f"{attr_name}: homes cannot be changed from outside")

    def env_is_wrapped(self, wrapper_class: type, indices: Which = None) -> list[bool]:
        """No robot's environment is wrapped."""
        return [False for _ in self._get_indices(indices)]

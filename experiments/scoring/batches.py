"""Episodes as plain arrays, for learning offline; and as a Minari data set."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from experiments.errors import ExperimentError
from experiments.scoring.moments import moment

if TYPE_CHECKING:
    from experiments.scoring.policies import Policy
    from household.environment import Household

Array = npt.NDArray[Any]

STORED_IN = "MINARI_DATASETS_PATH"
"""The environment variable by which Minari finds its data sets."""


class Batch(NamedTuple):
    """One robot's episode of T steps.

    Attributes:
        agent: Name of the robot.
        seed: Of the episode.
        observations: Before each step and after the last one, shape (T + 1, length).
        actions: What it did in each step, shape (T,).
        rewards: Sum of the touches felt in each step, shape (T,).
        truncations: True for the last step alone, shape (T,); nobody is terminated.
        infos: Name of an info -> its value after the reset and after each step,
            shape (T + 1, ...).
    """

    agent: str
    seed: int
    observations: Array
    actions: Array
    rewards: Array
    truncations: Array
    infos: Mapping[str, Array]


def lived(env: Household, policy: Policy, seed: int) -> Iterator[Batch]:
    """Lives through an episode; each robot asks the policy when a behavior is due.

    Args:
        env: The household.
        policy: As it is deployed, exploration included.
        seed: Of the episode.

    Yields:
        What each robot lived through.
    """
    observations, infos = env.reset(seed=seed)
    agents = tuple(env.agents)
    seen, told = [observations], [infos]
    actions = dict.fromkeys(agents, 0)
    done, felt = [], []
    while env.agents:
        for agent in agents:
            if env.behavior_over(agent):
                now = moment(env, agent, observations[agent])
                actions[agent] = policy.deployed(now.sight())
        observations, rewards, _, _, infos = env.step(actions)
        done.append(dict(actions))
        seen.append(observations)
        felt.append(rewards)
        told.append(infos)
    for agent in agents:
        yield Batch(
            agent=agent,
            seed=seed,
            observations=_column(seen, agent),
            actions=_column(done, agent),
            rewards=_column(felt, agent),
            truncations=np.arange(len(done)) == len(done) - 1,
            infos={
                name: np.array([each[agent][name] for each in told])
                for name in told[0][agent]
            },
        )


def _column(rows: Sequence[Mapping[str, Any]], agent: str) -> Array:
    return np.array([row[agent] for row in rows])


def write_minari(
    batches: Sequence[Batch], env: Household, name: str, folder: Path, **about: str
) -> None:
    """Writes a data set that Minari reads; each robot's episode is one of its own.

    Args:
        batches: What robots lived through.
        env: The household that it was in.
        name: What Minari is to call it, such as `household/evening-v0`.
        folder: Where Minari is to find it.
        **about: More that Minari keeps, such as `algorithm_name`.

    Raises:
        ExperimentError: If Minari is not installed, has such a data set already, or
            refuses the name.
    """
    agent = env.possible_agents[0]
    with _minari_in(folder) as minari:
        from minari.data_collector import EpisodeBuffer

        buffers = [
            EpisodeBuffer(
                id=index,
                seed=batch.seed,
                observations=batch.observations,
                actions=batch.actions,
                rewards=batch.rewards,
                terminations=np.zeros_like(batch.truncations),
                truncations=batch.truncations,
                infos=dict(batch.infos),
            )
            for index, batch in enumerate(batches)
        ]
        try:
            with warnings.catch_warnings():
                # It asks for an author and a Gymnasium environment; there is none.
                warnings.filterwarnings("ignore", category=UserWarning)
                minari.create_dataset_from_buffers(
                    name,
                    buffers,
                    observation_space=env.observation_space(agent),
                    action_space=_plain(env),
                    requirements=["polite-household"],
                    **about,
                )
        except ValueError as error:
            raise ExperimentError(f"{name}: {error}") from error


def _plain(env: Household) -> Any:  # noqa: ANN401 - Gymnasium's, without our drawing
    from gymnasium.spaces import Discrete

    return Discrete(len(env.behaviors))


@contextmanager
def _minari_in(folder: Path) -> Iterator[Any]:
    """Minari, which for this time keeps its data sets in a folder."""
    try:
        import minari
    except ImportError as error:
        raise ExperimentError(
            f"Minari is not installed ({error}): "
            "pip install 'polite-household[minari]'."
        ) from error
    before = os.environ.get(STORED_IN)
    os.environ[STORED_IN] = str(folder)
    try:
        yield minari
    finally:
        if before is None:
            del os.environ[STORED_IN]
        else:
            os.environ[STORED_IN] = before

"""Household: robots that learn to be polite, as a versioned PettingZoo environment.

| agents       | `robot_0`, `robot_1`, ... as many as the scenario has               |
| actions      | `Discrete(n)`: the behaviors that the scenario names, in order      |
| observations | `features`: `Box(float32)`, see `household.observation.layout`;     |
|              | `situation`: roles and attention as `MultiDiscrete`, `MultiBinary`  |
| reward       | touches felt in this step: caress in (0, 1], tap in [-1, 0)         |

People of a household go about their lives, each with preferences of their own about
what a robot should do when. The only feedback that they give is a caress or a tap, and
they have to walk over to give it.

Arguments:
    scenario: A built-in name, a path to a TOML file, or a `Scenario`.
    observation: "features" or "situation".
    render_mode: See `metadata["render_modes"]`.
    minds: Name of a person -> what makes a mind of its own for it, such as a class; see
        `household.people.Mind`. Everybody else has the usual mind.
    **overrides: Any top-level field of the scenario, such as `max_cycles`.

Version history:
    v0: First version.
"""

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any

from pettingzoo.utils.conversions import parallel_to_aec
from pettingzoo.utils.env import AECEnv
from pettingzoo.utils.wrappers import OrderEnforcingWrapper

from household.environment import Household
from household.people.among import MakeMind, with_own_minds
from household.people.people import MakeMinds
from household.scenario.scenario import Scenario

# The composition root: the one place where the simulated home meets the policies of
# its people; everything else in this package knows only their contract.
from policies.people import make_minds

__all__ = ["env", "make_minds", "minds_with", "parallel_env", "raw_env"]

DEFAULT_SCENARIO = "experiment_1"


def parallel_env(
    scenario: str | Path | Scenario = DEFAULT_SCENARIO,
    observation: str = "features",
    render_mode: str | None = None,
    minds: Mapping[str, MakeMind] | None = None,
    **overrides: Any,  # noqa: ANN401 - checked against the scenario's fields
) -> Household:
    """The household as a parallel environment: all robots act at once."""
    everybody = make_minds if minds is None else minds_with(minds)
    return Household(
        scenario, everybody, observation, render_mode=render_mode, **overrides
    )


def minds_with(own: Mapping[str, MakeMind]) -> MakeMinds:
    """The usual minds but for some people, as `household.vector.make` takes them.

    Args:
        own: Name of a person -> what makes its mind.
    """
    return partial(with_own_minds, usual=make_minds, own=dict(own))


def raw_env(
    scenario: str | Path | Scenario = DEFAULT_SCENARIO,
    observation: str = "features",
    render_mode: str | None = None,
    minds: Mapping[str, MakeMind] | None = None,
    **overrides: Any,  # noqa: ANN401 - checked against the scenario's fields
) -> AECEnv[str, Any, int]:
    """The household as a turn-based environment, without further wrappers."""
    return parallel_to_aec(
        parallel_env(scenario, observation, render_mode, minds, **overrides)
    )


def env(
    scenario: str | Path | Scenario = DEFAULT_SCENARIO,
    observation: str = "features",
    render_mode: str | None = None,
    minds: Mapping[str, MakeMind] | None = None,
    **overrides: Any,  # noqa: ANN401 - checked against the scenario's fields
) -> AECEnv[str, Any, int]:
    """The household as a turn-based environment that checks the order of calls."""
    return OrderEnforcingWrapper(
        raw_env(scenario, observation, render_mode, minds, **overrides)
    )

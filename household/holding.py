"""Held: an agent chooses only when its behavior is over, and never interrupts itself.

What lies between two choices of an agent is one step of a semi-Markov decision process:
its rewards are summed, and ``infos[agent]["elapsed"]`` says how many steps of the
household it took.
"""

from dataclasses import dataclass, replace
from typing import Any

from pettingzoo import AECEnv, ParallelEnv
from pettingzoo.utils.wrappers import BaseParallelWrapper, OrderEnforcingWrapper

from household.arguments import checked_choices
from household.environment import Household, Results
from household.errors import HouseholdError
from household.feedback import Feedback
from household.simulation.checkpoint import Checkpoint


@dataclass(frozen=True, slots=True)
class Interval:
    """What an agent has lived through since its last choice.

    Attributes:
        elapsed: Steps of the household.
        reward: The sum of their rewards, not discounted.
        touches: The touches that it felt.
    """

    elapsed: int = 0
    reward: float = 0.0
    touches: tuple[Feedback, ...] = ()

    def then(self, reward: float, touches: tuple[Feedback, ...]) -> "Interval":
        """The same and one step more."""
        return Interval(
            self.elapsed + 1, self.reward + reward, (*self.touches, *touches)
        )


@dataclass(frozen=True, slots=True)
class HeldCheckpoint:
    """A moment of a held household.

    Attributes:
        home: Of the household itself.
        intervals: What its agents have lived through since their last choices.
    """

    home: Checkpoint
    intervals: dict[str, Interval]


class Held(BaseParallelWrapper[str, Any, int]):
    """A parallel household in which nobody interrupts a behavior; see `held`.

    A step lasts until the behavior of at least one agent is over. Only the actions of
    agents whose behavior is over count (`due`); those of the others are ignored, as the
    ``action_mask`` says. An agent is told its reward when its behavior is over or the
    episode ends: the sum since its last choice; before that its reward is 0. So the
    steps after which an agent is due hold all that it can learn from.
    """

    def __init__(self, env: Any) -> None:  # noqa: ANN401 - PettingZoo's have no types
        super().__init__(env)
        self._index = {agent: i for i, agent in enumerate(env.possible_agents)}
        self._intervals: dict[str, Interval] = {}

    @property
    def due(self) -> list[str]:
        """The agents that are to choose now."""
        return [agent for agent in self.env.agents if self.behavior_over(agent)]

    def reset(
        self, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, Any], dict[str, dict[str, Any]]]:
        """Begins an episode, as `Household.reset`."""
        observations, infos = self.env.reset(seed=seed, options=options)
        self._intervals = dict.fromkeys(self.env.agents, Interval())
        return observations, {a: info | _told(Interval()) for a, info in infos.items()}

    def step(self, actions: dict[str, int]) -> Results:
        """Lets time pass until somebody's behavior is over, or the episode.

        Args:
            actions: Of each agent that is to choose; one that does not waits. Those of
                other agents are checked, but ignored.

        Returns:
            As `Household.step`. Infos count all touches since the agent's last choice,
            and say how many steps ago that was (``elapsed``).
        """
        due = self.due
        checked_choices(actions, self._index, len(self.behaviors))
        chosen = {agent: actions[agent] for agent in due if agent in actions}
        self._intervals |= dict.fromkeys(due, Interval())
        observations, rewards, ends, cuts, infos = self._live(chosen)
        while self.env.agents and not self.due:
            observations, rewards, ends, cuts, infos = self._live({})
        told = {
            agent: self._intervals[agent]
            if cuts[agent] or infos[agent]["behavior_over"]
            else replace(self._intervals[agent], reward=0.0, touches=())
            for agent in rewards
        }
        return (
            observations,
            {agent: interval.reward for agent, interval in told.items()},
            ends,
            cuts,
            {agent: infos[agent] | _told(interval) for agent, interval in told.items()},
        )

    def _live(self, chosen: dict[str, int]) -> Results:
        """Makes one step of the household."""
        results: Results = self.env.step(chosen)
        for agent, reward in results[1].items():
            touches = self.env.feedback(agent)
            self._intervals[agent] = self._intervals[agent].then(reward, touches)
        return results

    def feedback(self, agent: str) -> tuple[Feedback, ...]:
        """The touches that an agent has felt since its last choice."""
        self.env.feedback(agent)  # Refuses whoever is no robot.
        return self._intervals.get(agent, Interval()).touches

    def checkpoint(self) -> HeldCheckpoint:
        """Takes the whole state of this moment, as `Household.checkpoint`."""
        return HeldCheckpoint(self.env.checkpoint(), dict(self._intervals))

    def restore(self, checkpoint: HeldCheckpoint) -> None:
        """Goes back, or on, to a moment, as `Household.restore`."""
        self.env.restore(checkpoint.home)
        self._intervals = dict(checkpoint.intervals)

    def __repr__(self) -> str:
        return f"Held({self.env!r})"

    __str__ = __repr__


class HeldTurns(AECEnv[str, Any, int]):
    """A turn-based household in which only agents whose behavior is over get a turn.

    What `last` tells an agent is the sum of its rewards since its last turn.
    """

    agent_selection: str

    def __init__(self, env: Held) -> None:
        super().__init__()
        self.env, self.metadata = env, env.metadata
        self.render_mode, self.state_space = env.render_mode, env.state_space
        self.possible_agents = env.possible_agents
        self.agents: list[str] = []

    @property
    def unwrapped(self) -> Household:
        """The household itself."""
        home: Household = self.env.unwrapped
        return home

    def observation_space(self, agent: str) -> Any:  # noqa: ANN401 - PettingZoo's
        """As `Household.observation_space`."""
        return self.env.observation_space(agent)

    def action_space(self, agent: str) -> Any:  # noqa: ANN401 - PettingZoo's
        """As `Household.action_space`."""
        return self.env.action_space(agent)

    def observe(self, agent: str) -> Any:  # noqa: ANN401 - PettingZoo's
        """What an agent observed last."""
        return self._observations[agent]

    def state(self) -> Any:  # noqa: ANN401 - PettingZoo's
        """As `Household.state`."""
        return self.env.state()

    def render(self) -> Any:  # noqa: ANN401 - PettingZoo's
        """As `Household.render`."""
        return self.env.render()

    def close(self) -> None:
        """As `Household.close`."""
        self.env.close()

    def reset(
        self, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> None:
        """Begins an episode."""
        self._observations, self.infos = self.env.reset(seed=seed, options=options)
        self.agents = list(self.env.agents)
        self.terminations = dict.fromkeys(self.agents, False)
        self.truncations = dict.fromkeys(self.agents, False)
        self.rewards = dict.fromkeys(self.agents, 0.0)
        self._cumulative_rewards = dict.fromkeys(self.agents, 0.0)
        self._turn()

    def step(self, action: int | None) -> None:
        """The agent whose turn it is chooses; after the last one, time passes."""
        agent = self.agent_selection
        if self.truncations[agent]:
            self._was_dead_step(action)
            return
        self._chosen[agent] = action
        self._cumulative_rewards[agent] = 0.0
        self._clear_rewards()
        if self._others:
            self.agent_selection = self._others.pop(0)
            return
        results = self.env.step(self._chosen)
        self._observations, self.rewards, *ends, self.infos = results
        self.terminations, self.truncations = ends
        self._accumulate_rewards()
        self._turn()

    def _turn(self) -> None:
        """It is the turn of those who are to choose; of all, once the episode ends."""
        first, *self._others = self.env.due or self.agents
        self.agent_selection = first
        self._chosen: dict[str, Any] = {}

    def __str__(self) -> str:
        return str(self.env)

    def __repr__(self) -> str:
        return repr(self.env)


def held(env: Any) -> Any:  # noqa: ANN401 - PettingZoo's wrappers have no types
    """A household in which an agent chooses only when its behavior is over.

    Discounting: rewards within an interval are summed as they are. To discount time and
    not choices, discount what comes after an interval by ``gamma ** elapsed``; with one
    ``gamma`` for each choice, a long behavior costs no more than a short one.

    Args:
        env: A parallel household, also inside other wrappers, or a turn-based one from
            `household_v0.env`.

    Returns:
        `Held` for a parallel household, and else its turn-based form.

    Raises:
        HouseholdError: If it is no household.
    """
    if not isinstance(getattr(env, "unwrapped", None), Household):
        raise HouseholdError("held() takes households, parallel or turn-based")
    if isinstance(env, ParallelEnv):
        return Held(env)
    return OrderEnforcingWrapper(HeldTurns(Held(env.unwrapped)))


def _told(interval: Interval) -> dict[str, int]:
    """What infos say of an interval."""
    caresses = sum(touch.kind == "caress" for touch in interval.touches)
    return {
        "caresses": caresses,
        "taps": len(interval.touches) - caresses,
        "elapsed": interval.elapsed,
    }

"""Where robot and learner meet: situations and touches in, behaviors out.

    learner = learners.make_learner("q_social", len(env.behaviors), rng)
    robots = {agent: LearningRobot(learner) for agent in env.possible_agents}
    run_episode(env, robots, seed=7)

or, in a loop of one's own, `action = robot.act(env, agent)` before each `env.step` and
`robot.finish(env, agent)` after the last one.
"""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

from household.perception.situation import Situation
from learners.experience import Experience, Reward
from learners.learner import Credit, Learner
from learners.saving import saved

if TYPE_CHECKING:
    from household.feedback import Feedback

# So that what was learned in a household can be saved.
saved(Situation)


class Home(Protocol):
    """What a learning robot asks of its environment; `Household` fulfils it.

    It holds nothing that only the simulator could know.
    """

    agents: list[str]

    @property
    def time(self) -> float:
        """Time since the episode began, in seconds."""

    @property
    def decision(self) -> int:
        """Steps since the episode began."""

    def reset(self, seed: int | None = None) -> object:
        """Begins an episode."""

    def step(self, actions: dict[str, int], /) -> object:
        """Lets every robot do its behavior for one decision period."""

    def situation(self, agent: str, /) -> Hashable:
        """The situation as the robot sees it."""

    def behavior_over(self, agent: str, /) -> bool:
        """Whether the robot may choose a new behavior."""

    def feedback(self, agent: str, /) -> Sequence[Feedback]:
        """The touches that the robot felt in the last step."""

    def attended(self, agent: str, /) -> bool:
        """Whether somebody attends to the robot."""

    def approached(self, agent: str, /) -> bool:
        """Whether somebody is seen walking towards the robot."""


@dataclass(frozen=True, kw_only=True)
class Pair:
    """The pair (situation, behavior) that a robot is in; an experience once over."""

    state: Hashable
    """The situation."""

    action: int
    """Index of the behavior."""

    time: float
    """Since when it holds. [s]"""

    decision: int
    """The environment's step count since then."""

    chosen: bool
    """False if the behavior went on while the situation changed."""


class LearningRobot:
    """Lets a learner choose, and hands it every pair that is over as an experience.

    The learner chooses anew only when the robot's behavior is over. A pair is over when
    the situation changes or a behavior is chosen anew (the history of Table 1).

    Attributes:
        learner: The learner; several robots may share one.
        pair: The pair the robot is in; None before its first choice.
        experience: The pair that the last `act` or `finish` ended; None if it ended
            none.
        credits: What the learner believed each touch of that experience to be about.
    """

    def __init__(self, learner: Learner) -> None:
        self.learner = learner
        self.pair: Pair | None = None
        self.experience: Experience | None = None
        self.credits: tuple[Credit, ...] = ()
        self._felt: list[Reward] = []
        self._attended = False

    def act(self, env: Home, agent: str) -> int:
        """Learns from the last step and returns the behavior for the next one.

        To be called once before each step of the environment, the first one included.

        Args:
            env: The household (or what a PettingZoo wrapper calls `unwrapped`).
            agent: The robot's name.

        Returns:
            Index of the behavior.
        """
        if env.decision == 0:
            self._start()
        state = env.situation(agent)
        over = env.behavior_over(agent) or self.pair is None
        self._perceive(env, agent, state, ends=over)
        if over or self.pair is None:
            self.pair = _pair(env, state, self.learner.act(state), chosen=True)
        elif state != self.pair.state:
            self.pair = _pair(env, state, self.pair.action, chosen=False)
        return self.pair.action

    def finish(self, env: Home, agent: str) -> None:
        """Learns from the last step of an episode and ends the pair it is in."""
        self._perceive(env, agent, env.situation(agent), ends=True)
        self.pair = None

    def _start(self) -> None:
        self.pair = None
        self._felt.clear()
        self._attended = False
        self.learner.start_episode()

    def _perceive(self, env: Home, agent: str, state: Hashable, *, ends: bool) -> None:
        """Notes what the last step brought; ends the pair if it is over."""
        self.experience, self.credits = None, ()
        if self.pair is None:
            return
        if felt := env.feedback(agent):
            self._felt += map(reward_of, felt)
        self._attended = self._attended or bool(env.attended(agent))
        if ends or state != self.pair.state:
            self._learn(self.pair, state, env.time, env.approached(agent))

    def _learn(
        self, pair: Pair, next_state: Hashable, now: float, approached: bool
    ) -> None:
        self.experience = Experience(
            state=pair.state,
            action=pair.action,
            next_state=next_state,
            time=pair.time,
            next_time=now,
            rewards=tuple(self._felt),
            attended=self._attended,
            chosen=pair.chosen,
            approached=bool(approached),
        )
        self._felt.clear()
        self._attended = False
        self.learner.learn(self.experience)
        self.credits = tuple(self.learner.credits)


class Observer:
    """Watches an episode; a subclass overrides what it wants to see.

    Replay files and result tables are observers, so the loop stays plain.
    """

    def reset(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """The episode has begun."""

    def acted(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """Every robot has learned from the last step and chosen for the next."""

    def stepped(
        self, env: Home, actions: Mapping[str, int], robots: Mapping[str, LearningRobot]
    ) -> None:
        """The environment has made a step with these actions."""

    def finished(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """The episode is over and every robot has learned from its last step."""


def run_episode(
    env: Home,
    robots: Mapping[str, LearningRobot],
    *,
    seed: int | None = None,
    observers: Sequence[Observer] = (),
) -> None:
    """Runs one episode to its end; the learners keep what they learned.

    Args:
        env: The household.
        robots: A learning robot for each agent.
        seed: Seed of the episode; None: the environment's stream goes on.
        observers: Who watches, in this order.
    """
    env.reset(seed=seed)
    for observer in observers:
        observer.reset(env, robots)
    while env.agents:
        actions = {agent: robots[agent].act(env, agent) for agent in env.agents}
        for observer in observers:
            observer.acted(env, robots)
        env.step(actions)
        for observer in observers:
            observer.stepped(env, actions, robots)
    for agent, robot in robots.items():
        robot.finish(env, agent)
    for observer in observers:
        observer.finished(env, robots)


def reward_of(feedback: Feedback) -> Reward:
    """Returns what a robot felt as what a learner is given for it."""
    return Reward(
        value=feedback.value,
        time=feedback.time,
        giver=feedback.giver,
        attending=feedback.attending,
        mood=feedback.mood,
        approach_began=feedback.approach_began,
        attention_began=feedback.attention_began,
    )


def _pair(env: Home, state: Hashable, action: int, *, chosen: bool) -> Pair:
    return Pair(
        state=state,
        action=action,
        time=env.time,
        decision=env.decision,
        chosen=chosen,
    )

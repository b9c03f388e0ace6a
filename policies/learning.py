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
from learners.experience import Experience, Feedback
from learners.learner import Credit, Learner
from learners.saving import saved

if TYPE_CHECKING:
    from household.feedback import Feedback as Touch

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

    def feedback(self, agent: str, /) -> Sequence[Touch]:
        """The touches that the robot felt in the last step."""

    def attended(self, agent: str, /) -> bool:
        """Whether somebody attends to the robot."""


@dataclass(frozen=True, kw_only=True)
class Entry:
    """The history entry that a robot is in: a pair that holds since `time`."""

    state: Hashable
    """The situation."""

    action: int
    """Index of the behavior."""

    time: float
    """When it began. [s]"""

    decision: int
    """The environment's step count when it began."""

    chosen: bool
    """False if the behavior went on while the situation changed."""


@dataclass(frozen=True, kw_only=True)
class Lesson:
    """An entry that is over, and what the learner made of it."""

    entry: Entry
    """The entry as it began."""

    experience: Experience
    """The entry as the learner was given it."""

    credits: tuple[Credit, ...]
    """What the learner believed each touch to be about."""


class LearningRobot:
    """Lets a learner choose, and hands it every history entry that is over.

    The learner chooses anew only when the robot's behavior is over. An entry ends when
    the situation changes or a behavior is chosen anew (the history of Table 1).

    Attributes:
        learner: The learner; several robots may share one.
        entry: The entry the robot is in; None before its first choice.
        lesson: The entry that the last `act` or `finish` ended; None if it ended none.
    """

    def __init__(self, learner: Learner) -> None:
        self.learner = learner
        self.entry: Entry | None = None
        self.lesson: Lesson | None = None
        self._felt: list[Feedback] = []
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
        over = env.behavior_over(agent) or self.entry is None
        self._perceive(env, agent, state, ends=over)
        if over or self.entry is None:
            self.entry = _entry(env, state, self.learner.act(state), chosen=True)
        elif state != self.entry.state:
            self.entry = _entry(env, state, self.entry.action, chosen=False)
        return self.entry.action

    def finish(self, env: Home, agent: str) -> None:
        """Learns from the last step of an episode and ends the entry it is in."""
        self._perceive(env, agent, env.situation(agent), ends=True)
        self.entry = None

    def _start(self) -> None:
        self.entry = None
        self._felt.clear()
        self._attended = False
        self.learner.start_episode()

    def _perceive(self, env: Home, agent: str, state: Hashable, *, ends: bool) -> None:
        """Notes what the last step brought; ends the entry if it is over."""
        self.lesson = None
        if self.entry is None:
            return
        self._felt += [perceived(touch) for touch in env.feedback(agent)]
        self._attended |= bool(env.attended(agent))
        if ends or state != self.entry.state:
            self._learn(self.entry, state, env.time)

    def _learn(self, entry: Entry, next_state: Hashable, now: float) -> None:
        experience = Experience(
            state=entry.state,
            action=entry.action,
            next_state=next_state,
            time=entry.time,
            next_time=now,
            feedback=tuple(self._felt),
            attended=self._attended,
            chosen=entry.chosen,
        )
        self._felt.clear()
        self._attended = False
        self.learner.learn(experience)
        self.lesson = Lesson(
            entry=entry, experience=experience, credits=tuple(self.learner.credits)
        )


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


def perceived(touch: Touch) -> Feedback:
    """Returns a household's touch as learners know it."""
    return Feedback(
        value=touch.value,
        time=touch.time,
        giver=touch.giver,
        attending=touch.attending,
        mood=touch.mood,
        approach_began=touch.approach_began,
        attention_began=touch.attention_began,
    )


def _entry(env: Home, state: Hashable, action: int, *, chosen: bool) -> Entry:
    return Entry(
        state=state,
        action=action,
        time=env.time,
        decision=env.decision,
        chosen=chosen,
    )

"""Several robots: each for itself, one table for all, or experience carried over."""

import dataclasses
from collections.abc import Callable, Hashable, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, cast

import numpy as np
from numpy.typing import NDArray

from learners.catalog import make_learner
from learners.errors import ParameterError, UnknownRobotError, check_range, shown
from learners.expectation import ExpectedTouch
from learners.experience import Experience
from learners.learner import Credit, Learner
from learners.qlearner import QLearner
from learners.representation.states import is_state
from learners.saving import saved, write
from learners.tabular.base import CreditedLearner

Sharing = Literal["independent", "shared", "carried"]
Translation = Callable[[Hashable, Hashable, Hashable], Hashable]


@saved
def seen_from(state: Hashable, robot: Hashable, other: Hashable) -> Hashable:
    """The situation of one robot as another would see it in its place.

    Robots are swapped like any two entities; a state that does not know swaps is taken
    to look the same to all.
    """
    return state.swapped(robot, other) if is_state(state) else state


@saved
@dataclass(kw_only=True, eq=False)
class Team:
    """The learners of several robots, and what they have of each other's experience.

    - independent: nothing; any learners.
    - shared: one table, situation network and analogy; each robot keeps a history of
      its own, since a touch is about what the touched robot did.
    - carried: a table each; every update of one robot is carried to the others, as an
      analogy that swaps robots.

    Attributes:
        members: the learner of each robot. They belong to the team from then on.
        sharing: which of the three.
        strength: step of carried experience, relative to one's own, in [0, 1]. 0.5: our
            choice; people may treat robots differently.
        translate: a state of one robot as another would see it.

    Raises:
        ParameterError: if there are no members; if others than QLearners are to carry,
            or others than QLearners and ExpectedTouch are to share, all of one kind.
    """

    members: dict[Hashable, Learner]
    sharing: Sharing = "independent"
    strength: float = 0.5
    translate: Translation = seen_from

    def __post_init__(self) -> None:
        check_range("strength", self.strength, 0.0, 1.0)
        if self.sharing not in ("independent", "shared", "carried"):
            raise ParameterError(f"there is no sharing called {shown(self.sharing)}")
        if not (self.members and isinstance(self.members, dict)):
            raise ParameterError("a team needs at least one robot")
        members = list(self.members.values())
        all_q_learners = all(isinstance(each, QLearner) for each in members)
        if self.sharing == "carried" and not all_q_learners:
            raise ParameterError("only QLearners can carry experience")
        if self.sharing == "shared":
            first = members[0]
            alike = all(type(each) is type(first) for each in members)
            if not alike or not isinstance(first, QLearner | ExpectedTouch):
                raise ParameterError(
                    "only QLearners or ExpectedTouch learners can share a table, all "
                    "of one kind"
                )
            for each in members:
                cast(CreditedLearner, each).share(first)

    def member(self, robot: Hashable) -> "Member":
        """One robot's learner, as a learner like any other.

        Raises:
            UnknownRobotError: if it is not of the team.
        """
        return Member(self, robot, self._known(robot))

    def act(self, robot: Hashable, state: Hashable) -> int:
        """Choose a behavior for a robot.

        Raises:
            UnknownRobotError: if it is not of the team.
        """
        return self._known(robot).act(self._common(state, robot))

    def q_values(self, robot: Hashable, state: Hashable) -> NDArray[np.float64]:
        """What a robot holds of each behavior, shape (n_behaviors,).

        Raises:
            UnknownRobotError: if it is not of the team.
        """
        return self._known(robot).q_values(self._common(state, robot))

    def learn(self, robot: Hashable, experience: Experience) -> None:
        """Let a robot learn from its experience, and the others as far as they share.

        Raises:
            LearnerError: if the robot is unknown or the entry cannot be; what was
                learned is unchanged.
        """
        learner = self._known(robot)
        if self.sharing == "shared":
            experience = dataclasses.replace(
                experience,
                state=self._common(experience.state, robot),
                next_state=self._common(experience.next_state, robot),
            )
        learner.learn(experience)
        if self.sharing == "carried":
            for other in self.members:
                if other != robot:
                    self._carry(robot, other)

    def save(self, path: str | Path) -> None:
        """Write the whole team, atomically; `learners.load` reads it."""
        write(path, self)

    def _carry(self, robot: Hashable, other: Hashable) -> None:
        targets = [
            target._replace(state=self.translate(target.state, robot, other))
            for target in self._q_learner(robot).targets
        ]
        self._q_learner(other).move(targets, self.strength)

    def common(self, robot: Hashable, state: Hashable) -> Hashable:
        """A state as the table has it that a robot learns into."""
        return self._common(state, robot)

    def _common(self, state: Hashable, robot: Hashable) -> Hashable:
        """A state as the shared table has it: seen from the first robot."""
        first = next(iter(self.members))
        if self.sharing != "shared" or robot == first:
            return state
        return self.translate(state, robot, first)

    def _known(self, robot: Hashable) -> Learner:
        if robot not in self.members:
            names = ", ".join(map(str, self.members))
            raise UnknownRobotError(f"{robot} is not one of the team: {names}")
        return self.members[robot]

    def _q_learner(self, robot: Hashable) -> QLearner:
        return cast(QLearner, self.members[robot])


@dataclass(frozen=True)
class Member:
    """One robot of a team, with the methods of `Learner`."""

    team: Team
    robot: Hashable
    learner: Learner

    @property
    def n_behaviors(self) -> int:
        """Number of behaviors to choose from."""
        return self.learner.n_behaviors

    @property
    def credits(self) -> tuple[Credit, ...]:
        """What the last `learn` believed each of its touches to be about."""
        return self.learner.credits

    def act(self, state: Hashable) -> int:
        """Choose a behavior."""
        return self.team.act(self.robot, state)

    def learn(self, experience: Experience) -> None:
        """Learn, and let the team have its part."""
        self.team.learn(self.robot, experience)

    def start_episode(self) -> None:
        """Forget this robot's history."""
        self.learner.start_episode()

    def q_values(self, state: Hashable) -> NDArray[np.float64]:
        """Value of every behavior in a state, shape (n_behaviors,)."""
        return self.team.q_values(self.robot, state)

    def common(self, state: Hashable) -> Hashable:
        """A state as the table has it that this robot learns into."""
        return self.team.common(self.robot, state)

    def save(self, path: str | Path) -> None:
        """Write the whole team: one robot's share cannot go on alone."""
        self.team.save(path)


def make_team(
    name: str,
    robots: Iterable[Hashable],
    n_behaviors: int,
    rng: np.random.Generator,
    sharing: Sharing = "independent",
    **overrides: Any,  # noqa: ANN401 - settings of whatever learner it is
) -> Team:
    """A team of like learners by name.

    Args:
        name: one of `learners.CATALOG`.
        robots: the robots' names.
        n_behaviors: number of behaviors to choose from.
        rng: parent of one random stream per robot.
        sharing: see `Team`.
        **overrides: settings of the learners, see `learners.make_learner`. A part with
            a memory, such as an adaptive analogy, is then one and the same for all.

    Raises:
        LearnerError: as `make_learner` and `Team` do.
    """
    names = tuple(robots)
    members = {
        robot: make_learner(name, n_behaviors, stream, **overrides)
        for robot, stream in zip(names, rng.spawn(len(names)), strict=True)
    }
    return Team(members=members, sharing=sharing)

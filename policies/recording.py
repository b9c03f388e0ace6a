"""Replays that also tell what the learners believe."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from functools import lru_cache
from pathlib import Path
from typing import cast

from household.environment import Household
from household.replay.choices import Choice
from household.replay.events import Belief, BeliefShare
from household.replay.recorder import Recorder
from learners.learner import Credit
from learners.team import Member
from policies.insight import Insights
from policies.learning import Home, LearningRobot, Observer, Pair


class RecordingObserver(Observer):
    """Writes a replay of what the household did and what its learners made of it.

    A second episode goes to a file of its own, whose name ends in ``_1``, and so on.

    Args:
        path: File to write, ends in .rrd; None: none.
        watch: Shows the episode in the viewer, or in the one at this address.
        flush_every: Decisions between writes; a killed process loses no more.
    """

    def __init__(
        self,
        path: Path | str | None,
        *,
        watch: bool | str = False,
        flush_every: int = 2000,
    ) -> None:
        self._path = None if path is None else Path(path)
        self._watch, self._flush_every = watch, flush_every
        self._episode = 0
        self._recorder: Recorder | None = None
        self._pairs: dict[str, Pair | None] = {}
        self._household: Household | None = None
        self._insights = Insights(())
        self._shares = False

    def reset(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """Begins a file; one that is open is closed."""
        self.close()
        self._pairs = dict.fromkeys(robots)
        household = cast(Household, getattr(env, "unwrapped", env))
        self._household = household
        self._insights = Insights(tuple(household.behaviors))
        learners = [robot.learner for robot in robots.values()]
        self._shares = any(isinstance(each, Member) for each in learners) or len(
            set(map(id, learners))
        ) < len(learners)
        self._recorder = Recorder(
            household.simulation,
            self._next_path(),
            learns=True,
            watch=self._watch,
            flush_every=self._flush_every,
        )

    def acted(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """Records what was learned, and what is known and chosen now."""
        assert self._recorder is not None
        self._record_credits(robots)
        # Values move when a pair is over; a table may be shared by several robots.
        if any(robots[name].pair is not last for name, last in self._pairs.items()):
            for name, robot in robots.items():
                self._record_choice(name, robot)

    def _record_choice(self, name: str, robot: LearningRobot) -> None:
        pair, last = robot.pair, self._pairs[name]
        if pair is None:
            return
        assert self._recorder is not None
        assert self._household is not None
        self._pairs[name] = pair
        if pair is last and not self._shares:
            return  # nobody else moves its values
        index = self._household.possible_agents.index(name)
        insight = self._insights.of(name, robot.learner, pair.state)
        choice = Choice(
            robot=name,
            behavior=pair.action,
            chosen=pair.chosen,
            situation=_told(pair.state),
            reference=self._household.simulation.appropriateness(index),
            **insight._asdict(),
        )
        self._recorder.choose(choice)

    def stepped(
        self, env: Home, actions: Mapping[str, int], robots: Mapping[str, LearningRobot]
    ) -> None:
        """Records what the step led to."""
        assert self._recorder is not None
        self._recorder.record()

    def finished(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """Records the last beliefs and closes the file."""
        assert self._recorder is not None
        self._record_credits(robots)
        self.close()

    def close(self) -> None:
        """Closes the file; for episodes that are broken off."""
        if self._recorder is not None:
            self._recorder.close()
            self._recorder = None

    def _next_path(self) -> Path | None:
        path, number = self._path, self._episode
        self._episode += 1
        if path is None or number == 0:
            return path
        return path.with_stem(f"{path.stem}_{number}")

    def _record_credits(self, robots: Mapping[str, LearningRobot]) -> None:
        assert self._recorder is not None
        for name, robot in robots.items():
            if robot.credits:
                self._insights.learned(robot.learner, robot.credits)
            for credit in robot.credits:
                if credit.reward is not None:
                    self._recorder.believe(_belief(name, credit))


@lru_cache(maxsize=4096)
def _told(state: Hashable) -> str:
    return str(state)


def _belief(robot: str, credit: Credit) -> Belief:
    """What a learner believes, in the words of the replay."""
    shares = {
        id(entry): BeliefShare(time=entry.time, behavior=entry.action, weight=weight)
        for entry, weight in credit.shares
    }
    reward = credit.reward
    assert reward is not None  # silence is credited, but nobody asks what it is about
    return Belief(
        robot=robot,
        giver=str(reward.giver),
        value=reward.value,
        time=reward.time,
        shares=tuple(shares.values()),
        designated=shares.get(id(credit.designated)),
    )

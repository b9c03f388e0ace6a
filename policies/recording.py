"""Replays that also tell what the learners believe."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import cast

from household.environment import Household
from household.replay.events import Belief, BeliefShare
from household.replay.recorder import Recorder
from learners.learner import Credit
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

    def reset(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """Begins a file; one that is open is closed."""
        self.close()
        self._pairs = dict.fromkeys(robots)
        household = cast(Household, getattr(env, "unwrapped", env))
        self._recorder = Recorder(
            household.simulation,
            self._next_path(),
            learns=True,
            watch=self._watch,
            flush_every=self._flush_every,
        )

    def acted(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """Records what was learned, and what is expected of each behavior now."""
        assert self._recorder is not None
        self._record_credits(self._recorder, robots)
        # Values move when a pair is over; a table may be shared by several robots.
        if any(robots[name].pair is not last for name, last in self._pairs.items()):
            for name, robot in robots.items():
                self._pairs[name] = pair = robot.pair
                if pair is not None:
                    self._recorder.value(name, robot.learner.q_values(pair.state))

    def stepped(
        self, env: Home, actions: Mapping[str, int], robots: Mapping[str, LearningRobot]
    ) -> None:
        """Records what the step led to."""
        assert self._recorder is not None
        self._recorder.record()

    def finished(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """Records the last beliefs and closes the file."""
        assert self._recorder is not None
        self._record_credits(self._recorder, robots)
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

    @staticmethod
    def _record_credits(
        recorder: Recorder, robots: Mapping[str, LearningRobot]
    ) -> None:
        for name, robot in robots.items():
            for credit in robot.credits:
                recorder.believe(_belief(name, credit))


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

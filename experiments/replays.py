"""Replay files: what a trial looked like and what its learners believed."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, cast

from experiments.runner import play
from experiments.trial import Trial
from policies.learning import Home, LearningRobot, Observer

if TYPE_CHECKING:
    from household.environment import Household
    from household.replay.events import Belief
    from household.replay.events import Share as Shown
    from household.replay.recorder import Recorder
    from learners.learner import Credit, Share


def record(trial: Trial, path: Path) -> None:
    """Runs a trial once more and writes it as a replay.

    Args:
        trial: The trial; the same seed gives the same episode.
        path: The file to write; there only once it is whole.
    """
    # The file's name is also what the viewer calls it, hence a folder of its own.
    with TemporaryDirectory(dir=path.parent, prefix=".", suffix=".tmp") as folder:
        temporary = Path(folder) / path.name
        play(trial, [Replay(temporary)])
        temporary.replace(path)


class Replay(Observer):
    """Watches an episode and writes it as a replay.

    Args:
        path: The file to write.
        watch: Shows the episode in the viewer while it goes on.
    """

    def __init__(self, path: Path, *, watch: bool = False) -> None:
        self._path, self._watch = path, watch
        self._recorder: Recorder | None = None

    def reset(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """Opens the file."""
        from household.replay.recorder import Recorder

        self._recorder = Recorder(
            cast("Household", env), self._path, learns=True, watch=self._watch
        )

    def acted(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """Notes what the robots now believe and expect."""
        assert self._recorder is not None  # opened by `reset`
        for agent, robot in robots.items():
            self._note_beliefs(self._recorder, agent, robot)
            state = env.situation(agent)
            self._recorder.value(agent, robot.learner.q_values(state))

    def stepped(
        self, env: Home, actions: Mapping[str, int], robots: Mapping[str, LearningRobot]
    ) -> None:
        """Notes the moment after a step."""
        assert self._recorder is not None  # opened by `reset`
        self._recorder.record()

    def finished(self, env: Home, robots: Mapping[str, LearningRobot]) -> None:
        """Closes the file."""
        assert self._recorder is not None  # opened by `reset`
        for agent, robot in robots.items():
            self._note_beliefs(self._recorder, agent, robot)
        self._recorder.close()

    def _note_beliefs(
        self, recorder: Recorder, agent: str, robot: LearningRobot
    ) -> None:
        if robot.lesson is not None:
            for credit in robot.lesson.credits:
                recorder.believe(_belief(agent, credit))


def _belief(agent: str, credit: Credit) -> Belief:
    from household.replay.events import Belief

    touch = credit.feedback
    return Belief(
        robot=agent,
        giver=str(touch.giver),
        value=touch.value,
        time=touch.time,
        shares=tuple(_shown(share) for share in credit.shares),
        designated=None if credit.designated is None else _shown(credit.designated),
    )


def _shown(share: Share) -> Shown:
    from household.replay.events import Share as Shown

    return Shown(time=share.time, behavior=share.action, weight=share.weight)

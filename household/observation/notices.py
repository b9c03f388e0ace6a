"""Notices: what a robot is told beside its observation, always of the same shape.

Environments hand them out as infos. Whether a choice is due is no more than any robot
knows of itself; who attends to it, it observes as well.
"""

from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import NDArray

from household.compiled.arrays import Floats, Indices, Integers, Mask
from household.compiled.jit import bind, compiled
from household.observation.frame import Frame, frame_of
from household.observation.kernel import View
from household.robots.robots import Robots
from household.scenario.scenario import Scenario


class Notices(NamedTuple):
    """What robots are told, a row for each.

    Attributes:
        caresses: How many each felt in the last step, shape (n_robots,).
        taps: The same of taps.
        behavior_over: Whether what it did is done, or nothing was begun, (n_robots,).
        attended: Whether any person attends to it, shape (n_robots,).
        action_mask: 1 for each action that is a choice now: every behavior if the last
            one is over, and else the present one, (n_robots, n_behaviors).
    """

    caresses: Annotated[Integers, "n_robots"]
    taps: Annotated[Integers, "n_robots"]
    behavior_over: Annotated[Mask, "n_robots"]
    attended: Annotated[Mask, "n_robots"]
    action_mask: Annotated[NDArray[np.int8], "n_robots", "n_numbers"]


class Notifier:
    """Writes what the robots of a household are told.

    Args:
        scenario: The household.
        frame: Numbers behaviors; None: as the scenario does.
    """

    def __init__(self, scenario: Scenario, frame: Frame | None = None) -> None:
        frame = frame or frame_of(scenario)
        self._shape = (len(scenario.robots), len(frame.behaviors))
        self._codes = frame.codes(scenario.behaviors)
        self._notices: Notices | None = None

    def new(self) -> Notices:
        """Arrays to write into."""
        n = self._shape[0]
        return Notices(
            caresses=np.zeros(n, np.int64),
            taps=np.zeros(n, np.int64),
            behavior_over=np.zeros(n, np.bool_),
            attended=np.zeros(n, np.bool_),
            action_mask=np.zeros(self._shape, np.int8),
        )

    def write(self, notices: Notices, robots: Robots, view: View) -> None:
        """Writes all of it.

        Args:
            notices: Where to; what they held is overwritten.
            robots: What they felt.
            view: What they may know; a household has one.
        """
        if notices is not self._notices:  # Mostly the same ones, and bound once.
            self._notices = notices
            told = notices, view.behavior, view.left, view.attends
            self._write = bind(_write, self._codes, *told)
        self._write()
        if robots.touched:  # Mostly nobody touches, and this happens at every step.
            for robot, touches in enumerate(robots.feedback):
                caresses = sum(touch.kind == "caress" for touch in touches)
                notices.caresses[robot] = caresses
                notices.taps[robot] = len(touches) - caresses


@compiled
def _write(
    codes: Indices,
    notices: Notices,
    behavior: Annotated[Indices, "n_robots"],
    left: Annotated[Floats, "n_robots"],
    attends: Annotated[Mask, "n", "n"],
) -> None:
    """Writes all but touches; ``codes`` are the numbers of the own behaviors."""
    n_robots = len(left)
    n_people = len(attends) - n_robots
    notices.caresses[:] = 0
    notices.taps[:] = 0
    notices.attended[:] = False
    notices.action_mask[:] = 0
    for robot in range(n_robots):
        over = left[robot] == 0.0
        notices.behavior_over[robot] = over
        for own in range(len(codes)):
            if over or own == behavior[robot]:
                notices.action_mask[robot, codes[own]] = 1
        for i in range(n_people):
            if attends[i, n_people + robot]:
                notices.attended[robot] = True

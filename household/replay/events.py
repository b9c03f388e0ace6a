"""Touches, and what they are about: in truth, and as a learner believes."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from household.feedback import Cause
from household.replay.buffer import REMEMBERED, Buffer
from household.replay.marks import Marks, Point
from household.scenario.scenario import Scenario
from household.simulation.snapshot import Touch

SHOWN = 5.0
"""How long a touch stays on the floor plan [s]."""


Asked = tuple[str, int, int]
"""A robot, the decision at which it was somewhere, and that at which this is asked."""


@dataclass(frozen=True, slots=True, kw_only=True)
class BeliefShare:
    """The share of a touch that a learner gives to a past history entry.

    Attributes:
        time: When the entry began [s].
        behavior: Index of its behavior.
        weight: Eligibility; 1 is a full share.
    """

    time: float
    behavior: int
    weight: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Belief:
    """What a learner believes a touch to be about.

    Attributes:
        robot: Name of the robot that learned.
        giver: Who touched.
        value: The touch's value, in [-1, 1].
        time: When it was felt [s].
        shares: The history entries that get a share of it.
        designated: The share of the entry that it is most about, if there is one.
    """

    robot: str
    giver: str
    value: float
    time: float
    shares: tuple[BeliefShare, ...]
    designated: BeliefShare | None


class Happened(NamedTuple):
    """What was collected between two writes.

    Attributes:
        span: The last decision of the write before, and the last one of this.
        touches: With the decisions at which they were felt.
        beliefs: With the decisions at which they were held, and the touches' causes.
        marks: What the floor plan shows, by name.
    """

    span: tuple[int, int]
    touches: list[tuple[int, Touch]]
    beliefs: list[tuple[int, Belief, Cause | None]]
    marks: dict[str, Marks]


class Events:
    """Collects touches and beliefs.

    Args:
        scenario: The household.
        buffer: Knows where the robots were.
    """

    def __init__(self, scenario: Scenario, buffer: Buffer) -> None:
        self._scenario, self._buffer = scenario, buffer
        self._robots = {name: i for i, name in enumerate(scenario.robot_names)}
        stay = max(1, round(SHOWN / scenario.decision_period))
        self._marks = {name: Marks(stay) for name in ("touches", "true", "believed")}
        self._touches: list[tuple[int, Touch]] = []
        self._beliefs: list[tuple[int, Belief, Cause | None]] = []
        self._causes: dict[tuple[str, str, float], Cause] = {}
        self._first = 0

    def feel(self, touches: Iterable[Touch]) -> None:
        """Adds the touches of this moment."""
        now = self._buffer.decision
        for touch in touches:
            self._touches.append((now, touch))
            key = (touch.robot, touch.feedback.giver, touch.feedback.time)
            self._causes[key] = touch.cause
            if len(self._causes) > REMEMBERED:
                del self._causes[next(iter(self._causes))]

    def believe(self, belief: Belief) -> None:
        """Adds what a learner believes at this moment."""
        cause = self._causes.pop((belief.robot, belief.giver, belief.time), None)
        self._beliefs.append((self._buffer.decision, belief, cause))

    def take(self) -> Happened:
        """Takes out what was added since the last time; the buffer still holds it."""
        self._mark()
        span = self._first, self._buffer.decision
        happened = Happened(span, self._touches, self._beliefs, self._marks)
        self._touches, self._beliefs = [], []
        last = self._buffer.decision
        self._marks = {name: marks.left(last) for name, marks in self._marks.items()}
        # Beliefs at this moment may still come.
        self._first = last
        return happened

    def _mark(self) -> None:
        """Marks what was added on the floor plan; all at once, which is far quicker."""
        felt = [(touch.robot, at, at) for at, touch in self._touches]
        spots = self._spots(felt)
        self._marks["touches"].items += [
            (at, touch.robot, (spot, touch.feedback))
            for (at, touch), spot in zip(self._touches, spots, strict=True)
        ]
        caused = [(t.cause.robot, t.cause.decision, at) for at, t in self._touches]
        self._marks["true"].items += _lines(felt, spots, self._spots(caused))
        held = [(at, b, b.designated) for at, b, _ in self._beliefs if b.designated]
        touched = [(b.robot, self._decision(b.time), at) for at, b, _ in held]
        meant = [(b.robot, self._decision(d.time), at) for at, b, d in held]
        lines = _lines(touched, self._spots(touched), self._spots(meant))
        self._marks["believed"].items += lines

    def _decision(self, time: float) -> int:
        """The decision at which something began [s]."""
        return round(time / self._scenario.decision_period)

    def _spots(self, asked: Sequence[Asked]) -> list[Point]:
        """Where robots were [m]."""
        if not asked:
            return []
        robots, decisions, now = zip(*asked, strict=True)
        which = [self._robots[robot] for robot in robots]
        found = self._buffer.spots(which, decisions, now).tolist()
        return [(x, y) for x, y in found]


def _lines(
    asked: Sequence[Asked], start: Sequence[Point], end: Sequence[Point]
) -> list[tuple[int, str | None, Any]]:
    """Marks of lines between places."""
    return [
        (now, None, (a, b)) for (_, _, now), a, b in zip(asked, start, end, strict=True)
    ]

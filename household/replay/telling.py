"""Writes touches, and what they are about, as pictures and words."""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from household.compiled.arrays import Floats
from household.feedback import Cause, Feedback
from household.replay.columns import colors, exact, strips, vectors, words
from household.replay.events import Belief, BeliefShare, Happened
from household.replay.marks import arcs, send_touch_marks, touch_color
from household.replay.names import Felt
from household.replay.sheets import LANE, second
from household.replay.stream import Stream, Times, times_of
from household.replay.touches import touch_columns
from household.scenario.scenario import Scenario
from household.simulation.snapshot import Touch
from household.view.colors import packed


class Telling:
    """Writes what was collected.

    Args:
        scenario: The household.
    """

    def __init__(self, scenario: Scenario) -> None:
        self._scenario, self._second = scenario, second(scenario)
        self._robots = {name: i for i, name in enumerate(scenario.robot_names)}

    def felt(self, happened: Happened) -> list[Felt]:
        """The touches that robots' names tell of."""
        marks = happened.marks["touches"]
        return [
            Felt(at, at + marks.stay, self._robots[robot], _mark_text(feedback))
            for at, robot, (_, feedback) in marks.items
            if robot is not None
        ]

    def send(self, stream: Stream, happened: Happened) -> None:
        """Writes what happened."""
        self._send_marks(stream, happened)
        if happened.touches:
            self._send_touches(stream, happened)
        if happened.beliefs:
            self._send_beliefs(stream, happened)

    def _times(self, decisions: Iterable[int]) -> Times:
        return times_of(decisions, self._scenario.decision_period)

    def _send_marks(self, stream: Stream, happened: Happened) -> None:
        import rerun as rr

        for name, marks in happened.marks.items():
            decisions, things, sizes = marks.groups(*happened.span)
            times = self._times(decisions)
            if name == "touches":
                send_touch_marks(stream, times, things, sizes)
                continue
            lines = np.array(things, np.float32).reshape(-1, 2, 2)
            drawn = strips(rr.LineStrips2D.descriptor_strips(), lines, sizes)
            stream.send(f"world/{name}", times, [drawn])

    def _send_touches(self, stream: Stream, happened: Happened) -> None:
        import rerun as rr

        touches = [touch for _, touch in happened.touches]
        felt = [touch.feedback for touch in touches]
        causes = [touch.cause for touch in touches]
        times = self._times(decision for decision, _ in happened.touches)
        stream.send("touches", times, touch_columns(touches))
        at = self._on_lanes(
            [(f.time, t.robot) for f, t in zip(felt, touches, strict=True)]
        )
        look = packed([touch_color(f.value) for f in felt])
        points = (
            vectors(rr.Points2D.descriptor_positions(), at[:, None]),
            colors(rr.Points2D.descriptor_colors(), look[:, None]),
        )
        stream.send("credit/past/touches", times, points)
        meant = self._on_lanes([(cause.time, cause.robot) for cause in causes])
        curves = arcs(at, meant, 1.0)[:, None]
        true = strips(rr.LineStrips2D.descriptor_strips(), curves)
        stream.send("credit/past/true", times, [true])
        now = [decision for decision, _ in happened.touches]
        told = [
            (at, touch.feedback.kind.upper(), self._touch_text(touch))
            for at, touch in happened.touches
        ]
        told += [
            (at, "BLAME", self._blame_text(touch))
            for at, touch in zip(now, touches, strict=True)
            if touch.cause.robot != touch.robot
        ]
        self._tell(stream, "events/touches", told)

    def _send_beliefs(self, stream: Stream, happened: Happened) -> None:
        import rerun as rr

        shares = [
            (decision, belief, share)
            for decision, belief, _ in happened.beliefs
            for share in belief.shares
        ]
        at = self._times(decision for decision, _, _ in shares)
        pairs = [(belief, share) for _, belief, share in shares]
        stream.send("credits", at, self._share_columns(pairs))
        touched = self._on_lanes([(b.time, b.robot) for b, _ in pairs])
        meant = self._on_lanes([(share.time, b.robot) for b, share in pairs])
        curves = arcs(touched, meant, -1.0)
        radii = np.array([0.005 + 0.025 * min(share.weight, 1.0) for _, share in pairs])
        lines = rr.LineStrips2D.columns(strips=curves, radii=radii)
        stream.send("credit/past/believed", at, lines)
        told = [(at, "CREDIT", self._belief_text(b)) for at, b, _ in happened.beliefs]
        mistakes = [(at, self._mistake(b, cause)) for at, b, cause in happened.beliefs]
        told += [(at, "MISTAKE", text) for at, text in mistakes if text]
        self._tell(stream, "events/credit", told)

    def _tell(
        self, stream: Stream, entity: str, told: list[tuple[int, str, str]]
    ) -> None:
        """Writes lines of the table of events: when, of what kind, and the text."""
        import rerun as rr

        told.sort(key=lambda line: line[0])
        at, levels, texts = zip(*told, strict=True)
        log = rr.TextLog.columns(text=list(texts), level=list(levels))
        stream.send(entity, self._times(at), log)

    def _on_lanes(self, events: Sequence[tuple[float, str]]) -> Floats:
        """Where times [s] and robots are in the picture of credit, shape (n, 2)."""
        points = [
            (time * self._second, self._robots[robot] * LANE) for time, robot in events
        ]
        return np.array(points, dtype=np.float64).reshape(-1, 2)

    def _share_columns(self, pairs: Sequence[tuple[Belief, BeliefShare]]) -> list[Any]:
        chosen = [belief.designated == share for belief, share in pairs]
        robot = [self._robots[belief.robot] for belief, _ in pairs]
        return [
            exact("robot", np.array(robot, dtype=np.int64)),
            words("giver", [belief.giver for belief, _ in pairs]),
            exact("touch_time", np.array([belief.time for belief, _ in pairs])),
            exact("time", np.array([share.time for _, share in pairs])),
            exact("behavior", np.array([share.behavior for _, share in pairs])),
            exact("weight", np.array([share.weight for _, share in pairs])),
            exact("designated", np.array(chosen, dtype=np.bool_)),
        ]

    def _touch_text(self, touch: Touch) -> str:
        felt, cause = touch.feedback, touch.cause
        other = "" if cause.robot == touch.robot else f" of {cause.robot}"
        return (
            f"{felt.kind} by {felt.giver} on {touch.robot} ({felt.value:+.2f}) for "
            f"{self._name(cause.behavior)}{other} {felt.time - cause.time:.1f} s before"
        )

    def _blame_text(self, touch: Touch) -> str:
        cause = touch.cause
        return (
            f"wrong blame by {touch.feedback.giver}: {touch.robot} got the "
            f"{touch.feedback.kind} for {self._name(cause.behavior)} of {cause.robot}"
        )

    def _belief_text(self, belief: Belief) -> str:
        shares = sorted(belief.shares, key=lambda share: -share.weight)[:3]
        about = ", ".join(
            f"{self._name(s.behavior)} {belief.time - s.time:.1f} s before "
            f"({s.weight:.2f})"
            for s in shares
        )
        return f"{belief.robot} believes, for {about or 'nothing'}"

    def _mistake(self, belief: Belief, cause: Cause | None) -> str | None:
        """What is wrong with a belief, in words; None if it is right."""
        meant = belief.designated
        if cause is None or meant is None or cause.robot != belief.robot:
            return None  # Of other robots' doings, none of its own entries is right.
        if meant.behavior == cause.behavior:
            return None
        return (
            f"wrong credit by {belief.robot}: {self._name(meant.behavior)}, where "
            f"{belief.giver} meant {self._name(cause.behavior)}"
        )

    def _name(self, behavior: int) -> str:
        return self._scenario.behaviors[behavior] if behavior >= 0 else "nothing"


def _mark_text(feedback: Feedback) -> str:
    return f"{feedback.kind} by {feedback.giver} {feedback.value:+.2f}"

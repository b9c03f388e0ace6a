"""Marks on the floor plan and bows in the picture of credit: how events are drawn."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from household.people.feedback import Feedback
from household.replay.colors import CARESS, TAP, packed
from household.replay.scenery import LANE
from household.replay.stream import Moments, Stream

Array = NDArray[np.float64]
Point = tuple[float, float]


@dataclass
class Marks:
    """Things that stay for a while and then go.

    Attributes:
        stay: For how many decisions.
        items: Since which decision, in order, and what.
    """

    stay: int
    items: list[tuple[int, Any]] = field(default_factory=list)

    def groups(self, first: int, last: int) -> tuple[list[int], list[list[Any]]]:
        """Which things are there at each decision at which that changes.

        Args:
            first: First decision asked for; things that are gone before are forgotten.
            last: Last decision asked for.
        """
        changes = {t for at, _ in self.items for t in (at, at + self.stay)}
        at = sorted(t for t in changes if first <= t <= last)
        groups, begin, end = [], 0, 0
        for moment in at:
            while end < len(self.items) and self.items[end][0] <= moment:
                end += 1
            while begin < end and self.items[begin][0] + self.stay <= moment:
                begin += 1
            groups.append([item for _, item in self.items[begin:end]])
        self.items = [(t, item) for t, item in self.items if t + self.stay > last]
        return at, groups


def send_touch_marks(
    stream: Stream,
    moments: Moments,
    groups: Sequence[Sequence[tuple[str, Point, Feedback]]],
) -> None:
    """Dots where robots were touched last; who touched them and how stands above."""
    import rerun as rr

    newest = [
        {robot: (spot, felt) for robot, spot, felt in group}.values()
        for group in groups
    ]
    marks = [mark for group in newest for mark in group]
    sizes = [len(group) for group in newest]
    spots = np.array([spot for spot, _ in marks]).reshape(-1, 2)
    dots = rr.Points2D.columns(
        positions=spots, colors=packed([touch_color(felt.value) for _, felt in marks])
    )
    stream.send("world/touches", moments, dots.partition(sizes))
    texts = rr.Points2D.columns(
        positions=spots + np.array([0.0, 0.5]),
        labels=[f"{f.giver}: {f.kind} {f.value:+.2f}" for _, f in marks],
    )
    stream.send("world/touches/texts", moments, texts.partition(sizes))


def arcs(start: Array, end: Array, side: float) -> NDArray[np.float32]:
    """Bows between points in the picture of credit.

    Args:
        start: Where they begin, shape (n, 2).
        end: Where they end, shape (n, 2).
        side: -1 bows upwards, 1 downwards.

    Returns:
        Shape (n, n_points, 2).
    """
    along = np.linspace(0.0, 1.0, 13)[None, :, None]
    bows = (1 - along) * start[:, None] + along * end[:, None]
    height = np.minimum(0.42, 0.12 + 0.3 * np.abs(start[:, 0] - end[:, 0]))
    rise = 4 * along * (1 - along) * height[:, None, None]
    bows[..., 1:] += side * LANE * rise
    return bows.astype(np.float32)


def touch_color(value: float) -> str:
    """Green for a caress, red for a tap."""
    return CARESS if value > 0 else TAP

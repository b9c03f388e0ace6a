"""Marks on the floor plan and bows in the picture of credit: how events are drawn."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from household.compiled.arrays import Floats, Integers, Singles
from household.feedback import Feedback
from household.replay.columns import colors, texts, vectors
from household.replay.scenery import LANE
from household.replay.stream import Stream, Times
from household.view.colors import CARESS, TAP, packed

Point = tuple[float, float]


@dataclass
class Marks:
    """Things that stay for a while and then go.

    Attributes:
        stay: For how many decisions.
        items: Since which decision, in order, in whose place, and what. In one place is
            what came last; None is a place for everything.
    """

    stay: int
    items: list[tuple[int, str | None, Any]] = field(default_factory=list)

    def groups(self, first: int, last: int) -> tuple[Integers, list[Any], Integers]:
        """Which things are there at each decision at which that changes.

        Args:
            first: First decision asked for; things that are gone before are forgotten.
            last: Last decision asked for.

        Returns:
            The decisions, the things that are there at one after the other of them, and
            how many those are at each.
        """
        since = np.array([at for at, _, _ in self.items], dtype=np.int64)
        until = self._until()
        at = np.unique(np.concatenate([since, until]))
        at = at[(first <= at) & (at <= last)]
        begin, end = np.searchsorted(at, since), np.searchsorted(at, until)
        which = np.repeat(np.arange(len(since)), end - begin)
        moment = np.concatenate(
            [np.arange(*span) for span in zip(begin, end, strict=True)] or [begin]
        )
        in_order = np.argsort(moment, kind="stable")
        things = [self.items[i][2] for i in which[in_order].tolist()]
        self.items = [item for item in self.items if item[0] + self.stay > last]
        return at, things, np.bincount(moment, minlength=len(at))

    def _until(self) -> Integers:
        """When each goes, or is taken the place of."""
        until = [at + self.stay for at, _, _ in self.items]
        newest: dict[str, int] = {}
        for i, (at, place, _) in enumerate(self.items):
            if place is not None:
                if place in newest:
                    until[newest[place]] = min(until[newest[place]], at)
                newest[place] = i
        return np.array(until, dtype=np.int64)


def send_touch_marks(
    stream: Stream,
    times: Times,
    marks: Sequence[tuple[Point, Feedback]],
    sizes: Integers,
) -> None:
    """Dots where robots were touched last; who touched them and how stands above.

    Args:
        stream: Where to.
        times: When what is there changes.
        marks: What is there at one moment after the other.
        sizes: How many those are at each moment.
    """
    import rerun as rr

    kind = rr.Points2D
    spots = np.array([spot for spot, _ in marks]).reshape(-1, 2)
    look = packed([CARESS, TAP])[[int(felt.value <= 0) for _, felt in marks]]
    dots = (
        vectors(kind.descriptor_positions(), spots, sizes),
        colors(kind.descriptor_colors(), look, sizes),
    )
    stream.send("world/touches", times, dots)
    told = [f"{f.giver}: {f.kind} {f.value:+.2f}" for _, f in marks]
    above = spots + np.array([0.0, 0.5])
    words = (
        vectors(kind.descriptor_positions(), above, sizes),
        texts(kind.descriptor_labels(), told, np.arange(len(told)), sizes),
    )
    stream.send("world/touches/texts", times, words)


def arcs(start: Floats, end: Floats, side: float) -> Singles:
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

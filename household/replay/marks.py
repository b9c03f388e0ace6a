"""How events are drawn: marks on the floor plan, arcs in the picture of credit."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from household.compiled.arrays import Floats, Integers, Singles
from household.feedback import Feedback
from household.replay.columns import colors, vectors
from household.replay.sheets import LANE
from household.replay.stream import Stream, Times
from household.view.colors import CARESS, TAP, packed

Point = tuple[float, float]


@dataclass
class Marks:
    """Things that are shown for a while.

    Attributes:
        stay: For how many decisions each is shown.
        items: The things in the order of time: since which decision, in which place,
            and what. A place shows only what came last; None is no place, and things
            without a place are all shown.
    """

    stay: int
    items: list[tuple[int, str | None, Any]] = field(default_factory=list)

    def groups(self, first: int, last: int) -> tuple[Integers, list[Any], Integers]:
        """Which things are shown at each decision at which that changes.

        Args:
            first: First decision asked for.
            last: Last decision asked for.

        Returns:
            The decisions; the things shown, those of one decision after those of the
            other; and how many are shown at each decision.
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
        return at, things, np.bincount(moment, minlength=len(at))

    def left(self, last: int) -> "Marks":
        """Those that are still shown after a decision."""
        items = [item for item in self.items if item[0] + self.stay > last]
        return Marks(self.stay, items)

    def _until(self) -> Integers:
        """The decision at which each goes, or is replaced."""
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
    """Writes dots where robots were touched.

    Args:
        stream: Where to.
        times: When the dots shown change.
        marks: The dots shown, those of one moment after those of the other.
        sizes: How many dots are shown at each moment.
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


def arcs(start: Floats, end: Floats, side: float) -> Singles:
    """Arcs between points in the picture of credit.

    Args:
        start: Where they begin, shape (n, 2).
        end: Where they end, shape (n, 2).
        side: -1 for arcs above, 1 for arcs below.

    Returns:
        Shape (n, n_points, 2).
    """
    along = np.linspace(0.0, 1.0, 13)[None, :, None]
    curves = (1 - along) * start[:, None] + along * end[:, None]
    height = np.minimum(0.42, 0.12 + 0.3 * np.abs(start[:, 0] - end[:, 0]))
    rise = 4 * along * (1 - along) * height[:, None, None]
    curves[..., 1:] += side * LANE * rise
    return curves.astype(np.float32)


def touch_color(value: float) -> str:
    """Green for a caress, red for a tap."""
    return CARESS if value > 0 else TAP

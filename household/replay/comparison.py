"""Two recordings of the same home and seed in one viewer, and where they part.

Episodes of one seed are equal until robots do something else; what then differs comes
from that. So two learners, or one before and after it learned, can be compared moment
by moment.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from household.errors import HouseholdError, shown_path
from household.replay import views
from household.replay.blueprint import time_panel
from household.replay.reading import Replay, read_replay
from household.replay.stream import Stream
from household.simulation.moment import FIELDS

SIDES = ("left", "right")
"""What entities of the two recordings are put below."""

KIND = "household two runs"


@dataclass(frozen=True)
class Parting:
    """The first moment at which two recordings differ.

    Attributes:
        decision: Of that moment.
        time: [s].
        what: The recorded fields that differ there, as in `Replay.moments`.
        behaviors: What the robots do there that do not do the same: robot, and its
            behavior in each recording.
    """

    decision: int
    time: float
    what: tuple[str, ...]
    behaviors: tuple[tuple[str, str, str], ...]

    def __str__(self) -> str:
        """In words, on one line."""
        if not self.behaviors:
            return f"they differ from {self.time:g} s on: {', '.join(self.what)}"
        done = ", ".join(f"{who}: {a} or {b}" for who, a, b in self.behaviors)
        return f"they differ from {self.time:g} s on: {done}"


def parting(one: Replay, other: Replay) -> Parting | None:
    """Where two replays first differ, bit for bit; None if all common moments agree.

    Raises:
        HouseholdError: If they are not of the same people, robots and behaviors.
    """
    _check_alike(one, other)
    n = min(len(one), len(other))
    differ = {
        name: _rows_differ(*(getattr(each.moments, name)[:n] for each in (one, other)))
        for name in FIELDS
    }
    anywhere = np.flatnonzero(np.any(list(differ.values()), axis=0))
    if not len(anywhere):
        return None
    first = int(anywhere[0])
    names = ("-", *one.scenario.behaviors)
    done = zip(
        one.scenario.robot_names,
        *(each.moments.behavior[first].tolist() for each in (one, other)),
        strict=True,
    )
    return Parting(
        decision=int(one.moments.decision[first]),
        time=float(one.moments.time[first]),
        what=tuple(name for name, rows in differ.items() if rows[first]),
        behaviors=tuple((r, names[a + 1], names[b + 1]) for r, a, b in done if a != b),
    )


def _check_alike(one: Replay, other: Replay) -> None:
    for what in ("person_names", "robot_names", "behaviors"):
        first, second = (getattr(each.scenario, what) for each in (one, other))
        if first != second:
            raise HouseholdError(
                f"two homes that differ in {what.replace('_', ' ')} "
                f"({', '.join(first)}; {', '.join(second)}) cannot be compared"
            )


def _rows_differ(one: Any, other: Any) -> Any:  # noqa: ANN401 - arrays of any kind
    flat = [np.ascontiguousarray(each).reshape(len(each), -1) for each in (one, other)]
    # By their bytes: what is not known is NaN, which equals nothing.
    first, second = (each.view(np.uint8).reshape(len(each), -1) for each in flat)
    return (first != second).any(axis=1)


def join(one: Path, other: Path, out: Path) -> Parting | None:
    """Writes two recordings into one, side by side, with where they part marked.

    Args:
        one: Shown on the left.
        other: Shown on the right.
        out: File to write.

    Returns:
        Where they part.

    Raises:
        HouseholdError: If one cannot be read, or they are of different homes.
    """
    replays = [read_replay(path) for path in (one, other)]
    try:
        parted = parting(*replays)
    except HouseholdError as error:
        files = " and ".join(map(shown_path, (one, other)))
        raise HouseholdError(f"{files}: {error}") from None
    stream = Stream(KIND, f"{one.stem} and {other.stem}", out)
    try:
        for side, path in zip(SIDES, (one, other), strict=True):
            _copy(stream, path, side)
        _mark(stream, parted)
        stream.flush()
        stream.recording.send_blueprint(_blueprint(replays, (one, other), parted))
        stream.flush()
    finally:
        stream.close()
    return parted


def _copy(stream: Stream, path: Path, side: str) -> None:
    """Sends all of a recording, with other paths."""
    from rerun.chunk import RrdReader

    chunks = [
        chunk.with_entity_path(f"/{side}/{chunk.entity_path.strip('/')}")
        for chunk in RrdReader(str(path)).stream()
        if not chunk.entity_path.strip("/").startswith("__properties")
    ]
    stream.recording.send_chunks(chunks)


def _mark(stream: Stream, parted: Parting | None) -> None:
    """A line in the log at the moment at which they part."""
    import rerun as rr

    if parted is None:
        return
    when = np.array([parted.decision]), np.array([parted.time])
    text = rr.TextLog.columns(text=[str(parted).capitalize()], level=["WARN"])
    stream.send("parting", when, text)


def _blueprint(
    replays: list[Replay], paths: tuple[Path, Path], parted: Parting | None
) -> Any:  # noqa: ANN401 - Rerun's
    import rerun.blueprint as rrb

    scenario = replays[0].scenario
    columns = []
    for side, replay, path in zip(SIDES, replays, paths, strict=True):
        prefix = f"/{side}"
        rows = [views.plan(scenario, prefix, _name(path))]
        if replay.values:
            reasons = [views.why(robot, prefix) for robot in scenario.robot_names]
            rows.append(rrb.Tabs(*reasons))
        rows.append(views.credit(scenario, prefix))
        shares = [5, 3, 2] if len(rows) == 3 else [5, 2]
        columns.append(rrb.Vertical(*rows, row_shares=shares))
    logs = [views.events(f"/{side}") for side in SIDES]
    if parted is not None:
        logs.insert(0, rrb.TextLogView(origin="/parting", name="They part"))
    return rrb.Blueprint(
        rrb.Vertical(
            rrb.Horizontal(*columns), rrb.Horizontal(*logs), row_shares=[5, 1]
        ),
        time_panel(scenario, "paused"),
        rrb.BlueprintPanel(state="collapsed"),
        rrb.SelectionPanel(state="collapsed"),
        auto_views=False,
    )


def _name(path: Path) -> str:
    return f"{path.parent.name}/{path.stem}"

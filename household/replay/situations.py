"""Situations in words, written when they change."""

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from household.compiled.arrays import Mask
from household.perception.reading import SituationReader
from household.perception.situation import Situation
from household.replay.columns import texts
from household.replay.rows import changes
from household.replay.stream import Stream
from household.scenario.scenario import Scenario
from household.simulation.moment import Moments

KEPT = 4096
"""How many texts are remembered, since they recur."""


class Situations:
    """Writes the situation that each robot sees.

    It follows from who plays which role and who attends to whom. It is read from the
    recorded moments when these are written, which costs the steps nothing.

    Args:
        scenario: The household.
    """

    def __init__(self, scenario: Scenario) -> None:
        self._reader = SituationReader(scenario)
        self._attention = scenario.situation.attention
        self._robots, self._n = scenario.robot_names, len(scenario.people)
        self._views = len(self._robots) if self._attention == "robot" else 1
        # A text recurs, and its halves still more often.
        self._text = lru_cache(maxsize=KEPT)(self._make_text)
        self._roles = lru_cache(maxsize=KEPT)(self._make_roles)
        self._sights = lru_cache(maxsize=KEPT)(self._make_sights)
        self._last = ""

    def send(self, stream: Stream, moments: Moments) -> None:
        """Writes the situations, at the moments at which the words change."""
        import rerun as rr

        looks = self._looks(moments.attends)
        where = changes(moments.activity, looks)
        among, which = self._texts(moments.activity[where], looks[where])
        told = changes(which)
        if self._last == among[which[0]]:
            told = told[1:]
        self._last = among[which[-1]]
        at = where[told]
        times = moments.decision[at], moments.time[at]
        kind = rr.TextDocument.descriptor_text()
        column = texts(kind, among, which[told, None])
        stream.send("situation", times, [column])

    def _texts(
        self, activity: NDArray[np.int64], looks: Mask
    ) -> tuple[list[str], NDArray[np.int64]]:
        """The different situations in words, and which of them each moment has."""
        parts = [_rows_of(activity), _rows_of(looks)]
        rows = np.concatenate(parts, axis=1)
        whole = rows.view(np.dtype((np.void, rows.shape[1])))[:, 0]
        _, first, which = np.unique(whole, return_index=True, return_inverse=True)
        among: dict[str, int] = {}
        numbers = [
            among.setdefault(
                self._text(parts[0][row].tobytes(), parts[1][row].tobytes()),
                len(among),
            )
            for row in first.tolist()
        ]
        return list(among), np.array(numbers, np.int64)[which]

    def _looks(self, attends: Mask) -> Mask:
        """The part of the attention that situations contain.

        Returns:
            Shape (n_moments, n_views, n_looks); each robot has its own view, or there
            is one for all.
        """
        n = self._n
        if self._attention == "robot":
            return np.ascontiguousarray(attends[:, :n, n:].transpose(0, 2, 1))
        seen = attends if self._attention == "all" else attends[:, :0]
        return seen.reshape(len(attends), 1, -1)

    def _make_text(self, activity: bytes, looks: bytes) -> str:
        """The situations in words; one line if all see the same."""
        width, roles = len(looks) // self._views, self._roles(activity)
        lines = []
        for view in range(self._views):
            sights = self._sights(looks[view * width : (view + 1) * width], view)
            lines.append(f"{roles}, {sights}" if roles and sights else roles or sights)
        if lines.count(lines[0]) == len(lines):
            return lines[0]
        pairs = zip(self._robots, lines, strict=True)
        return "\n".join([f"{robot}: {text}" for robot, text in pairs])

    def _make_roles(self, activity: bytes) -> str:
        """Who plays which role, in words."""
        everybody = self._n + len(self._robots)
        nothing = np.zeros((everybody, everybody), np.bool_)
        seen = self._reader.seen(np.frombuffer(activity, np.int64), nothing)
        return str(Situation(seen[0].plays))

    def _make_sights(self, looks: bytes, view: int) -> str:
        """Who attends to whom in words, from one point of view."""
        n, everybody = self._n, self._n + len(self._robots)
        attends = np.zeros((everybody, everybody), np.bool_)
        parts = {"robot": attends[:n, n + view], "all": attends, "none": attends[:0]}
        part = parts[self._attention]
        part[...] = np.frombuffer(looks, np.bool_).reshape(part.shape)
        seen = self._reader.seen(np.zeros(n, np.int64), attends)
        return str(Situation((), seen[view].attends))


def _rows_of(values: NDArray[Any]) -> NDArray[np.uint8]:
    """The bytes of each row."""
    flat = np.ascontiguousarray(values).reshape(len(values), -1)
    return flat.view(np.uint8)

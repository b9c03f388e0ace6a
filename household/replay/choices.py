"""Choices: what a learner chose, from what it knew, and what a reference would do."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from household.compiled.arrays import Floats
from household.replay.columns import exact, words
from household.replay.stream import Stream, Times
from household.replay.why import page
from household.scenario.scenario import Scenario


@dataclass(frozen=True, slots=True, kw_only=True)
class Choice:
    """A learner's view of its behaviors, as it began one or found itself elsewhere.

    Attributes:
        robot: Name of the robot.
        behavior: Index of what it does.
        chosen: False if it goes on with what it did, in another situation.
        situation: What it sees, in words.
        represented: What it takes that for, in words; empty if it is the situation.
        values: What it expects of each behavior, shape (n_behaviors,).
        probabilities: With what probability it takes each, (n_behaviors,); None: its
            rule does not say.
        touches: How many touches taught each value, (n_behaviors,); None: not known.
        updates: Updates behind each value, (n_behaviors,); None: not known.
        reference: What the people present would think of each, (n_behaviors,).
        taught: The last touch that changed these values, in words; empty: none yet.
        is_first: Whether it is the first time that it meets what it represents.
        before: What it held best there the time before; -1: nothing, or the same.
    """

    robot: str
    behavior: int
    chosen: bool
    situation: str
    represented: str
    values: Floats
    probabilities: Floats | None
    touches: Floats | None
    updates: Floats | None
    reference: Floats
    taught: str
    is_first: bool
    before: int

    @property
    def is_greedy(self) -> bool:
        """Whether nothing was expected to be better."""
        return bool(self.values[self.behavior] == self.values.max())


Chosen = list[tuple[int, Choice]]
"""Choices, with the decisions at which they were made."""


class Choices:
    """Collects choices and writes them.

    Args:
        scenario: The household.
        times: Makes times of decisions.
    """

    def __init__(
        self, scenario: Scenario, times: Callable[[Iterable[int]], Times]
    ) -> None:
        self._behaviors = tuple(scenario.behaviors)
        self._robots = {name: i for i, name in enumerate(scenario.robot_names)}
        self._times = times
        self._choices: Chosen = []
        self._begun: dict[str, Choice] = {}

    def add(self, decision: int, choice: Choice) -> None:
        """Adds a choice.

        Args:
            decision: When it was made.
            choice: What it was.
        """
        self._choices.append((decision, choice))

    def take(self) -> Chosen:
        """Takes out what was added since the last time."""
        taken, self._choices = self._choices, []
        return taken

    def send(self, stream: Stream, taken: Chosen) -> None:
        """Writes choices, in the order in which they were taken out."""
        if taken:
            self._send_exact(stream, taken)
            for robot in self._robots:
                own = [(at, c) for at, c in taken if c.robot == robot]
                self._send_pages(stream, robot, own)
            self._send_events(stream, taken)

    def _send_exact(self, stream: Stream, taken: Chosen) -> None:
        choices = [choice for _, choice in taken]
        numbers: Mapping[str, Sequence[Any]] = {
            "robot": [self._robots[c.robot] for c in choices],
            "behavior": [c.behavior for c in choices],
            "chosen": [c.chosen for c in choices],
            "values": [c.values for c in choices],
            "probabilities": [self._known(c.probabilities) for c in choices],
            "touches": [self._known(c.touches) for c in choices],
            "updates": [self._known(c.updates) for c in choices],
            "reference": [c.reference for c in choices],
        }
        columns = [exact(name, np.array(column)) for name, column in numbers.items()]
        columns.append(words("situation", [c.situation for c in choices]))
        stream.send("choices", self._times(at for at, _ in taken), columns)

    def _known(self, values: Floats | None) -> NDArray[np.float64]:
        return np.full(len(self._behaviors), np.nan) if values is None else values

    def _send_pages(
        self, stream: Stream, robot: str, own: Sequence[tuple[int, Choice]]
    ) -> None:
        import rerun as rr

        if not own:
            return
        times = self._times(at for at, _ in own)
        values = np.array([choice.values for _, choice in own])
        stream.send(f"q/{robot}", times, rr.Scalars.columns(scalars=values))
        pages = []
        for _, choice in own:
            if choice.chosen:
                self._begun[robot] = choice
            begun = self._begun.get(robot, choice)
            pages.append(page(choice, begun, self._behaviors))
        kind = ["text/markdown"] * len(pages)
        documents = rr.TextDocument.columns(text=pages, media_type=kind)
        stream.send(f"why/{robot}", times, documents)

    def _send_events(self, stream: Stream, taken: Chosen) -> None:
        import rerun as rr

        told: dict[str, list[tuple[int, str, str]]] = {"firsts": [], "minds": []}
        for at, choice in taken:
            for entity, level, text in self._events(choice):
                told[entity].append((at, level, text))
        for entity, lines in told.items():
            if lines:
                when, levels, texts = zip(*lines, strict=True)
                log = rr.TextLog.columns(text=list(texts), level=list(levels))
                stream.send(f"events/{entity}", self._times(when), log)

    def _events(self, choice: Choice) -> Iterable[tuple[str, str, str]]:
        name, robot = self._behaviors, choice.robot
        seen = choice.represented or choice.situation
        if choice.is_first:
            yield "firsts", "FIRST", f"first visit by {robot}: {seen}"
        if choice.before >= 0:
            best = int(choice.values.argmax())
            yield (
                "minds",
                "MIND",
                f"change of mind of {robot}: {name[best]} rather than "
                f"{name[choice.before]}, when {seen}",
            )

"""The recorder: watches one episode and writes it as a replay."""

import atexit
import time
from collections.abc import Callable, Iterable
from functools import lru_cache, partial
from pathlib import Path

import msgspec
import numpy as np

from household.replay.aside import Aside
from household.replay.blueprint import blueprint
from household.replay.buffer import FLUSH_EVERY, Buffer, Held
from household.replay.choices import Choice, Choices, Chosen
from household.replay.events import Belief, Events, Happened
from household.replay.moments import send_moments, send_state
from household.replay.process import open_viewer
from household.replay.scenery import send_scenery
from household.replay.situations import Situations
from household.replay.stream import Stream, Times, saved_blueprint, times_of
from household.replay.telling import Telling
from household.scenario.scenario import Scenario
from household.simulation.simulation import Simulation
from household.simulation.snapshot import touches

WATCH_EVERY = 0.5
"""Time between writes while somebody watches [s of the wall clock]."""


class Recorder:
    """Writes one episode, from the moment after its reset.

    Moments are kept in memory and written as columns, since a call to Rerun at each
    step would cost more than the simulation; the columns are made by another thread. If
    the process is killed, the file holds everything up to the last write.

    Args:
        simulation: The household's; its episode has just begun.
        path: File to write, ends in .rrd; None: none.
        learns: Whether learners will report what they believe.
        watch: Whether to show the episode while it goes on, in the viewer, which is
            opened if necessary; or the address of the viewer to show it in.
        flush_every: Decisions between writes.
    """

    def __init__(
        self,
        simulation: Simulation,
        path: Path | str | None = None,
        *,
        learns: bool = False,
        watch: bool | str = False,
        flush_every: int = FLUSH_EVERY,
    ) -> None:
        scenario = simulation.scenario
        self._scenario, self._robots = scenario, simulation.robots
        self._buffer = Buffer(simulation, flush_every)
        self._events, self._telling = Events(scenario, self._buffer), Telling(scenario)
        self._total = np.zeros(len(scenario.robots))
        self._situations = Situations(scenario)
        self._choices = Choices(scenario, self._times)
        self._watch, self._written = bool(watch), time.monotonic()
        self._aside = Aside()
        kind = f"household-{scenario.name}{'-learning' if learns else ''}"
        target = None if path is None else Path(path)
        name = scenario.name if target is None else target.stem
        self._stream = Stream(kind, name, target, _address(watch))
        self.record()
        self._begin(learns)
        atexit.register(self.close)

    def _begin(self, learns: bool) -> None:
        scenario = self._scenario
        # As text, since a scenario is not hashable.
        whole = msgspec.structs.replace(scenario, home=scenario.plan)
        text = msgspec.json.encode(whole)
        live = self._watch
        # First what is read back, so that no file that a kill cuts off is empty.
        self._stream.describe(scenario=text.decode())
        send_state(self._stream, self._buffer.moments(self._buffer.held()))
        self._stream.flush()  # Else Rerun writes it where it likes.
        self._stream.send_blueprint(_blueprint(text, learns, live, self._stream.kind))
        send_scenery(self._stream, scenario, learns)
        self._stream.flush()

    def record(self) -> None:
        """Records this moment; to be called after each step."""
        buffer, robots = self._buffer, self._robots
        buffer.put()
        if robots.touched:
            self._events.feel(touches(robots))
        if buffer.full or (self._watch and self._is_due()):
            self._aside.begin(self._taken())

    def choose(self, choice: Choice) -> None:
        """Records what a learner knows, and does, as of this moment."""
        self._choices.add(self._buffer.decision, choice)

    def believe(self, belief: Belief) -> None:
        """Records what a learner now believes a touch to be about."""
        self._events.believe(belief)

    def flush(self) -> None:
        """Writes everything so far, and waits until it is written."""
        self._aside.wait()
        self._taken()()
        self.wait()

    def wait(self) -> None:
        """Waits until Rerun has written all that it was given."""
        self._aside.wait()
        self._stream.flush()

    def _taken(self) -> Callable[[], None]:
        """Takes everything so far; returns what gives it to Rerun."""
        self._aside.wait()
        happened, held = self._events.take(), self._buffer.take()
        self._written = time.monotonic()
        return partial(self._send, held, happened, self._choices.take())

    def _send(self, held: Held, happened: Happened, chosen: Chosen) -> None:
        self._telling.send(self._stream, happened)
        self._choices.send(self._stream, chosen)
        # After those, so that what a kill leaves of a file has all that belongs to the
        # moments in it.
        moments, total = self._buffer.moments(held), self._total
        self._total = total + moments.reward.sum(axis=0)
        if len(moments):
            felt = self._telling.felt(happened)
            send_moments(self._stream, self._scenario, moments, total, felt)
            self._situations.send(self._stream, moments)

    def close(self) -> None:
        """Writes the rest and closes the file; a second time does nothing."""
        if self._stream.is_open:
            atexit.unregister(self.close)
            try:
                self.flush()
            finally:
                self._stream.close()

    def _is_due(self) -> bool:
        return time.monotonic() - self._written >= WATCH_EVERY

    def _times(self, decisions: Iterable[int]) -> Times:
        return times_of(decisions, self._scenario.decision_period)


def _address(watch: bool | str) -> str | None:
    """The address of the viewer that is to show the episode."""
    if isinstance(watch, str):
        return watch
    return open_viewer() if watch else None


@lru_cache(maxsize=8)
def _blueprint(scenario: bytes, learns: bool, live: bool, kind: str) -> bytes:
    """The stored blueprint; made once for all episodes of a household."""
    household = msgspec.json.decode(scenario, type=Scenario)
    return saved_blueprint(blueprint(household, learns, live), kind)

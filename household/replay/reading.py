"""Reading back: a replay file as the snapshots that were taken, bit for bit."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import msgspec
from numpy.typing import NDArray

from household.compiled.arrays import Floats, Integers
from household.errors import HouseholdError
from household.feedback import Cause, Feedback
from household.replay.chunks import Table, read_tables
from household.replay.rows import Rows
from household.scenario.scenario import Scenario
from household.simulation.snapshot import Snapshot, Touch, layout


@dataclass(frozen=True)
class Replay:
    """An episode read from a file.

    Attributes:
        scenario: The household, its floor plan included.
        rows: What happened, moment by moment.
        touches: The touches of the steps, by the decision that each step led to.
        values: What each learning robot expected of its behaviors: decisions, shape
            (n,), and values, shape (n, n_behaviors); empty without learners.
        credits: One row for each entry that a learner gave a share of a touch:
            ``decision`` at which it was learned, ``robot`` (index), ``giver``,
            ``touch_time`` [s], ``time`` [s] when the entry began, ``behavior``
            (index), ``weight``, ``designated``; empty without learners.
    """

    scenario: Scenario
    rows: Rows
    touches: dict[int, tuple[Touch, ...]]
    values: dict[str, tuple[Integers, Floats]]
    credits: Table

    def __len__(self) -> int:
        return len(self.rows)

    def snapshot(self, index: int) -> Snapshot:
        """The moment with this index, as it was taken.

        Args:
            index: 0 is the moment after the reset; negative ones count from the end.

        Raises:
            IndexError: If there is no such moment.
        """
        decision = int(self.rows.decision[index])
        arrays = {n: getattr(self.rows, n)[index] for n in layout(self.scenario)}
        return Snapshot(
            decision=decision,
            time=float(self.rows.time[index]),
            touches=self.touches.get(decision, ()),
            **arrays,
        )

    def __iter__(self) -> Iterator[Snapshot]:
        return (self.snapshot(index) for index in range(len(self)))


def read_replay(path: Path | str) -> Replay:
    """Reads a replay file, also one that a kill cut off.

    Raises:
        HouseholdError: If it cannot be read or is no replay of a household.
    """
    tables = read_tables(Path(path))
    if not {"__properties/household", "state"} <= tables.keys():
        raise HouseholdError(f"{path}: no replay of a household, or an empty one")
    text = str(tables["__properties/household"]["scenario"][0])
    scenario = msgspec.json.decode(text, type=Scenario)
    values = {name: tables.get(f"q/{name}", {}) for name in scenario.robot_names}
    return Replay(
        scenario=scenario,
        rows=_rows(scenario, tables["state"]),
        touches=_touches(tables.get("touches", {})),
        values={n: (t["decision"], t["scalars"]) for n, t in values.items() if t},
        credits=tables.get("credits", {}),
    )


def _rows(scenario: Scenario, state: Table) -> Rows:
    decision = state["decision"]
    arrays: dict[str, NDArray[Any]] = {
        name: state[name].reshape(len(decision), *shape).astype(kind, copy=False)
        for name, (shape, kind) in layout(scenario).items()
    }
    time: Floats = decision * scenario.decision_period
    return Rows(decision=decision, time=time, **arrays)


def _touches(table: Table) -> dict[int, tuple[Touch, ...]]:
    touches: dict[int, tuple[Touch, ...]] = {}
    for row, decision in enumerate(table.get("decision", ())):
        touch = _touch({name: column[row] for name, column in table.items()})
        touches[int(decision)] = (*touches.get(int(decision), ()), touch)
    return touches


def _touch(row: dict[str, Any]) -> Touch:
    strength, time, mood = (float(number) for number in row["numbers"])
    approach, attention = (_known(float(moment)) for moment in row["began"])
    feedback = Feedback(
        giver=row["giver"],
        kind=row["kind"],
        strength=strength,
        time=time,
        mood=mood,
        attending=bool(row["attending"]),
        approach_began=approach,
        attention_began=attention,
    )
    decision, behavior = (int(number) for number in row["cause"])
    cause = Cause(row["cause_robot"], decision, behavior, float(row["cause_time"]))
    return Touch(row["robot"], feedback, cause)


def _known(moment: float) -> float | None:
    return None if math.isnan(moment) else moment

"""Reading back: a replay file as the snapshots that were taken, bit for bit."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import msgspec
import numpy as np

from household.compiled.arrays import Floats, Integers
from household.config.toml import convert
from household.errors import LONGEST, HouseholdError, shown_path
from household.replay.chunks import Table, read_tables
from household.replay.probing import check_readable
from household.replay.touches import touches_of
from household.scenario.scenario import Scenario
from household.simulation.moment import DECISION, Moments, recorded_types
from household.simulation.snapshot import Snapshot, Touch


@dataclass(frozen=True)
class Replay:
    """An episode read from a file.

    Attributes:
        scenario: The household, its floor plan included.
        moments: What happened, moment by moment.
        touches: The touches of the steps, by the decision that each step led to.
        values: What each learning robot expected of its behaviors: decisions, shape
            (n,), and values, shape (n, n_behaviors); empty without learners.
        credits: One row for each history entry that a learner gave a share of a touch:
            ``decision`` at which it was learned, ``robot`` (index), ``giver``,
            ``touch_time`` [s], ``time`` [s] when the entry began, ``behavior``
            (index), ``weight``, ``designated``; empty without learners.
        choices: One row for each choice of a learner, and for each time that it found
            itself in another situation: ``decision``, ``robot`` (index), ``behavior``
            (index), ``chosen`` (0: it went on), ``situation`` in words, and one number
            for each behavior in ``values``, ``probabilities``, ``touches``, ``updates``
            (all three NaN if not known) and ``reference``; empty without learners.
    """

    scenario: Scenario
    moments: Moments
    touches: dict[int, tuple[Touch, ...]]
    values: dict[str, tuple[Integers, Floats]]
    credits: Table
    choices: Table

    def __len__(self) -> int:
        return len(self.moments)

    def snapshot(self, index: int) -> Snapshot:
        """The moment with this index, as it was taken.

        Args:
            index: 0 is the moment after the reset; negative ones count from the end.

        Raises:
            IndexError: If there is no such moment.
        """
        decision = int(self.moments.decision[index])
        return Snapshot(
            decision=decision,
            time=float(self.moments.time[index]),
            touches=self.touches.get(decision, ()),
            **self.moments.at(index),
        )

    def __iter__(self) -> Iterator[Snapshot]:
        return (self.snapshot(index) for index in range(len(self)))


def read_replay(path: Path | str, *, tried: bool = False) -> Replay:
    """Reads a replay file, also one that a kill cut off.

    Args:
        path: The file.
        tried: Whether it is known that reading it does no harm, as with a file of one's
            own. Else another process reads it first, which takes a second or two, since
            some forged files end the process that reads them.

    Raises:
        HouseholdError: If it cannot be read or is no replay of a household.
    """
    if not tried:
        check_readable(path)
    tables, origin = read_tables(Path(path)), shown_path(path)
    if not {"__properties/household", "state"} <= tables.keys():
        raise HouseholdError(
            f"{origin}: no replay of a household, or cut off before its first moment"
        )
    try:
        return _replay(tables)
    # What a stranger's file may lack, or hold in another form.
    except (KeyError, IndexError, TypeError, ValueError, OverflowError) as error:
        reason = " ".join(str(error).split())[:LONGEST]
        raise HouseholdError(
            f"{origin}: no replay of a household, or a damaged one ({reason})"
        ) from error


def _replay(tables: dict[str, Table]) -> Replay:
    text = str(tables["__properties/household"]["scenario"][0])
    scenario = convert(msgspec.json.decode(text), Scenario, "its scenario")
    values = {name: tables.get(f"q/{name}", {}) for name in scenario.robot_names}
    return Replay(
        scenario=scenario,
        moments=_moments(scenario, tables["state"]),
        touches=touches_of(tables.get("touches", {})),
        values={n: (t["decision"], t["scalars"]) for n, t in values.items() if t},
        credits=tables.get("credits", {}),
        choices=tables.get("choices", {}),
    )


def _moments(scenario: Scenario, state: Table) -> Moments:
    # The first moment is written twice: at once, and again with those after it.
    decision, first = np.unique(state[DECISION], return_index=True)
    state = {name: column[first] for name, column in state.items()}
    time: Floats = decision * scenario.decision_period
    arrays = {
        name: state[name].reshape(-1, *kind.shape).astype(kind.base, copy=False)
        for name, kind in recorded_types(scenario).items()
    }
    return Moments(decision=decision, time=time, **arrays)

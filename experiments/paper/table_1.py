"""Table 1: how a tap is shared among the past, worked out by the learners' own code."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import polars as pl

from experiments.analysis.statistics import Estimate, FloatArray
from experiments.analysis.tables import Cell, Table
from learners.credit.heuristics import BeforeApproach, Heuristic, MostRecent
from learners.credit.history import History
from learners.credit.rules import Designated
from learners.credit.transitions import SituationNetwork
from learners.experience import Experience, Reward

SIGMA_STM, SIGMA_RWD = 1.6, 1.0
"""[s] and without unit; inferred from the table (docs/deviations.md, 22)."""

_CERTAIN = (1, 1)
_TRANSITIONS = {
    ((5, 1), 5): _CERTAIN,
    ((5, 0), 6): (11, 26),
    ((6, 0), 1): _CERTAIN,
    ((1, 0), 8): (1, 10),
    ((8, 0), 13): _CERTAIN,
    ((13, 0), 11): _CERTAIN,
}
"""(situation, action), next situation -> how often of how many times; inferred, too."""


@dataclass(frozen=True, kw_only=True)
class Line:
    """A line of the table: a pair of the history and what it gets of the tap."""

    situation: int
    action: int
    seconds: float
    """From the designated pair, (5, 0). [s]"""

    classic: float
    """As printed."""

    heuristic: float
    """As printed."""


LINES = tuple(
    Line(situation=s, action=a, seconds=t, classic=c, heuristic=h)
    for s, a, t, c, h in (
        (11, 0, 5.0, 1.000, 0.000),
        (13, 0, 3.0, 0.003, 0.000),
        (8, 0, 2.0, 0.000, 0.000),
        (1, 0, 2.0, 0.000, 0.003),
        (6, 0, 1.0, 0.000, 0.100),
        (5, 0, 0.0, 0.000, 1.000),
        (5, 1, -7.0, 0.000, 0.000),
        (5, 1, -15.0, 0.000, 0.000),
    )
)
"""The table as printed, the latest pair first."""

_TOUCH = Reward(value=-1.0, time=5.5, giver="actor", attending=True, approach_began=1.5)
"""The giver leaves, which makes it situation 6 a second later, and is then seen coming.
"""


def columns() -> tuple[FloatArray, FloatArray]:
    """Returns the columns "Classic RL" and "Heuristic", the latest pair first.

    Returns:
        Two arrays of shape (8,), eligibilities as the learners' credit rule gives them.
    """
    return _column(MostRecent()), _column(BeforeApproach())


def agreement(frame: pl.DataFrame) -> FloatArray:
    """Returns 1 for each cell that agrees with the printed table, else 0.

    Args:
        frame: Not looked at; the table needs no trials.

    Returns:
        Shape (16,): the classic column, then the heuristic one.
    """
    printed = [line.classic for line in LINES] + [line.heuristic for line in LINES]
    found = np.concatenate(columns()).round(3)
    same: FloatArray = (found == np.round(printed, 3)).astype(np.float64)
    return same


def table(frame: pl.DataFrame) -> Table:
    """Returns Table 1 as printed and as it comes out here.

    Args:
        frame: Not looked at.
    """
    classic, heuristic = columns()
    rows = [
        (
            f"({line.situation}, {line.action})",
            tuple(
                Cell(text=text)
                for text in (
                    _seconds(line.seconds),
                    f"{line.classic:.3f}",
                    f"{found_classic:.3f}",
                    f"{line.heuristic:.3f}",
                    f"{found_heuristic:.3f}",
                )
            ),
        )
        for line, found_classic, found_heuristic in zip(
            LINES, classic, heuristic, strict=True
        )
    ]
    return Table(
        name="table_1",
        title="Table 1: what each pair of the history gets of a tap",
        header=(
            "situation, action",
            "from the designated",
            "classic: paper",
            "here",
            "heuristic: paper",
            "here",
        ),
        rows=tuple(rows),
        note=(
            "The tap is meant for (5, 0). The paper does not print the constants: "
            f"sigma_stm {SIGMA_STM} s, sigma_rwd {SIGMA_RWD}, r = -1 and two "
            "transition probabilities (11/26 and 1/10) are inferred from the table."
        ),
    )


def _seconds(seconds: float) -> str:
    sign = "+" if seconds > 0 else "\N{MINUS SIGN}" if seconds < 0 else ""
    return f"{sign}{abs(seconds):.0f} s"


def computed(values: FloatArray) -> Estimate:
    """Returns a share that was worked out, not sampled: it has no interval."""
    nan = float("nan")
    return Estimate(
        value=float(np.mean(values)), low=nan, high=nan, n=len(values), method="exact"
    )


def _column(heuristic: Heuristic) -> FloatArray:
    rule = Designated(heuristic=heuristic, sigma_stm=SIGMA_STM, sigma_rwd=SIGMA_RWD)
    history = _history()
    weights = rule.weigh(_TOUCH, history, _network()).weights
    newest_first = range(len(history) - 1, -1, -1)
    return np.array([weights.get(index, 0.0) for index in newest_first])


def _history() -> History:
    history = History()
    oldest_first = LINES[::-1]
    ends = [line.seconds for line in oldest_first[1:]] + [6.0]
    for line, end in zip(oldest_first, ends, strict=True):
        history.append(
            Experience(
                state=line.situation,
                action=line.action,
                next_state=line.situation,
                time=line.seconds,
                next_time=end,
            )
        )
    return history


def _network() -> SituationNetwork:
    network = SituationNetwork()
    for ((state, action), following), (times, of) in _TRANSITIONS.items():
        for time in range(of):
            network.count(state, action, following if time < times else "elsewhere")
    return network

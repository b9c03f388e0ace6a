"""Target situations: those that an experiment of the paper is about, by its names."""

from __future__ import annotations

from dataclasses import dataclass

import polars as pl

from household.perception.situation import Situation


@dataclass(frozen=True, kw_only=True)
class TargetSituation:
    """A situation as the paper names it, found by what it says of a person."""

    name: str
    """As in the paper, e.g. `S11`."""

    role: str
    """The role that somebody plays in it, e.g. `playing`."""

    attended: bool | None = None
    """Whether somebody attends to somebody in it; None: either."""

    def __call__(self, situation: Situation) -> bool:
        """Returns whether a situation fits."""
        plays = any(role == self.role for _, role in situation.plays)
        return plays and self.attended in (None, bool(situation.attends))

    def find(self, frame: pl.DataFrame) -> str | None:
        """Returns the key of the most frequent situation that fits, or None.

        Args:
            frame: The table of a trial or of a study.
        """
        role = pl.element().struct.field("role")
        fits = pl.col("roles").list.eval(role == self.role).list.any()
        if self.attended is not None:
            attended = pl.col("attention").list.len() > 0
            fits &= attended == pl.lit(self.attended)
        chosen = frame.filter(pl.col("chosen") & fits)["situation"]
        found = chosen.value_counts(sort=True)
        return None if found.is_empty() else str(found["situation"][0])

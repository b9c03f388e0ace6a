"""Scenes: the situations that an experiment of the paper is about, by its names."""

from __future__ import annotations

from dataclasses import dataclass

import polars as pl


@dataclass(frozen=True, kw_only=True)
class Scene:
    """A situation as the paper names it, found by what it says of a person."""

    name: str
    """As in the paper, e.g. `S11`."""

    role: str
    """The role that somebody plays in it, e.g. `playing`."""

    attended: bool | None = None
    """Whether somebody attends to somebody in it; None: either."""

    def find(self, frame: pl.DataFrame) -> str | None:
        """Returns the most frequent situation that fits, or None.

        Args:
            frame: The table of a trial or of a study.
        """
        text = pl.col("situation")
        fits = text.str.contains(rf"\b{self.role}\b")
        if self.attended is not None:
            fits &= text.str.contains(">", literal=True) == pl.lit(self.attended)
        found = frame.filter(pl.col("chosen") & fits)["situation"].value_counts(
            sort=True
        )
        return None if found.is_empty() else str(found["situation"][0])

"""Tables for the report: plain text cells, some of them shaded by a value."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class Cell:
    """A cell of a table."""

    text: str
    """What stands in it."""

    shade: float | None = None
    """How strongly it is shaded, 0 to 1; None: not at all."""

    marked: bool = False
    """Whether it has a frame around it."""


@dataclass(frozen=True, kw_only=True)
class Table:
    """A table with a heading for each column and each row."""

    name: str
    """Its anchor in the page."""

    title: str
    """What it shows, a few words."""

    header: tuple[str, ...]
    """Of each column, the row headings' first."""

    rows: tuple[tuple[str, tuple[Cell, ...]], ...]
    """Heading and cells of each row."""

    note: str
    """How to read it."""

"""What the generated pages share: writing one, tables of others, scores from them."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from markdown_it import MarkdownIt

from experiments.errors import ExperimentError

if TYPE_CHECKING:
    from household.home.floorplan import Room

Row = Mapping[str, str]
"""A row of a table: heading -> cell."""


def write(path: Path, text: str) -> None:
    """Writes a page, in a folder that may not be there yet."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, "utf-8")


def table_under(page: Path, heading: str) -> Sequence[Row]:
    """Reads the first table below a heading of a page.

    Raises:
        ExperimentError: If there is none.
    """
    parts = re.split(r"^#+ (.+)\n", page.read_text("utf-8"), flags=re.MULTILINE)
    sections = dict(zip(parts[1::2], parts[2::2], strict=True))
    rows = _rows(sections.get(heading, ""))
    if len(rows) < 2:
        raise ExperimentError(f"{page.name}: no table under {heading!r}.")
    return [dict(zip(rows[0], row, strict=True)) for row in rows[1:]]


def _rows(text: str) -> list[list[str]]:
    """The cells of all tables in a text, as they are written."""
    rows: list[list[str]] = []
    tokens = MarkdownIt("commonmark").enable("table").parse(text)
    for index, token in enumerate(tokens):
        if token.type == "tr_open":
            rows.append([])
        elif token.type in ("th_open", "td_open"):
            rows[-1].append(tokens[index + 1].content)
    return rows


def area(room: Room) -> float:
    """Returns the area of a room [m2], by Gauss's formula."""
    corners = room.corners
    following = (*corners[1:], corners[0])
    crossed = (x * v - u * y for (x, y), (u, v) in zip(corners, following, strict=True))
    return abs(sum(crossed)) / 2


def words(name: str) -> str:
    """Returns a name of the code as a title: `quiet_work` is "Quiet work"."""
    return name.replace("_", " ").capitalize()

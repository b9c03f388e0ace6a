"""Homes from drawings in text, such as can be made in any editor.

A character is a cell of 0.25 m x 0.5 m, so that a drawing looks like the home::

    +---------------+---------+
    |       r       |      BBB|
    |               :   <s BBB|
    |     TTTT      |         |
    |   w>TTTT      :         |
    +----====-------+---------+

| character | what |
| --- | --- |
| `+`, `-`, vertical bar | walls, from the middle of one character to that of the next |
| `:` | an open door in a wall |
| `=` | a door that stays closed, such as the front door |
| `w`, `r`, `s`, `p`, `e`, `c` | where people are working, reading, sleeping, playing, |
|  | entering, calling |
| `<`, `>`, `^`, `v` | beside one of these: where people look there; else up |
| capital letters | furniture: a box of one letter is one piece |
"""

from collections.abc import Collection, Iterator, Mapping
from typing import NamedTuple, get_args

from household.config.toml import Point
from household.errors import HouseholdError, shown
from household.home.check import checked
from household.home.floorplan import (
    Door,
    FloorPlan,
    Furniture,
    Region,
    RegionActivity,
    Wall,
)

ACROSS, DOWN = 0.25, 0.5
"""Size of a cell [m]: characters are about twice as high as they are wide."""

OPEN, CLOSED = ":", "="
DOORS = OPEN + CLOSED
ROW, COLUMN = "+-" + DOORS, "+|" + DOORS
"""What walls from left to right are drawn with, and from top to bottom."""

LOOKS = {">": (1, 0), "<": (-1, 0), "^": (0, -1), "v": (0, 1)}
"""Arrow -> the step from a place to it, in columns and rows."""

SEEN = 0.85
"""How far from the middle of a place lies what people look at there [m]."""

ACTIVITIES: dict[str, RegionActivity] = {
    name[0]: name for name in get_args(RegionActivity)
}
ALLOWED = " +-|" + DOORS + "".join(LOOKS) + "".join(ACTIVITIES)


class Sheet(NamedTuple):
    """A drawing as a grid of characters.

    Attributes:
        lines: From top to bottom, all of one length.
    """

    lines: tuple[str, ...]

    def at(self, column: int, row: int) -> str:
        """The character of a cell; blank outside."""
        inside = 0 <= row < len(self.lines) and 0 <= column < len(self.lines[row])
        return self.lines[row][column] if inside else " "

    def point(self, column: float, row: float) -> Point:
        """The middle of a cell [m]; the lowest line of the drawing lies at y = 0."""
        return column * ACROSS, (len(self.lines) - 1 - row) * DOWN

    def cells(self) -> Iterator[tuple[int, int, str]]:
        """Column, row and character of all cells that are not blank."""
        for row, line in enumerate(self.lines):
            for column, character in enumerate(line):
                if character != " ":
                    yield column, row, character


def from_drawing(
    drawing: str,
    name: str = "drawn",
    furniture: Mapping[str, str] | None = None,
    tall: Collection[str] = (),
    radius: float = 0.6,
) -> FloorPlan:
    """Makes a home from a drawing in text.

    Places are called by their activity, from the second one on with a number, as in
    "sleeping 2"; pieces of furniture likewise by what their letter stands for.

    Args:
        drawing: As above; indentation does not matter.
        name: What to call the home.
        furniture: Capital letter -> what stands there; else it is called by its letter.
        tall: Letters of furniture that hides what is behind it.
        radius: Of the places [m].

    Returns:
        A home without faults.

    Raises:
        HouseholdError: If a character means nothing, or the home cannot be lived in.
    """
    sheet = _sheet(drawing)
    for column, row, character in sheet.cells():
        if not (character in ALLOWED or (character.isascii() and character.isupper())):
            raise HouseholdError(
                f"drawing, line {row + 1}, character {column + 1}: {shown(character)}; "
                f"allowed: capital letters and any of {ALLOWED}"
            )
    strokes = list(_strokes(sheet))
    plan = FloorPlan(
        name=name,
        walls=tuple(Wall(start=a, end=b) for a, b, kind in strokes if not kind),
        doors=tuple(
            Door(start=a, end=b, open=kind == OPEN) for a, b, kind in strokes if kind
        ),
        furniture=_furniture(sheet, furniture or {}, tall),
        regions=_regions(sheet, radius),
    )
    return checked(plan, name)


def _sheet(drawing: str) -> Sheet:
    """The drawing without what surrounds it."""
    lines = [line.rstrip() for line in drawing.expandtabs().splitlines()]
    drawn = [line for line in lines if line]
    if not drawn:
        raise HouseholdError("drawing: there is nothing in it")
    margin = min(len(line) - len(line.lstrip()) for line in drawn)
    width = max(map(len, drawn))
    first = next(i for i, line in enumerate(lines) if line)
    last = max(i for i, line in enumerate(lines) if line)
    return Sheet(tuple(line.ljust(width)[margin:] for line in lines[first : last + 1]))


def _strokes(sheet: Sheet) -> Iterator[tuple[Point, Point, str]]:
    """Walls and doors: both ends, and for a door its character."""
    width, height = len(sheet.lines[0]), len(sheet.lines)
    for row, line in enumerate(sheet.lines):
        for start, end, kind in _parts(line, ROW):
            yield sheet.point(start, row), sheet.point(end, row), kind
    for column in range(width):
        line = "".join(sheet.at(column, row) for row in range(height))
        for start, end, kind in _parts(line, COLUMN):
            yield sheet.point(column, start), sheet.point(column, end), kind


def _parts(line: str, drawn_with: str) -> Iterator[tuple[float, float, str]]:
    """The straight parts of a line of characters: where they begin and end, and what.

    Doors take up whole characters; walls go to the middle of their last one.
    """
    i = 0
    while i < len(line):
        end = i
        while end < len(line) and line[end] in drawn_with:
            end += 1
        # A character alone belongs to a wall in the other direction.
        if end > i + 1:
            yield from _doors_and_walls(line, i, end - 1)
        i = max(end, i + 1)


def _doors_and_walls(
    line: str, first: int, last: int
) -> Iterator[tuple[float, float, str]]:
    begun, kind = float(first), line[first] if line[first] in DOORS else ""
    for i in range(first + 1, last + 1):
        here = line[i] if line[i] in DOORS else ""
        if here != kind:
            edge = i - 0.5
            yield begun, edge, kind
            begun, kind = edge, here
    yield begun, float(last), kind


def _regions(sheet: Sheet, radius: float) -> tuple[Region, ...]:
    """The places where people do something."""
    taken: dict[str, int] = {}
    regions = []
    for column, row, character in sheet.cells():
        if character not in ACTIVITIES:
            continue
        activity = ACTIVITIES[character]
        x, y = sheet.point(column, row)
        across, down = _look(sheet, column, row)
        regions.append(
            Region(
                name=_numbered(activity, taken),
                activity=activity,
                center=(x, y),
                radius=radius,
                facing=(x + SEEN * across, y - SEEN * down),
            )
        )
    return tuple(regions)


def _look(sheet: Sheet, column: int, row: int) -> tuple[int, int]:
    """The step to where people look in a place: to the arrow beside it, else up."""
    for arrow, (across, down) in LOOKS.items():
        if sheet.at(column + across, row + down) == arrow:
            return across, down
    return LOOKS["^"]


def _furniture(
    sheet: Sheet, names: Mapping[str, str], tall: Collection[str]
) -> tuple[Furniture, ...]:
    """Boxes of one letter, from top left to bottom right."""
    taken: dict[str, int] = {}
    done: set[tuple[int, int]] = set()
    pieces = []
    for column, row, letter in sheet.cells():
        if not letter.isupper() or (column, row) in done:
            continue
        right, bottom = column, row
        while sheet.at(right + 1, row) == letter:
            right += 1
        while sheet.at(column, bottom + 1) == letter:
            bottom += 1
        box = {(c, r) for c in range(column, right + 1) for r in range(row, bottom + 1)}
        if any(sheet.at(c, r) != letter for c, r in box):
            raise HouseholdError(
                f"drawing, line {row + 1}, character {column + 1}: {letter} is no "
                "rectangle; allowed: boxes of one letter, with space in between"
            )
        done |= box
        x, y = sheet.point((column + right) / 2, (row + bottom) / 2)
        pieces.append(
            Furniture(
                name=_numbered(names.get(letter, letter), taken),
                center=(x, y),
                size=((right - column + 1) * ACROSS, (bottom - row + 1) * DOWN),
                tall=letter in tall,
            )
        )
    return tuple(pieces)


def _numbered(name: str, taken: dict[str, int]) -> str:
    """A name of its own, which counts as taken from now on."""
    taken[name] = taken.get(name, 0) + 1
    return name if taken[name] == 1 else f"{name} {taken[name]}"

"""Sheets: names and axes of drawings, and the legend, as pictures written once.

The viewer's own labels cover each other when there are many, and take the viewer's
colors; these do not.
"""

from functools import lru_cache
from typing import Any

from household.replay.stream import Stream
from household.scenario.scenario import Scenario
from household.view.colors import behavior_colors, people_colors, robot_colors
from household.view.floorplan_svg import BORDER, size_of
from household.view.lettering import Sheet, Text, write

LANE = 1.6
"""Height of a robot's lane in the picture of credit."""

WINDOW = 40
"""How far back the picture of credit reaches [s]."""


def second(scenario: Scenario) -> float:
    """Width of a second in the picture of credit, which is 3 times wider than high.

    Args:
        scenario: The household.
    """
    return 0.1 * len(scenario.robots)


def names_of(scenario: Scenario) -> tuple[str, ...]:
    """Everybody, people first and robots after them."""
    return scenario.person_names + scenario.robot_names


def colors_of(scenario: Scenario) -> list[str]:
    """The color of everybody, people first and robots after them."""
    people = people_colors(len(scenario.people))
    return people + robot_colors(len(scenario.robots))


def margin(scenario: Scenario) -> float:
    """Room for names beside and above the attention matrix [cells]."""
    longest = max(map(len, names_of(scenario)))
    return 0.9 + 0.42 * letter(scenario) / 0.6 * longest


def letter(scenario: Scenario) -> float:
    """Height of letters at the attention matrix [cells]."""
    return min(0.62, 0.045 * len(names_of(scenario)) + 0.12)


def send_sheets(stream: Stream, scenario: Scenario) -> None:
    """Writes the names at the attention matrix, the axes of credit, and the legend."""
    _send(stream, "attention/rows", *_rows(scenario))
    _send(stream, "attention/columns", *_columns(scenario))
    _send(stream, "credit/names", *_lanes(scenario))
    _send(stream, "credit/axis", *_axis(scenario))
    _send(stream, "legend", *legend(scenario), beside_home=True)


def _send(
    stream: Stream,
    entity: str,
    texts: tuple[Text, ...],
    sheet: Sheet,
    *,
    beside_home: bool = False,
) -> None:
    stream.send_static(entity, *_picture(texts, sheet, beside_home))


@lru_cache(maxsize=32)
def _picture(
    texts: tuple[Text, ...], sheet: Sheet, beside_home: bool
) -> tuple[Any, Any]:
    """A written sheet and where it is, made once for all episodes of a household."""
    import rerun as rr

    scale = 1400 / max(sheet.width, sheet.height) if beside_home else 36 / sheet.letter
    raster = write(texts, sheet, scale)
    place = rr.Transform3D(
        translation=[raster.left, raster.top, 0.0], scale=1 / raster.scale
    )
    return place, rr.Image(raster.pixels, draw_order=-5.0).compress(jpeg_quality=90)


def _rows(scenario: Scenario) -> tuple[tuple[Text, ...], Sheet]:
    n, high, wide = len(names_of(scenario)), letter(scenario), margin(scenario)
    pairs = zip(names_of(scenario), colors_of(scenario), strict=True)
    texts = tuple(
        Text(-wide + 0.1, i + 0.5, name, color=color)
        for i, (name, color) in enumerate(pairs)
    )
    return texts, Sheet(-wide, 0.0, wide - 0.05, n, high)


def _columns(scenario: Scenario) -> tuple[tuple[Text, ...], Sheet]:
    n, high, tall = len(names_of(scenario)), letter(scenario), margin(scenario)
    texts = tuple(
        Text(i + 0.5, -0.25, name, turned=True)
        for i, name in enumerate(names_of(scenario))
    )
    return texts, Sheet(0.0, -tall, n, tall - 0.05, high)


def _lanes(scenario: Scenario) -> tuple[tuple[Text, ...], Sheet]:
    n, unit = len(scenario.robots), second(scenario)
    left = -(WINDOW + 9.5) * unit
    pairs = zip(scenario.robot_names, robot_colors(n), strict=True)
    texts = tuple(
        Text(left, i * LANE, name, color=color) for i, (name, color) in enumerate(pairs)
    )
    top = -0.5 * LANE
    return texts, Sheet(left, top, 9.0 * unit, n * LANE, 1.25 * unit)


def _axis(scenario: Scenario) -> tuple[tuple[Text, ...], Sheet]:
    n, unit = len(scenario.robots), second(scenario)
    y = (n - 0.4) * LANE
    seconds = range(0, WINDOW + 1, 10)
    texts = tuple(
        Text(-s * unit, y, f"-{s} s" if s else "now", align="center") for s in seconds
    )
    size = 1.4 * unit
    return texts, Sheet(
        -(WINDOW + 4) * unit, y - size, (WINDOW + 6) * unit, 2 * size, size
    )


def legend(scenario: Scenario) -> tuple[tuple[Text, ...], Sheet]:
    """What the colors of robots' rings and of lanes mean, below the plan.

    Args:
        scenario: The household.

    Returns:
        The texts and the paper, in meters, y down.
    """
    width, height = size_of(scenario.plan)
    left = float(scenario.plan.lower[0]) - BORDER
    top = float(height) - float(scenario.plan.upper[1]) - BORDER
    row = float(width) / 34
    texts, x, y = [], left + row, top + 0.8 * row
    names = scenario.behaviors
    for name, color in zip(names, behavior_colors(names), strict=True):
        room = (0.58 * len(name) + 2.4) * row
        if x + room > left + float(width):
            x, y = left + row, y + 1.4 * row
        texts.append(Text(x, y, name, color=color))
        x += room
    return tuple(texts), Sheet(left, top, float(width), y + 0.9 * row - top, 0.85 * row)


def legend_height(scenario: Scenario) -> float:
    """Height of the legend [m]."""
    return legend(scenario)[1].height

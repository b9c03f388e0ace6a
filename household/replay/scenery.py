"""Scenery: all that is static in a recording, written once at its beginning."""

from functools import lru_cache
from typing import Any

import numpy as np

from household.activity import ACTIVITY_NAMES
from household.home.floorplan import FloorPlan
from household.replay.stream import Stream
from household.scenario.scenario import Scenario
from household.simulation.simulation import PERSON_RADIUS, ROBOT_RADIUS
from household.view.colors import (
    ACTIVITIES,
    BELIEVED,
    TRUE,
    behavior_color,
    packed,
)
from household.view.raster import rasterize

PICTURE_SCALE = 100.0
"""Pixels per meter of the floor plan's picture."""

LANE = 1.6
"""Height of a robot's lane in the picture of credit."""

MOST_ROWS, MOST_COLUMNS = 16, 8
"""With more rows or columns, the names at the attention matrix would overlap."""

WHITE = (255, 255, 255)
GRAY = (235, 235, 235)

WINDOW = 40
"""How far back the picture of credit reaches [s]."""

ROBOT_LINES = ("#e66100", "#5d3a9b", "#1a85ff", "#4b8b3b", "#d41159", "#996633")
"""Colors of robots in plots, repeated if there are more robots."""


def second(scenario: Scenario) -> float:
    """Width of a second in the picture of credit, which is 3 times wider than high.

    Args:
        scenario: The household.
    """
    return 0.1 * len(scenario.robots)


def names_of(scenario: Scenario) -> tuple[str, ...]:
    """Everybody, people first and robots after them."""
    return scenario.person_names + scenario.robot_names


def lanes_of(scenario: Scenario) -> tuple[str, ...]:
    """The entities of what everybody does, people first and robots after them.

    The viewer sorts them by name, which puts robots on top.
    """
    people = tuple(f"doing/{name}" for name in scenario.person_names)
    return people + tuple(f"behavior/{name}" for name in scenario.robot_names)


def send_scenery(stream: Stream, scenario: Scenario, learns: bool) -> None:
    """Writes everything that is static.

    Args:
        stream: Where to.
        scenario: The household.
        learns: Whether learners will report what they believe.
    """
    _home(stream, scenario)
    _bodies(stream)
    _series(stream, scenario, learns)
    _lanes(stream, scenario)
    _attention(stream, scenario)
    _credit(stream, scenario, learns)


def _home(stream: Stream, scenario: Scenario) -> None:
    import rerun as rr

    # The world's y points up, the viewer's down.
    up = [[1, 0, 0], [0, -1, 0], [0, 0, 1]]
    stream.send_static("world", rr.Transform3D(mat3x3=up))
    stream.send_static("plan", *_picture(scenario.plan))


@lru_cache(maxsize=8)
def _picture(plan: FloorPlan) -> tuple[Any, Any]:
    """A home's picture and where it is, drawn once for all episodes."""
    import rerun as rr

    raster = rasterize(plan, PICTURE_SCALE)
    corner = [raster.left, -raster.top, 0.0]
    place = rr.Transform3D(translation=corner, scale=1 / raster.scale)
    image = rr.Image(raster.pixels, draw_order=-10.0)
    return place, image.compress(jpeg_quality=92)


def _bodies(stream: Stream) -> None:
    import rerun as rr

    names = rr.Points2D.from_fields(
        radii=0.0, colors=[WHITE], show_labels=True, draw_order=70.0
    )
    groups = (("people", PERSON_RADIUS, 30.0), ("robots", ROBOT_RADIUS, 40.0))
    for group, radius, order in groups:
        body = rr.Points2D.from_fields(radii=radius, draw_order=order)
        arrow = rr.Arrows2D.from_fields(
            radii=0.025, colors=[(20, 20, 20)], draw_order=order + 1
        )
        stream.send_static(f"world/{group}", body, arrow)
        stream.send_static(f"world/{group}/names", names)
    gaze = rr.LineStrips2D.from_fields(radii=0.012, draw_order=20.0)
    stream.send_static("world/people/gaze", gaze)
    touches = rr.Points2D.from_fields(radii=0.09, draw_order=60.0)
    stream.send_static("world/touches", touches)
    stream.send_static("world/touches/texts", names)
    for entity, color, radius in (("true", TRUE, 0.05), ("believed", BELIEVED, 0.02)):
        line = rr.LineStrips2D.from_fields(
            radii=radius, colors=packed([color]), draw_order=55.0 - 100 * radius
        )
        stream.send_static(f"world/{entity}", line)


def _series(stream: Stream, scenario: Scenario, learns: bool) -> None:
    import rerun as rr

    robots = list(scenario.robot_names)
    lines = packed([ROBOT_LINES[i % len(ROBOT_LINES)] for i in range(len(robots))])
    stream.send_static(
        "reward/sum", rr.SeriesLines(names=robots, colors=lines, widths=2)
    )
    stream.send_static(
        "reward/now",
        rr.SeriesPoints(
            names=[f"{r}: touch" for r in robots], colors=lines, marker_sizes=3
        ),
    )
    stream.send_static(
        "mood", rr.SeriesLines(names=list(scenario.person_names), widths=2)
    )
    behaviors = list(scenario.behaviors)
    colors = packed([behavior_color(i) for i in range(len(behaviors))])
    for robot in robots if learns else ():
        style = rr.SeriesLines(
            names=behaviors, colors=colors, widths=2, interpolation_mode="StepAfter"
        )
        stream.send_static(f"q/{robot}", style)


def _lanes(stream: Stream, scenario: Scenario) -> None:
    import rerun as rr

    behaviors, activities = list(scenario.behaviors), list(ACTIVITY_NAMES)
    palette = packed([behavior_color(i) for i in range(len(behaviors))])
    for lane in lanes_of(scenario):
        robot = lane.startswith("behavior")
        names = behaviors if robot else activities
        colors = palette if robot else packed(ACTIVITIES)
        style = rr.StateConfiguration(values=names, labels=names, colors=colors)
        stream.send_static(lane, style)


def _attention(stream: Stream, scenario: Scenario) -> None:
    import rerun as rr

    names = names_of(scenario)
    n = len(names)
    cells = rr.components.ImageFormat(n, n, color_model="RGB", channel_datatype="U8")
    stream.send_static("attention", rr.Image.from_fields(format=cells))
    at = np.arange(n) + 0.5
    rows = np.stack([np.full(n, -0.1 * n - 0.3), at], 1)
    columns = np.stack([at, np.full(n, -0.45)], 1)
    label: dict[str, Any] = {"radii": 0.0, "colors": [GRAY], "show_labels": True}
    short = [p[:5] if n <= 5 else p[:2] for p in scenario.person_names]
    short += [f"r{j}" for j in range(len(scenario.robots))]
    if n <= MOST_ROWS:
        stream.send_static(
            "attention/rows", rr.Points2D(rows, labels=list(names), **label)
        )
    if n <= MOST_COLUMNS:
        stream.send_static(
            "attention/columns", rr.Points2D(columns, labels=short, **label)
        )


def _credit(stream: Stream, scenario: Scenario, learns: bool) -> None:
    """The axes of the picture of credit: time to the right, a lane for each robot."""
    import rerun as rr

    n, unit = len(scenario.robots), second(scenario)
    seconds = np.arange(0, WINDOW + 1, 10)
    ticks = np.stack([-seconds * unit, np.full(len(seconds), (n - 0.42) * LANE)], 1)
    label: dict[str, Any] = {"radii": 0.0, "colors": [GRAY], "show_labels": True}
    texts = ["now", *(f"-{s} s" for s in seconds[1:])]
    stream.send_static("credit/axis", rr.Points2D(ticks, labels=texts, **label))
    at = np.stack([np.full(n, -(WINDOW + 4) * unit), np.arange(n) * LANE], 1)
    robots = list(scenario.robot_names)
    stream.send_static("credit/names", rr.Points2D(at, labels=robots, **label))
    lanes = rr.LineStrips2D.from_fields(radii=0.06, draw_order=0.0)
    stream.send_static("credit/past", lanes)
    touches = rr.Points2D.from_fields(radii=0.09, show_labels=True, draw_order=10.0)
    stream.send_static("credit/past/touches", touches)
    true = rr.LineStrips2D.from_fields(radii=0.03, colors=packed([TRUE]), draw_order=3)
    stream.send_static("credit/past/true", true)
    if learns:
        believed = rr.LineStrips2D.from_fields(colors=packed([BELIEVED]), draw_order=4)
        stream.send_static("credit/past/believed", believed)

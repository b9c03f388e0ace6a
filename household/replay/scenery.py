"""Scenery: all that is static in a recording, written once at its beginning."""

from functools import lru_cache
from typing import Any

from household.activity import ACTIVITY_NAMES
from household.home.floorplan import FloorPlan
from household.replay.sheets import colors_of, names_of, send_sheets
from household.replay.stream import Stream
from household.scenario.scenario import Scenario
from household.simulation.simulation import PERSON_RADIUS, ROBOT_RADIUS
from household.view.colors import (
    BELIEVED,
    INK,
    TRUE,
    behavior_colors,
    ink_on,
    packed,
    people_colors,
    robot_colors,
    shades,
)
from household.view.raster import rasterize

PICTURE_SCALE = 100.0
"""Pixels per meter of the floor plan's picture."""


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
    _bodies(stream, scenario)
    _series(stream, scenario, learns)
    _lanes(stream, scenario)
    _attention(stream, scenario)
    _credit(stream, learns)
    send_sheets(stream, scenario)


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


def _bodies(stream: Stream, scenario: Scenario) -> None:
    import rerun as rr

    names = rr.Points2D.from_fields(
        radii=0.0, colors=packed([INK]), show_labels=True, draw_order=70.0
    )
    who = colors_of(scenario)
    n = len(scenario.people)
    # A robot is smaller than the ring around it, which tells what it does.
    groups = (
        ("people", who[:n], PERSON_RADIUS, 30.0),
        ("robots", who[n:], 0.6 * ROBOT_RADIUS, 45.0),
    )
    for group, colors, radius, order in groups:
        body = rr.Points2D.from_fields(
            radii=radius, colors=packed(colors), draw_order=order
        )
        arrow = rr.Arrows2D.from_fields(
            radii=0.025, colors=packed([INK]), draw_order=order + 1
        )
        stream.send_static(f"world/{group}", body, arrow)
        stream.send_static(f"world/{group}/names", names)
    named = rr.Points2D.from_fields(labels=list(scenario.person_names))
    stream.send_static("world/people/names", named)
    ring = rr.Points2D.from_fields(radii=1.25 * ROBOT_RADIUS, draw_order=40.0)
    stream.send_static("world/robots/doing", ring)
    gaze = rr.LineStrips2D.from_fields(
        radii=0.014, colors=packed(who[:n], 190), draw_order=20.0
    )
    stream.send_static("world/people/gaze", gaze)
    signs = rr.LineStrips2D.from_fields(
        radii=0.02, colors=packed([ink_on(c) for c in who[:n]]), draw_order=32.0
    )
    stream.send_static("world/people/signs", signs)
    touches = rr.Points2D.from_fields(radii=0.09, draw_order=60.0)
    stream.send_static("world/touches", touches)
    for entity, color, radius in (("true", TRUE, 0.05), ("believed", BELIEVED, 0.02)):
        line = rr.LineStrips2D.from_fields(
            radii=radius, colors=packed([color]), draw_order=55.0 - 100 * radius
        )
        stream.send_static(f"world/{entity}", line)


def _series(stream: Stream, scenario: Scenario, learns: bool) -> None:
    import rerun as rr

    robots, people = list(scenario.robot_names), list(scenario.person_names)
    lines = packed(robot_colors(len(robots)))
    moods = packed(people_colors(len(people)))
    stream.send_static(
        "reward/sum", rr.SeriesLines(names=robots, colors=lines, widths=2)
    )
    stream.send_static(
        "reward/now",
        rr.SeriesPoints(
            names=[f"{r}: touch" for r in robots], colors=lines, marker_sizes=3
        ),
    )
    stream.send_static("mood", rr.SeriesLines(names=people, colors=moods, widths=2))
    behaviors = list(scenario.behaviors)
    colors = packed(behavior_colors(behaviors))
    for robot in robots if learns else ():
        style = rr.SeriesLines(
            names=behaviors, colors=colors, widths=2, interpolation_mode="StepAfter"
        )
        stream.send_static(f"q/{robot}", style)


def _lanes(stream: Stream, scenario: Scenario) -> None:
    """Robots in the colors of their behaviors, people in tints of their own."""
    import rerun as rr

    behaviors, activities = list(scenario.behaviors), list(ACTIVITY_NAMES)
    lanes = zip(lanes_of(scenario), colors_of(scenario), strict=True)
    for lane, color in lanes:
        robot = lane.startswith("behavior")
        names = behaviors if robot else activities
        tints = behavior_colors(names) if robot else shades(color, len(names))
        style = rr.StateConfiguration(values=names, labels=names, colors=packed(tints))
        stream.send_static(lane, style)


def _attention(stream: Stream, scenario: Scenario) -> None:
    import rerun as rr

    n = len(names_of(scenario))
    cells = rr.components.ImageFormat(n, n, color_model="RGB", channel_datatype="U8")
    stream.send_static("attention", rr.Image.from_fields(format=cells))


def _credit(stream: Stream, learns: bool) -> None:
    """How lanes, touches and arcs look in the picture of credit."""
    import rerun as rr

    lanes = rr.LineStrips2D.from_fields(radii=0.06, draw_order=0.0)
    stream.send_static("credit/past", lanes)
    touches = rr.Points2D.from_fields(radii=0.09, show_labels=True, draw_order=10.0)
    stream.send_static("credit/past/touches", touches)
    true = rr.LineStrips2D.from_fields(radii=0.03, colors=packed([TRUE]), draw_order=3)
    stream.send_static("credit/past/true", true)
    if learns:
        believed = rr.LineStrips2D.from_fields(colors=packed([BELIEVED]), draw_order=4)
        stream.send_static("credit/past/believed", believed)

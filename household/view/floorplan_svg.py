"""Pictures of homes: walls, doors, furniture and activity regions, to scale.

Matplotlib is imported where it is used: a simulation draws nothing.
"""

import textwrap
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from household.compiled.arrays import Floats
from household.config.toml import Point
from household.errors import HouseholdError
from household.home.floorplan import Door, FloorPlan, Furniture, Region, Room, Wall
from household.home.geometry import distance_to_box
from household.view.colors import ACTIVITY_COLORS

if TYPE_CHECKING:
    from matplotlib.axes import Axes

WALL, FLOOR, LEAF = "#333333", "#faf7f0", "#9c6b30"
LOW, TALL = "#e6dcc8", "#b09a78"

SCALE = 0.6
"""Inches of paper per meter of home."""

LETTER, LINE = 0.07, 0.14
"""Width of a small letter and height of a line of text, at that scale [m]."""

BORDER = 0.3
"""Width of the white margin around the walls [m]."""

STRIP = 0.7
"""Height of the white strip below the margin, for the scale bar [m]."""


def size_of(plan: FloorPlan) -> Floats:
    """Width and height of a home's picture, shape (2,) [m]."""
    size: Floats = plan.upper - plan.lower
    return size + np.array([2 * BORDER, 2 * BORDER + STRIP])


def draw(plan: FloorPlan, path: Path | str) -> None:
    """Writes a picture of a home.

    Args:
        plan: The home.
        path: File to write; its ending chooses the format, as in "villa.svg".

    Raises:
        HouseholdError: If the file cannot be written.
    """
    from matplotlib import rc_context
    from matplotlib.figure import Figure

    width, height = size_of(plan)
    # The text of an SVG stays text and its ids stay the same: small files, small diffs.
    with rc_context({"svg.fonttype": "none", "svg.hashsalt": "home"}):
        figure = Figure(figsize=(SCALE * width, SCALE * height), dpi=160)
        draw_on(plan, figure.add_axes((0.0, 0.0, 1.0, 1.0)))
        metadata = (
            dict.fromkeys(("Date", "Creator")) if Path(path).suffix == ".svg" else None
        )
        try:
            figure.savefig(path, metadata=metadata)
        except (OSError, ValueError) as error:
            raise HouseholdError(f"{path}: {error}") from None


def draw_on(plan: FloorPlan, axes: "Axes") -> None:
    """Draws a home on axes of the caller's own, one unit per meter.

    Args:
        plan: The home.
        axes: Matplotlib axes; their limits and aspect are set, their frame is removed.
    """
    for room in plan.rooms:
        _draw_room(room, plan, axes)
    for box in plan.furniture:
        _draw_furniture(box, axes)
    for region in plan.regions:
        _draw_region(region, axes)
    for door in plan.doors:
        _draw_door(door, plan.wall_thickness, axes)
    for wall in plan.walls:
        _draw_wall(wall, plan.wall_thickness, axes)
    _draw_scale(plan, axes)
    (left, bottom), (right, top) = plan.lower - BORDER, plan.upper + BORDER
    axes.set(xlim=(left, right), ylim=(bottom - STRIP, top), aspect="equal")
    axes.set_axis_off()


def _draw_room(room: Room, plan: FloorPlan, axes: "Axes") -> None:
    """Floor and name."""
    axes.fill(*zip(*room.corners, strict=True), color=FLOOR, zorder=0, linewidth=0)
    x, y = _place_for_name(room, plan)
    text: dict[str, Any] = {"fontsize": 5.5, "color": "#8a8272", "va": "top"}
    axes.text(x, y, room.name.upper(), zorder=5, **text)


def _place_for_name(room: Room, plan: FloorPlan) -> Point:
    """The upper left corner of a room's name: high, left, and on blank floor."""
    from matplotlib.path import Path as Outline

    outline = Outline(room.corners)
    (left, low), (right, high) = np.min(room.corners, 0), np.max(room.corners, 0)
    size = np.array([LETTER * 1.25 * len(room.name), -LINE])
    for y in np.arange(high - 0.12, low, -0.1):
        for x in np.arange(left + 0.12, right, 0.1):
            # Close enough to miss nothing that is drawn.
            across = np.linspace(0.0, 1.0, 12)
            points = np.array([(x, y) + size * (i, j) for i in across for j in (0, 1)])
            if outline.contains_points(points).all() and _is_blank(points, plan):
                return float(x), float(y)
    return float(left) + 0.12, float(high) - 0.12


def _is_blank(points: Floats, plan: FloorPlan) -> bool:
    """Whether no furniture or region is drawn at any of the points, shape (n, 2)."""
    boxes = plan.furniture
    gaps = [distance_to_box(points, b.center, b.size, b.angle).min() for b in boxes]
    circles = plan.region_circles
    away = np.hypot(*(points[:, None] - circles[:, :2]).transpose(2, 0, 1))
    return min(gaps, default=1.0) > 0.05 and bool((away > circles[:, 2]).all())


def _draw_furniture(box: Furniture, axes: "Axes") -> None:
    """A box, dark if tall, with its name inside if there is room for it."""
    from matplotlib.patches import Polygon

    color = TALL if box.tall else LOW
    axes.add_patch(Polygon(box.corners, fc=color, ec="#8c7a5c", lw=0.5, zorder=1))
    turn = 90 if box.size[1] > 1.3 * box.size[0] else 0
    along, across = box.size[::-1] if turn else box.size
    name = _wrapped(box.name, along)
    lines = name.split("\n")
    if max(map(len, lines)) * LETTER < along and len(lines) * LINE < across:
        text: dict[str, Any] = {"ha": "center", "va": "center", "zorder": 5}
        text |= {"fontsize": 4.5, "color": "#5f5138", "rotation": box.angle + turn}
        axes.text(*box.center, name, **text)


def _wrapped(name: str, width: float) -> str:
    """A name, broken into as many lines as a width demands [m]."""
    return textwrap.fill(name, max(int(width / LETTER), 1), break_long_words=False)


def _draw_region(region: Region, axes: "Axes") -> None:
    """A circle in its activity's color, its names, and a tick that shows the facing."""
    from matplotlib.patches import Circle

    color = ACTIVITY_COLORS[region.role]
    for alpha, fill in ((0.16, True), (0.9, False)):
        circle = Circle(region.center, region.radius, alpha=alpha, zorder=2)
        circle.set(facecolor=color if fill else "none", edgecolor=color, lw=0.9)
        axes.add_patch(circle)
    center, look = np.array(region.center), np.array(region.facing)
    ahead = (look - center) / np.hypot(*(look - center)) * region.radius
    tick = np.array([center + 0.8 * ahead, center + 1.1 * ahead])
    axes.plot(*tick.T, color=color, lw=1.6, zorder=3, solid_capstyle="butt")
    x, y = region.center
    text: dict[str, Any] = {"ha": "center", "color": color, "zorder": 6}
    axes.text(x, y + 0.02, region.activity, va="bottom", fontsize=6.0, **text)
    if region.name != region.activity:
        name = _wrapped(region.name, 1.9 * region.radius)
        axes.text(x, y - 0.04, name, va="top", fontsize=4.8, **text)


def _draw_door(door: Door, thickness: float, axes: "Axes") -> None:
    """A leaf across the gap if it is shut, a dotted sill if it is open."""
    (x, y), style = zip(door.start, door.end, strict=True), (0, (1, 1.6))
    if door.open:
        axes.plot(x, y, color=LEAF, lw=0.8, ls=style, zorder=3)
    else:
        _draw_bar(door.start, door.end, thickness * 0.6, LEAF, axes)


def _draw_wall(wall: Wall, thickness: float, axes: "Axes") -> None:
    _draw_bar(wall.start, wall.end, thickness, WALL, axes)


def _draw_bar(
    start: Point, end: Point, thickness: float, color: str, axes: "Axes"
) -> None:
    """A line of true thickness [m], longer by half of that at both ends."""
    a, b = np.array(start), np.array(end)
    along = (b - a) / np.hypot(*(b - a)) * thickness / 2
    across = np.array([-along[1], along[0]])
    a, b = a - along, b + along
    corners = np.array([a - across, b - across, b + across, a + across])
    axes.fill(*corners.T, color=color, linewidth=0, zorder=4)


def _draw_scale(plan: FloorPlan, axes: "Axes") -> None:
    """A bar of 1 m or 2 m below the home, with its name beside it."""
    left, bottom = plan.lower
    length = 2 if plan.upper[0] - left > 6 else 1
    y = bottom - BORDER - 0.25
    x = (left, left, left, left + length, left + length, left + length)
    ticks = (y - 0.06, y + 0.06, y, y, y + 0.06, y - 0.06)
    axes.plot(x, ticks, color=WALL, lw=1.0)
    label = f"{length} m     {plan.name.replace('_', ' ')}"
    axes.text(left + length + 0.15, y, label, fontsize=7, color=WALL, va="center")

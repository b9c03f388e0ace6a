"""Figures: a moment of a household as a paper would print it, with a legend.

Drawn with Matplotlib, in lines (SVG, PDF) or pixels (PNG). Only snapshots are drawn, so
that a replay gives the figure that its episode would have given.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from household.activity import Activity
from household.errors import HouseholdError
from household.simulation.simulation import PERSON_RADIUS, ROBOT_RADIUS
from household.view.colors import (
    CARESS,
    IDLE,
    INK,
    TAP,
    behavior_colors,
    ink_on,
    people_colors,
    robot_colors,
)
from household.view.cone import gaze_cones
from household.view.floorplan_svg import BORDER, SCALE, draw_on, size_of
from household.view.labels import place_labels
from household.view.signs import SIGNS

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from household.compiled.arrays import Floats
    from household.scenario.scenario import Scenario
    from household.simulation.snapshot import Snapshot, Touch

SIZE = (1280, 720)
"""Width and height, unless asked for otherwise [pixels]."""

LEGEND = 2.0
"""Width of the legend [inches]."""

ENTRY = 0.17
"""Height of a line of the legend [inches]."""

NAME, SMALL = 6.5, 5.5
"""Size of names, and of what is written beside signs [points]."""

POINT = 1 / 72
"""In inches."""

PAPER = "#ffffff"

Felt = tuple["Touch", "Floats", "Floats"]
"""A touch, where its giver stood, and where the robot was [m]."""


class Body(NamedTuple):
    """How somebody is drawn.

    Attributes:
        center: [m].
        radius: [m].
        color: Of its disc.
        inner: Of the square in it; None: no square.
        angle: Where the head of a person, or the body of a robot, points [rad].
    """

    center: Floats
    radius: float
    color: str
    inner: str | None
    angle: float


def save(
    scenario: Scenario,
    moments: Sequence[Snapshot],
    path: Path | str,
    size: tuple[int, int] = SIZE,
) -> None:
    """Writes the figure of a moment.

    Args:
        scenario: The household.
        moments: The moment itself, last; touches of those before it are drawn too.
        path: File to write; its ending, .svg, .pdf or .png, says in which format.
        size: Width and height [pixels]; lines keep the proportions.

    Raises:
        HouseholdError: If the file cannot be written.
    """
    from matplotlib import rc_context
    from matplotlib.figure import Figure

    inches = _inches(scenario, size)
    # The text of an SVG stays text and its ids stay the same: small files, small diffs.
    settings: Any = {
        "svg.fonttype": "none",
        "svg.hashsalt": "moment",
        "pdf.fonttype": 42,
    }
    with rc_context(settings):
        dpi = size[0] / inches[0]
        figure = Figure(figsize=tuple(inches), dpi=dpi, facecolor=PAPER)
        home = size_of(scenario.plan) * SCALE
        left, bottom = (inches - home - [LEGEND, 0.0]) / 2
        box = (left / inches[0], bottom / inches[1], *(home / inches))
        _draw_moment(figure.add_axes(box), scenario, moments)
        right = left + home[0]
        box = (right / inches[0], 0.0, 1.0 - right / inches[0], 1.0)
        _draw_legend(figure.add_axes(box), scenario, moments[-1], inches[1])
        undated = {".svg": ("Date", "Creator"), ".pdf": ("CreationDate", "Producer")}
        left_out = dict.fromkeys(undated.get(Path(path).suffix.lower(), ()))
        try:
            figure.savefig(path, metadata=left_out or None)
        except (OSError, ValueError) as error:
            raise HouseholdError(f"{path}: {error}") from None


def _inches(scenario: Scenario, size: tuple[int, int]) -> Floats:
    """Width and height of the paper: what is drawn fits, in the asked proportions."""
    rows = len(scenario.people) + 2 * len(scenario.robots) + 7
    needed = size_of(scenario.plan) * SCALE + [LEGEND, 0.0]
    width, height = needed[0], max(needed[1], rows * ENTRY)
    wanted = size[0] / size[1]
    return np.array([max(width, height * wanted), max(height, width / wanted)])


def _draw_moment(axes: Axes, scenario: Scenario, moments: Sequence[Snapshot]) -> None:
    snapshot, n = moments[-1], len(scenario.people)
    draw_on(scenario.plan, axes)
    colors = people_colors(n)
    cones = gaze_cones(
        snapshot.position[None, :n],
        snapshot.gaze[None, :n],
        snapshot.half_view[None],
        scenario.plan.opaque_segments,
        scenario.perception.distance,
    )[0]
    for outline, color in zip(cones, colors, strict=True):
        axes.fill(*outline.T, color=color, alpha=0.13, lw=0, zorder=7)
        axes.plot(*outline.T, color=color, alpha=0.6, lw=0.6, zorder=7)
    for body in _bodies(scenario, snapshot):
        _draw_body(axes, body)
    for i in range(n):
        sign = 0.62 * PERSON_RADIUS * SIGNS[snapshot.activity[i]]
        line = (sign + snapshot.position[i]).T
        axes.plot(*line, color=ink_on(colors[i]), lw=1.0, zorder=10)
    for felt in _felt(scenario, moments):
        _draw_touch(axes, felt)
    _draw_names(axes, scenario, snapshot)


def _bodies(scenario: Scenario, snapshot: Snapshot) -> list[Body]:
    n = len(scenario.people)
    people = [
        Body(at, PERSON_RADIUS, color, None, float(angle))
        for at, color, angle in zip(
            snapshot.position[:n], people_colors(n), snapshot.gaze, strict=False
        )
    ]
    robots = [
        Body(at, ROBOT_RADIUS, _doing(scenario, int(behavior))[1], own, float(angle))
        for at, behavior, own, angle in zip(
            snapshot.position[n:],
            snapshot.behavior,
            robot_colors(len(scenario.robots)),
            snapshot.heading[n:],
            strict=True,
        )
    ]
    return people + robots


def _doing(scenario: Scenario, behavior: int) -> tuple[str, str]:
    """Name and color of a behavior; of none before the first choice."""
    if behavior < 0:
        return "-", IDLE
    return scenario.behaviors[behavior], behavior_colors(scenario.behaviors)[behavior]


def _draw_body(axes: Axes, body: Body) -> None:
    """A disc with a nose where its head points; a robot's own color is in it."""
    from matplotlib.patches import Circle, Rectangle

    ahead = body.radius * np.array([np.cos(body.angle), np.sin(body.angle)])
    nose = np.array([body.center + 0.8 * ahead, body.center + 1.5 * ahead])
    axes.plot(*nose.T, color=INK, lw=1.6, zorder=8, solid_capstyle="round")
    disc: dict[str, Any] = {
        "facecolor": body.color,
        "edgecolor": INK,
        "lw": 0.6,
        "zorder": 9,
    }
    axes.add_patch(Circle(tuple(body.center), body.radius, **disc))
    if body.inner is not None:
        side = 0.8 * body.radius
        corner = tuple(body.center - side / 2)
        square = disc | {"facecolor": body.inner, "zorder": 10}
        axes.add_patch(Rectangle(corner, side, side, **square))


def _felt(scenario: Scenario, moments: Sequence[Snapshot]) -> list[Felt]:
    """The latest touch of each robot, with where giver and robot were."""
    people, robots = scenario.person_names, scenario.robot_names
    latest: dict[str, Felt] = {}
    for snapshot in moments:
        for touch in snapshot.touches:
            giver = people.index(touch.feedback.giver)
            robot = len(people) + robots.index(touch.robot)
            places = snapshot.position[giver], snapshot.position[robot]
            latest[touch.robot] = (touch, *places)
    return list(latest.values())


def _draw_touch(axes: Axes, felt: Felt) -> None:
    """A line from the giver, a ring around the robot, and what it was."""
    from matplotlib.patches import Circle

    touch, giver, robot = felt
    color = CARESS if touch.feedback.kind == "caress" else TAP
    axes.plot(*np.array([giver, robot]).T, color=color, lw=1.4, zorder=8)
    ring = Circle(tuple(robot), 1.6 * ROBOT_RADIUS, fill=False, ec=color, lw=1.8)
    ring.set_zorder(11)
    axes.add_patch(ring)
    text: dict[str, Any] = {"ha": "center", "va": "bottom", "zorder": 12}
    box = {"boxstyle": "round,pad=0.15", "fc": PAPER, "ec": color, "lw": 0.5}
    axes.text(
        robot[0],
        robot[1] + 1.8 * ROBOT_RADIUS,
        touch.feedback.kind,
        **text,
        fontsize=NAME,
        color=color,
        bbox=box,
    )


def _draw_names(axes: Axes, scenario: Scenario, snapshot: Snapshot) -> None:
    """Names where they cover least, on a light background."""
    names = [*scenario.person_names, *scenario.robot_names]
    n = len(scenario.people)
    radius = np.array(
        [PERSON_RADIUS if i < n else ROBOT_RADIUS for i in range(len(names))]
    )
    size = np.array([name_size(name) for name in names])
    plan = scenario.plan
    bounds = np.concatenate([plan.lower - BORDER, plan.upper + BORDER])
    centers = place_labels(snapshot.position[None], radius, size[None], bounds)[0]
    box = {"boxstyle": "round,pad=0.12", "fc": PAPER, "ec": "none", "alpha": 0.8}
    text: dict[str, Any] = {"ha": "center", "va": "center_baseline", "zorder": 12}
    for name, (x, y) in zip(names, centers, strict=True):
        axes.text(x, y, name, fontsize=NAME, color=INK, bbox=box, **text)


def name_size(name: str) -> tuple[float, float]:
    """Width and height of a name with its background [m]."""
    from matplotlib.textpath import TextPath

    meters = POINT / SCALE
    width = TextPath((0, 0), name, size=NAME).get_extents().width
    return (width + 0.3 * NAME) * meters, 1.35 * NAME * meters


def _draw_legend(
    axes: Axes, scenario: Scenario, snapshot: Snapshot, height: float
) -> None:
    """Who is who and does what, what marks mean, and when it is."""
    axes.set(xlim=(0.0, LEGEND), ylim=(-height, 0.0), aspect="equal", anchor="NW")
    axes.set_axis_off()
    y = -0.3
    line: dict[str, Any] = {"va": "center", "color": INK}
    title = scenario.name.replace("_", " ")
    axes.text(0.1, y, f"{title}, {snapshot.time:.0f} s", fontsize=NAME + 1.5, **line)
    y -= 1.6 * ENTRY
    column = _column(scenario)
    for i, name in enumerate(scenario.person_names):
        _entry(axes, (column, y), name, role_in_words(int(snapshot.activity[i])))
        _swatch(axes, y, people_colors(i + 1)[i], int(snapshot.activity[i]))
        y -= ENTRY
    y -= 0.5 * ENTRY
    for j, name in enumerate(scenario.robot_names):
        word, color = _doing(scenario, int(snapshot.behavior[j]))
        _entry(axes, (column, y), name, word)
        center = np.array([0.17, y])
        own = robot_colors(j + 1)[j]
        _draw_body(axes, Body(center, 0.055, color, own, 0.0))
        y -= ENTRY
    y -= 0.5 * ENTRY
    for word, color in (("caress", CARESS), ("tap", TAP)):
        axes.plot([0.11, 0.23], [y, y], color=color, lw=1.8)
        axes.text(0.32, y, word, fontsize=NAME, **line)
        y -= ENTRY
    axes.fill([0.12, 0.23, 0.23], [y, y + 0.05, y - 0.05], color=INK, alpha=0.2)
    axes.text(0.32, y, "field of view", fontsize=NAME, **line)


def role_in_words(activity: int) -> str:
    """What somebody does; a dash for those on their way."""
    return "-" if activity == Activity.UNKNOWN else Activity(activity).name.lower()


def _column(scenario: Scenario) -> float:
    """Where the legend says what everybody does: to the right of all names [inches]."""
    names = (*scenario.person_names, *scenario.robot_names)
    return max(1.12, *(0.32 + SCALE * name_size(name)[0] for name in names))


def _entry(axes: Axes, at: tuple[float, float], name: str, doing: str) -> None:
    x, y = at
    axes.text(0.32, y, name, fontsize=NAME, va="center", color=INK)
    axes.text(x, y, doing, fontsize=SMALL, va="center", color="#5b6470")


def _swatch(axes: Axes, y: float, color: str, activity: int) -> None:
    """A person's disc with the sign of what it does."""
    from matplotlib.patches import Circle

    center = np.array([0.17, y])
    axes.add_patch(Circle(tuple(center), 0.07, fc=color, ec=INK, lw=0.5))
    sign = center + 0.045 * SIGNS[activity]
    axes.plot(*sign.T, color=ink_on(color), lw=0.7, zorder=3)

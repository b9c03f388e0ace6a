"""Names in the plan: where they cover neither each other nor anybody."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from household.compiled.arrays import Floats, Integers
from household.replay.columns import strips, texts, vectors
from household.replay.rows import changes
from household.replay.sheets import legend_height
from household.replay.stream import Stream
from household.scenario.scenario import Scenario
from household.simulation.moment import Moments
from household.simulation.simulation import PERSON_RADIUS, ROBOT_RADIUS
from household.view.floorplan_svg import BORDER, size_of
from household.view.labels import place_labels

VIEW = np.array([607.0, 395.0])
"""Size of the plan in a viewer of 1280 x 720, for which names are placed [pixels]."""

LETTER, PAD = 6.7, 14.0
"""Width of a letter, and of what is around a name in the viewer [pixels]."""

LINE, SECOND = 24.0, 14.0
"""Height of a name, and of a second line in it [pixels]."""


class Felt(NamedTuple):
    """A touch as a robot's name tells it.

    Attributes:
        begin: First decision at which it is told.
        end: Decision at which it is no longer told.
        robot: Index of the robot.
        text: Who touched, and how.
    """

    begin: int
    end: int
    robot: int
    text: str


def send_names(
    stream: Stream, scenario: Scenario, moments: Moments, felt: Sequence[Felt]
) -> None:
    """Writes where names are; the viewer draws them below these points.

    Args:
        stream: Where to.
        scenario: The household.
        moments: What happened.
        felt: The touches of these moments in the order of time; a later one of the same
            robot takes the place of an earlier one.
    """
    import rerun as rr

    n = len(scenario.people)
    told = _told(moments, felt, len(scenario.robots))
    where = changes(moments.position, told)
    sizes = _sizes(scenario, told[where], felt)
    centers = place_labels(
        moments.position[where], _radii(scenario), sizes, _bounds(scenario)
    )
    times = (moments.decision[where], moments.time[where])
    leaders = _leaders(moments.position[where], centers, sizes)
    lines = strips(rr.LineStrips2D.descriptor_strips(), leaders)
    stream.send("world/leaders", times, [lines])
    centers[..., 1] += sizes[..., 1] / 2
    points = rr.Points2D.descriptor_positions()
    for group, who in (("people", slice(0, n)), ("robots", slice(n, None))):
        stream.send(f"world/{group}/names", times, [vectors(points, centers[:, who])])
    _send_texts(stream, scenario, moments, told, felt)


def _told(moments: Moments, felt: Sequence[Felt], n_robots: int) -> Integers:
    """Which touch each robot's name tells, shape (n_moments, n_robots); 0 is none."""
    told = np.zeros((len(moments), n_robots), np.int64)
    spans = [each[:2] for each in felt]
    rows = np.searchsorted(moments.decision, spans).tolist()
    for number, ((begin, end), each) in enumerate(zip(rows, felt, strict=True), 1):
        told[begin:end, each.robot] = number
    return told


def _leaders(position: Floats, centers: Floats, sizes: Floats) -> Floats:
    """Lines from bodies to the edges of their names, (n_moments, n, 2, 2) [m].

    What is behind a name shines through it in the viewer.
    """
    toward = position - centers
    with np.errstate(divide="ignore"):
        share = (sizes / 2 / np.abs(toward)).min(axis=-1, keepdims=True)
    return np.stack([position, centers + np.minimum(share, 1.0) * toward], axis=2)


def _send_texts(
    stream: Stream,
    scenario: Scenario,
    moments: Moments,
    told: Integers,
    felt: Sequence[Felt],
) -> None:
    """Writes what robots' names say: what they do, and the touch just felt."""
    import rerun as rr

    where = changes(moments.behavior, told)
    doing = ["-", *scenario.behaviors]  # Before the first choice it is -1.
    robots = np.arange(len(scenario.robots))
    key = (moments.behavior[where] + 1) * (len(felt) + 1) + told[where]
    keys, which = np.unique(key * len(robots) + robots, return_inverse=True)
    labels = []
    for each in keys.tolist():
        rest, robot = divmod(each, len(robots))
        behavior, number = divmod(rest, len(felt) + 1)
        label = f"{scenario.robot_names[robot]}: {doing[behavior]}"
        labels.append(f"{label}\n{felt[number - 1].text}" if number else label)
    column = texts(
        rr.Points2D.descriptor_labels(), labels, which.reshape(len(where), -1)
    )
    times = (moments.decision[where], moments.time[where])
    stream.send("world/robots/names", times, [column])


def _sizes(scenario: Scenario, told: Integers, felt: Sequence[Felt]) -> Floats:
    """Sizes of names, (n_moments, n, 2) [m].

    A robot's is always that of its longest behavior, so that names rarely move.
    """
    room = size_of(scenario.plan) + np.array([0.0, legend_height(scenario)])
    scale = float((VIEW / room).min())
    longest = max(map(len, scenario.behaviors)) + 2
    letters = [len(name) for name in scenario.person_names]
    letters += [len(name) + longest for name in scenario.robot_names]
    n = len(scenario.people)
    sizes = np.empty((len(told), len(letters), 2))
    sizes[:] = np.array([[LETTER * count + PAD, LINE] for count in letters])
    lengths = np.array([len(each.text) for each in felt])
    at, robot = np.nonzero(told)
    second = LETTER * lengths[told[at, robot] - 1] + PAD
    sizes[at, n + robot, 0] = np.maximum(sizes[at, n + robot, 0], second)
    sizes[at, n + robot, 1] += SECOND
    return sizes / scale


def _radii(scenario: Scenario) -> Floats:
    radius = np.full(len(scenario.people) + len(scenario.robots), PERSON_RADIUS)
    radius[len(scenario.people) :] = 1.25 * ROBOT_RADIUS
    return radius


def _bounds(scenario: Scenario) -> Floats:
    """The plan's picture: left, bottom, right and top [m]."""
    left, top = scenario.plan.lower[0] - BORDER, scenario.plan.upper[1] + BORDER
    width, height = size_of(scenario.plan)
    return np.array([left, top - height, left + width, top], np.float64)

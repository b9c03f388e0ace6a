"""Writes what changes from moment to moment, as columns."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from household.activity import ACTIVITY_NAMES
from household.compiled.arrays import Floats, Indices, Mask
from household.compiled.jit import compiled
from household.replay.columns import colors, exact, pictures, strips, texts, vectors
from household.replay.scenery import lanes_of
from household.replay.sheets import LANE, second
from household.replay.stream import Stream
from household.scenario.scenario import Scenario
from household.simulation.moment import FIELDS, Moments
from household.simulation.simulation import PERSON_RADIUS, ROBOT_RADIUS
from household.view.colors import IDLE, behavior_colors, heat, packed
from household.view.cone import gaze_cones
from household.view.floorplan_svg import size_of
from household.view.labels import place_labels
from household.view.signs import SIGNS

if TYPE_CHECKING:
    from rerun import ComponentColumn

ARROW, EDGE = 0.18, 0.2
"""Length of the arrow that shows where a body faces, and where it begins [m]."""

VISIBLE = 0.005
"""By how much a drawn curve may miss a mood, which is in [-1, 1]."""

SIGN = 0.62 * PERSON_RADIUS
"""Size of the sign in a person's body [m]."""

VIEW = np.array([620.0, 400.0])
"""Size of the plan in a viewer of 1280 x 720, for which names are placed [pixels]."""

LETTER, LINE = 7.4, 22.0
"""Width of a letter and height of a name in the viewer [pixels]."""


def changes(*columns: NDArray[np.generic]) -> Indices:
    """Indices of the rows that differ from the row before, and of the first one."""
    changed = np.zeros(len(columns[0]), dtype=np.bool_)
    changed[:1] = True
    for column in columns:
        _mark_changes(column.reshape(len(column), -1), changed)
    return np.flatnonzero(changed)


@compiled
def _mark_changes(values: NDArray[Any], changed: Mask) -> None:
    for row in range(1, len(values)):
        for k in range(values.shape[1]):
            if values[row, k] != values[row - 1, k]:
                changed[row] = True
                break


def bends(values: Floats, tolerance: float) -> Indices:
    """Indices of the rows that suffice to draw time series as straight lines.

    Args:
        values: One row for each moment, shape (n_moments, n).
        tolerance: By how much the lines may miss a value.
    """
    kept = np.zeros(len(values), dtype=np.bool_)
    kept[:1] = kept[-1:] = True
    _mark_bends(values, tolerance, kept)
    return np.flatnonzero(kept)


@compiled
def _mark_bends(values: Floats, tolerance: float, kept: Mask) -> None:
    last = 0
    for row in range(1, len(values)):
        if _differ(values[row], values[last], tolerance):
            # Up to a jump the line stays where it was.
            kept[row - 1] |= _differ(values[row], values[row - 1], tolerance)
            kept[row], last = True, row


@compiled
def _differ(one: Floats, other: Floats, tolerance: float) -> bool:
    """Whether any number differs by more than a tolerance."""
    differ = False
    for k in range(len(one)):
        differ |= abs(one[k] - other[k]) > tolerance
    return differ


def send_moments(
    stream: Stream, scenario: Scenario, moments: Moments, total: Floats
) -> None:
    """Writes what happened.

    Args:
        stream: Where to.
        scenario: The household.
        moments: What happened.
        total: Sum of each robot's rewards before that, shape (n_robots,).
    """
    # The exact state comes first: it can be read where a kill cuts off what is drawn.
    send_state(stream, moments)
    _send_people(stream, scenario, moments)
    _send_robots(stream, scenario, moments)
    _send_names(stream, scenario, moments)
    _send_series(stream, moments, total)
    _send_attention(stream, moments)
    _send_lanes(stream, scenario, moments)
    _send_credit_lanes(stream, scenario, moments)


def send_state(stream: Stream, moments: Moments) -> None:
    """Writes the exact numbers of moments, which are read back."""
    state = [exact(name, getattr(moments, name)) for name in FIELDS]
    stream.send("state", (moments.decision, moments.time), state)


def _send_people(stream: Stream, scenario: Scenario, moments: Moments) -> None:
    import rerun as rr

    n = len(scenario.people)
    _send_bodies(stream, "world/people", moments, slice(0, n))
    where = changes(moments.position[:, :n], moments.activity)
    signs = SIGN * SIGNS[moments.activity[where]]
    signs += moments.position[where, :n, None]
    drawn = strips(rr.LineStrips2D.descriptor_strips(), signs)
    _send_at(stream, "world/people/signs", moments, where, drawn)
    where = changes(moments.position[:, :n], moments.gaze[:, :n], moments.half_view)
    cones = gaze_cones(
        moments.position[where, :n],
        moments.gaze[where, :n],
        moments.half_view[where],
        scenario.plan.opaque_segments,
        scenario.perception.distance,
    )
    outline = strips(rr.LineStrips2D.descriptor_strips(), cones)
    _send_at(stream, "world/people/gaze", moments, where, outline)


def _send_robots(stream: Stream, scenario: Scenario, moments: Moments) -> None:
    import rerun as rr

    robots = slice(len(scenario.people), None)
    _send_bodies(stream, "world/robots", moments, robots)
    points = rr.Points2D.descriptor_positions()
    where = changes(moments.position[:, robots])
    rings = vectors(points, moments.position[where, robots])
    _send_at(stream, "world/robots/doing", moments, where, rings)
    where = changes(moments.behavior)
    # Before the first choice it is -1.
    behavior = moments.behavior[where] + 1
    look = colors(rr.Points2D.descriptor_colors(), _palette(scenario)[behavior])
    _send_at(stream, "world/robots/doing", moments, where, look)
    doing = ["-", *scenario.behaviors]
    labels = [f"{name}: {word}" for name in scenario.robot_names for word in doing]
    which = behavior + len(doing) * np.arange(len(scenario.robots))
    names = texts(rr.Points2D.descriptor_labels(), labels, which)
    _send_at(stream, "world/robots/names", moments, where, names)


def _send_names(stream: Stream, scenario: Scenario, moments: Moments) -> None:
    """Writes where names are; the viewer draws them below what they belong to."""
    import rerun as rr

    n = len(scenario.people)
    where = changes(moments.position)
    scale = float((VIEW / size_of(scenario.plan)).min())
    longest = max(map(len, scenario.behaviors)) + 2
    letters = [len(name) for name in scenario.person_names]
    letters += [len(name) + longest for name in scenario.robot_names]
    size = np.array([(LETTER * each + 14.0, LINE) for each in letters]) / scale
    radius = np.full(len(letters), PERSON_RADIUS)
    radius[n:] = 1.25 * ROBOT_RADIUS
    centers = place_labels(moments.position[where], radius, size)
    tops = centers + np.array([0.0, 0.62 * LINE / scale])
    points = rr.Points2D.descriptor_positions()
    for group, who in (("people", slice(0, n)), ("robots", slice(n, None))):
        places = vectors(points, tops[:, who])
        _send_at(stream, f"world/{group}/names", moments, where, places)


def _palette(scenario: Scenario) -> NDArray[np.uint32]:
    """The color of no behavior, and those of all behaviors."""
    return packed([IDLE, *behavior_colors(scenario.behaviors)])


def _send_bodies(stream: Stream, entity: str, moments: Moments, who: slice) -> None:
    """Writes where bodies are and where they face."""
    import rerun as rr

    where = changes(moments.position[:, who], moments.heading[:, who])
    position, angle = moments.position[where, who], moments.heading[where, who]
    ahead = np.stack([np.cos(angle), np.sin(angle)], -1)
    bodies = (
        vectors(rr.Points2D.descriptor_positions(), position),
        vectors(rr.Arrows2D.descriptor_vectors(), ARROW * ahead),
        vectors(rr.Arrows2D.descriptor_origins(), position + EDGE * ahead),
    )
    _send_at(stream, entity, moments, where, *bodies)


def _send_at(
    stream: Stream,
    entity: str,
    moments: Moments,
    where: Indices,
    *columns: "ComponentColumn",
) -> None:
    """Writes columns that have values for some of the moments only."""
    stream.send(entity, (moments.decision[where], moments.time[where]), columns)


def _send_series(stream: Stream, moments: Moments, total: Floats) -> None:
    import rerun as rr

    sums = total + np.cumsum(moments.reward, axis=0)
    series = (("reward/sum", sums, 0.0), ("mood", moments.mood, VISIBLE))
    for entity, values, tolerance in series:
        where = bends(values, tolerance)
        scalars = rr.Scalars.columns(scalars=values[where])
        _send_at(stream, entity, moments, where, *scalars)
    # Moments without a touch would draw a line of dots at 0.
    where = np.flatnonzero((moments.reward != 0.0).any(axis=1))
    reward = moments.reward[where]
    felt = rr.Scalars.columns(scalars=np.where(reward == 0.0, np.nan, reward))
    _send_at(stream, "reward/now", moments, where, *felt)


def _send_attention(stream: Stream, moments: Moments) -> None:
    import rerun as rr

    where = changes(moments.attention)
    cells = pictures(rr.Image.descriptor_buffer(), heat(moments.attention[where]))
    _send_at(stream, "attention", moments, where, cells)


def _send_lanes(stream: Stream, scenario: Scenario, moments: Moments) -> None:
    import rerun as rr

    kind = rr.StateChange.descriptor_state()
    behaviors = ["", *scenario.behaviors]
    states = np.hstack([moments.activity, moments.behavior + 1])
    for lane, state in zip(lanes_of(scenario), states.T, strict=True):
        names = behaviors if lane.startswith("behavior") else ACTIVITY_NAMES
        where = changes(state)
        column = texts(kind, names, state[where, None])
        _send_at(stream, lane, moments, where, column)


def _send_credit_lanes(stream: Stream, scenario: Scenario, moments: Moments) -> None:
    """Writes a piece of lane for each moment, in the color of what the robot did.

    The viewer shows those of the last `WINDOW` seconds together, and they move left as
    time goes by.
    """
    import rerun as rr

    n, unit = len(scenario.robots), second(scenario)
    end = moments.time * unit
    pieces = np.empty((len(moments), n, 2, 2), dtype=np.float32)
    pieces[:, :, 0, 0] = (end - scenario.decision_period * unit)[:, None]
    pieces[:, :, 1, 0] = end[:, None]
    pieces[..., 1] = (np.arange(n) * LANE)[:, None]
    look = _palette(scenario)[moments.behavior + 1]
    shift = np.zeros((len(moments), 3), dtype=np.float32)
    shift[:, 0] = -end
    lanes = (
        strips(rr.LineStrips2D.descriptor_strips(), pieces),
        colors(rr.LineStrips2D.descriptor_colors(), look),
        *rr.Transform3D.columns(translation=shift),
    )
    stream.send("credit/past", (moments.decision, moments.time), lanes)

"""Writes what changes from moment to moment, as columns."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from household.activity import ACTIVITY_NAMES
from household.compiled.arrays import Floats, Indices
from household.replay.columns import colors, exact, pictures, strips, texts, vectors
from household.replay.names import Felt, send_names
from household.replay.rows import bends, changes
from household.replay.scenery import lanes_of
from household.replay.sheets import LANE, second
from household.replay.stream import Stream
from household.scenario.scenario import Scenario
from household.simulation.moment import FIELDS, Moments
from household.simulation.simulation import PERSON_RADIUS
from household.view.colors import IDLE, behavior_colors, heat, packed
from household.view.cone import gaze_cones
from household.view.signs import SIGNS

if TYPE_CHECKING:
    from rerun import ComponentColumn

ARROW, EDGE = 0.18, 0.2
"""Length of the arrow that shows where a body faces, and where it begins [m]."""

VISIBLE = 0.005
"""By how much a drawn curve may miss a mood, which is in [-1, 1]."""

SIGN = 0.62 * PERSON_RADIUS
"""Size of the sign in a person's body [m]."""


def send_moments(
    stream: Stream,
    scenario: Scenario,
    moments: Moments,
    total: Floats,
    felt: Sequence[Felt],
) -> None:
    """Writes what happened.

    Args:
        stream: Where to.
        scenario: The household.
        moments: What happened.
        total: Sum of each robot's rewards before that, shape (n_robots,).
        felt: The touches that robots' names tell of.
    """
    # The exact state comes first: it can be read where a kill cuts off what is drawn.
    send_state(stream, moments)
    _send_people(stream, scenario, moments)
    _send_robots(stream, scenario, moments)
    send_names(stream, scenario, moments, felt)
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

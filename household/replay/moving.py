"""What changes from moment to moment, as columns."""

import numpy as np
from numpy.typing import NDArray

from household.activity import ACTIVITY_NAMES, Activity
from household.life import PERSON_RADIUS, ROBOT_RADIUS
from household.perception.cone import RAYS, gaze_cones
from household.replay.colors import ACTIVITIES, behavior_color, heat, packed
from household.replay.rows import NAMES, Rows
from household.replay.scenery import LANE, lanes_of, second
from household.replay.stream import Stream, exact
from household.scenario import Scenario

ARROW = 0.35
"""Length of the arrow that shows where a body faces [m]."""

Mask = NDArray[np.bool_]


def changes(*columns: NDArray[np.generic]) -> Mask:
    """Rows that differ from the row before, and the first one, shape (n_rows,)."""
    mask = np.ones(len(columns[0]), dtype=np.bool_)
    mask[1:] = False
    for column in columns:
        flat = column.reshape(len(column), -1)
        mask[1:] |= (flat[1:] != flat[:-1]).any(axis=1)
    return mask


def send_rows(
    stream: Stream, scenario: Scenario, rows: Rows, total: NDArray[np.float64]
) -> None:
    """Writes what happened.

    Args:
        stream: Where to.
        scenario: The household.
        rows: The moments.
        total: Sum of each robot's rewards before these rows, shape (n_robots,).
    """
    _send_people(stream, scenario, rows)
    _send_robots(stream, scenario, rows)
    _send_series(stream, rows, total)
    _send_attention(stream, rows)
    _send_lanes(stream, scenario, rows)
    _send_credit_lanes(stream, scenario, rows)
    # The exact state comes last: where it is, everything is.
    state = [exact(name, getattr(rows, name)) for name in NAMES[2:]]
    stream.send("state", (rows.decision, rows.time), state)


def _send_people(stream: Stream, scenario: Scenario, rows: Rows) -> None:
    import rerun as rr

    n = len(scenario.people)
    _send_bodies(stream, "world/people", rows, slice(0, n), PERSON_RADIUS)
    mask = changes(rows.activity)
    colors = packed(ACTIVITIES)[rows.activity[mask]]
    labels = _person_labels(scenario)[np.arange(n), rows.activity[mask]]
    style = rr.Points2D.columns(colors=colors.reshape(-1))
    _send_groups(stream, "world/people", rows, mask, style, n)
    texts = rr.Points2D.columns(labels=labels.reshape(-1).tolist())
    _send_groups(stream, "world/people/names", rows, mask, texts, n)
    mask = changes(rows.position[:, :n], rows.gaze[:, :n], rows.half_view)
    cones = gaze_cones(
        rows.position[mask, :n],
        rows.gaze[mask, :n],
        rows.half_view[mask],
        scenario.plan.opaque_segments,
        scenario.perception.distance,
    )
    strips = cones.reshape(-1, RAYS + 2, 2).astype(np.float32)
    tint = packed(ACTIVITIES, 160)[rows.activity[mask]].reshape(-1)
    outline = rr.LineStrips2D.columns(strips=strips, colors=tint)
    _send_groups(stream, "world/people/gaze", rows, mask, outline, n)


def _person_labels(scenario: Scenario) -> NDArray[np.object_]:
    """What stands at each person in each activity, shape (n_people, n_activities)."""
    return np.array(
        [
            [f"{name}: {word}" for word in ACTIVITY_NAMES[: Activity.UNKNOWN]] + [name]
            for name in scenario.person_names
        ],
        dtype=np.object_,
    )


def _send_robots(stream: Stream, scenario: Scenario, rows: Rows) -> None:
    import rerun as rr

    n = len(scenario.robots)
    robots = slice(len(scenario.people), None)
    _send_bodies(stream, "world/robots", rows, robots, ROBOT_RADIUS)
    mask = changes(rows.behavior)
    names = [*scenario.behaviors, "-"]
    labels = [
        f"{name}: {names[behavior]}"
        for behaviors in rows.behavior[mask]
        for name, behavior in zip(scenario.robot_names, behaviors, strict=True)
    ]
    colors = packed([behavior_color(int(b)) for b in rows.behavior[mask].reshape(-1)])
    style = rr.Points2D.columns(colors=colors)
    _send_groups(stream, "world/robots", rows, mask, style, n)
    texts = rr.Points2D.columns(labels=labels)
    _send_groups(stream, "world/robots/names", rows, mask, texts, n)


def _send_bodies(
    stream: Stream, entity: str, rows: Rows, who: slice, radius: float
) -> None:
    """Where bodies are and face; their names stand below them."""
    import rerun as rr

    mask = changes(rows.position[:, who], rows.heading[:, who])
    position = rows.position[mask, who].reshape(-1, 2)
    angle = rows.heading[mask, who].reshape(-1)
    arrows = ARROW * np.stack([np.cos(angle), np.sin(angle)], 1)
    n = rows.position[0, who].shape[0]
    points = rr.Points2D.columns(positions=position)
    _send_groups(stream, entity, rows, mask, points, n)
    names = rr.Points2D.columns(positions=position - np.array([0.0, radius]))
    _send_groups(stream, f"{entity}/names", rows, mask, names, n)
    heading = rr.Arrows2D.columns(origins=position, vectors=arrows)
    _send_groups(stream, f"{entity}/heading", rows, mask, heading, n)


def _send_groups(
    stream: Stream, entity: str, rows: Rows, mask: Mask, columns: object, size: int
) -> None:
    """Writes groups of the same size at some of the rows."""
    count = int(mask.sum())
    parts = columns.partition(np.full(count, size))  # type: ignore[attr-defined]
    stream.send(entity, (rows.decision[mask], rows.time[mask]), parts)


def _send_series(stream: Stream, rows: Rows, total: NDArray[np.float64]) -> None:
    import rerun as rr

    moments = rows.decision, rows.time
    sums = total + np.cumsum(rows.reward, axis=0)
    stream.send("reward/sum", moments, rr.Scalars.columns(scalars=sums))
    stream.send("mood", moments, rr.Scalars.columns(scalars=rows.mood))
    # Moments without a touch would draw a line of dots at 0.
    touched = np.where(rows.reward == 0.0, np.nan, rows.reward)
    mask = (rows.reward != 0.0).any(axis=1)
    felt = rr.Scalars.columns(scalars=touched[mask])
    stream.send("reward/now", (rows.decision[mask], rows.time[mask]), felt)


def _send_attention(stream: Stream, rows: Rows) -> None:
    import rerun as rr

    mask = changes(rows.attention)
    cells = heat(rows.attention[mask])
    image = rr.Image.columns(buffer=cells.reshape(len(cells), -1))
    stream.send("attention", (rows.decision[mask], rows.time[mask]), image)


def _send_lanes(stream: Stream, scenario: Scenario, rows: Rows) -> None:
    import rerun as rr

    behaviors, activities = [*scenario.behaviors, ""], list(ACTIVITY_NAMES)
    courses = np.hstack([rows.activity, rows.behavior]).T
    for lane, course in zip(lanes_of(scenario), courses, strict=True):
        names = behaviors if lane.startswith("behavior") else activities
        mask = changes(course)
        states = rr.StateChange.columns(state=[names[i] for i in course[mask]])
        stream.send(lane, (rows.decision[mask], rows.time[mask]), states)


def _send_credit_lanes(stream: Stream, scenario: Scenario, rows: Rows) -> None:
    """A piece of lane for each moment, in the color of what the robot did.

    The viewer shows those of the last while together; all move left as time goes by.
    """
    import rerun as rr

    n, unit = len(scenario.robots), second(scenario)
    end = np.repeat(rows.time * unit, n)
    lane = np.tile(np.arange(n) * LANE, len(rows))
    begin = np.stack([end - scenario.decision_period * unit, lane], 1)
    strips = np.stack([begin, np.stack([end, lane], 1)], 1)
    strips = strips.astype(np.float32)
    palette = [behavior_color(b) for b in range(-1, len(scenario.behaviors))]
    colors = packed(palette)[rows.behavior.reshape(-1) + 1]
    lanes = rr.LineStrips2D.columns(strips=strips, colors=colors)
    everything = np.ones(len(rows), dtype=np.bool_)
    _send_groups(stream, "credit/past/lanes", rows, everything, lanes, n)
    shift = np.zeros((len(rows), 3), dtype=np.float32)
    shift[:, 0] = -rows.time * unit
    moments = rows.decision, rows.time
    stream.send("credit/past", moments, rr.Transform3D.columns(translation=shift))

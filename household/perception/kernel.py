"""The perception kernel: sight, attention and hearing as plain loops over arrays.

Compiled with Numba, because asking the physics engine for every line of sight would
cost more than the rest of a step (docs/performance.md). Everything is pure: arrays
in, arrays out; entities are indexed people first, then robots.
"""

import numpy as np
from numpy.typing import NDArray

from household.compiled.arrays import Floats, Integers, Mask
from household.compiled.jit import compiled

NEAREST = 0.3
"""Distance below which a sound gets no louder [m]: an ear is not inside its source."""


@compiled
def between(position: Floats, i: int, j: int, columns: Floats) -> int:
    """How many segments stand between two entities, as `crosses` has it.

    Args:
        position: Shape (n, 2) [m].
        i: Index of one of them.
        j: Index of the other.
        columns: The segments, shape (4, m), columns of x1, y1, x2, y2 [m].
    """
    ends, count, asked = np.empty((2, 2)), np.zeros(2, np.int32), np.ones(2, np.bool_)
    ends[0], ends[1] = position[i], position[j]
    _count_between(ends, 0, columns, _sides(ends, columns), asked, count)
    return int(count[1])


@compiled
def _sides(position: Floats, columns: Floats) -> Floats:
    """On which side of each segment each entity is, by the sign, shape (n, m)."""
    x1, y1, x2, y2 = columns[0], columns[1], columns[2], columns[3]
    sides = np.empty((len(position), columns.shape[1]))
    for i in range(len(position)):
        x, y = position[i]
        for k in range(columns.shape[1]):
            ex, ey = x2[k] - x1[k], y2[k] - y1[k]
            sides[i, k] = ex * (y - y1[k]) - ey * (x - x1[k])
    return sides


@compiled
def _count_between(
    position: Floats,
    i: int,
    columns: Floats,
    sides: Floats,
    asked: Mask,
    count: NDArray[np.int32],
) -> None:
    """How many segments stand between one entity and those that are asked for.

    Without a branch, with each coordinate of all segments in a row of its own, and with
    a small number to count in, the processor looks at many segments at once.
    """
    ax, ay = position[i, 0], position[i, 1]
    for j in range(len(position)):
        if asked[j]:
            dx, dy = position[j, 0] - ax, position[j, 1] - ay
            found = np.int32(0)
            for k in range(columns.shape[1]):
                side1 = dx * (columns[1, k] - ay) - dy * (columns[0, k] - ax)
                side2 = dx * (columns[3, k] - ay) - dy * (columns[2, k] - ax)
                apart = (side1 * side2 <= 0.0) & (side1 != side2)
                found += np.int32(apart & (sides[i, k] * sides[j, k] <= 0.0))
            count[j] = found


@compiled
def separate(
    before: Floats,
    position: Floats,
    walls: Floats,
    tall: Floats,
    wall_loss: float,
    silent: int,
    hidden: Integers,
    loss: Floats,
) -> None:
    """Brings up to date what stands between those pairs of which one has moved.

    Args:
        before: Where everybody was when this was last done, shape (n, 2) [m].
        position: Where everybody is, shape (n, 2) [m].
        walls: Segments that block sight and dampen sound, shape (4, m), columns of
            x1, y1, x2, y2 [m].
        tall: Diagonals of what blocks sight alone, shape (4, k) [m].
        wall_loss: What one wall takes from a sound [dB].
        silent: So many of the first make no sound; between those, none is lost.
        hidden: Walls between each two, or where there is none, tall things, (n, n);
            changed in place.
        loss: What a sound loses between each two, symmetric and infinite on the
            diagonal, shape (n, n) [dB]; changed in place.

    At the end ``before`` holds where everybody is.
    """
    n, gone = len(position), before != position
    moved = gone[:, 0] | gone[:, 1]
    of_walls, of_tall = _sides(position, walls), _sides(position, tall)
    asked, found = np.zeros(n, np.bool_), np.zeros(n, np.int32)
    for i in range(n):
        for j in range(i + 1, n):
            asked[j] = moved[i] or moved[j]
        asked[i] = False
        _count_between(position, i, walls, of_walls, asked, found)
        for j in range(i + 1, n):
            if asked[j]:
                if j >= silent:
                    loss[i, j] = _loss(position, i, j, found[j] * wall_loss)
                    loss[j, i] = loss[i, j]
                hidden[i, j] = hidden[j, i] = found[j]
                asked[j] = found[j] == 0
        _count_between(position, i, tall, of_tall, asked, found)
        for j in range(i + 1, n):
            if asked[j]:
                hidden[i, j] = hidden[j, i] = found[j]
    before[:] = position


@compiled
def sight(
    position: Floats,
    gaze: Floats,
    half_view: Floats,
    hidden: Integers,
    sees: Mask,
    facing: Floats,
) -> None:
    """Who sees whom.

    Args:
        position: Shape (n, 2) [m].
        gaze: Where the head points, shape (n,) [rad].
        half_view: Half the field of view, shape (n,) [rad]; negative: eyes closed.
        hidden: Opaque segments between each two entities, shape (n, n).
        sees: Set to ``sees[i, j]``: j is in the field of view of i and nothing opaque
            is between them; shape (n, n), False on the diagonal.
        facing: Set to the cosine of the angle between the gaze of i and the direction
            to j, shape (n, n).
    """
    n = position.shape[0]
    # Plain rows of numbers: the processor looks at several at once.
    xs, ys = position[:, 0].copy(), position[:, 1].copy()
    for i in range(n):
        ahead_x, ahead_y = np.cos(gaze[i]), np.sin(gaze[i])
        least = np.cos(half_view[i]) if half_view[i] >= 0.0 else np.inf
        for j in range(n):
            dx, dy = xs[j] - xs[i], ys[j] - ys[i]
            away = np.sqrt(dx * dx + dy * dy)
            cosine = (dx * ahead_x + dy * ahead_y) / away if away > 0.0 else 1.0
            cosine = 1.0 if cosine > 1.0 else cosine
            facing[i, j] = -1.0 if cosine < -1.0 else cosine
        for j in range(n):
            sees[i, j] = (facing[i, j] >= least) & (hidden[i, j] == 0)
        sees[i, i] = False


@compiled
def attention(
    position: Floats,
    sees: Mask,
    facing: Floats,
    salience: Floats,
    absorption: Floats,
    width: float,
    distance: float,
    share: Floats,
) -> None:
    """The attention matrix: how much of its attention each entity gives to each.

    For observer i and entity j, with mass over distance squared after Maisonnasse
    et al. (2006)::

        a_ij = sees_ij * m_j * exp(-angle_ij^2 / (2 width^2)) / (1 + (d_ij / d0)^2)
        A_ij = a_ij / (a_i0 + sum_k a_ik)

    Args:
        position: Shape (n, 2) [m].
        sees: Shape (n, n), from `sight`.
        facing: Cosines of the angles, shape (n, n), from `sight`.
        salience: Mass m of each entity, shape (n,).
        absorption: a_i0, what the own activity holds back, shape (n,), above 0.
        width: Of the gaze's focus [rad].
        distance: d0, at which an entity counts half [m].
        share: Set to A, shape (n, n); rows sum to less than 1.
    """
    n = position.shape[0]
    for i in range(n):
        total = absorption[i]
        for j in range(n):
            share[i, j] = 0.0
            if sees[i, j]:
                dx = position[j, 0] - position[i, 0]
                dy = position[j, 1] - position[i, 1]
                near = 1.0 + (dx * dx + dy * dy) / (distance * distance)
                angle = np.arccos(facing[i, j])
                focus = np.exp(-(angle**2) / (2.0 * width * width))
                share[i, j] = salience[j] * focus / near
                total += share[i, j]
        for j in range(n):
            share[i, j] /= total


@compiled
def _loss(position: Floats, i: int, j: int, through_walls: float) -> float:
    """What a sound loses between two entities [dB].

    A point source loses 6 dB for each doubling of the distance beyond 1 m, and a fixed
    amount with each wall in between.
    """
    dx = position[j, 0] - position[i, 0]
    dy = position[j, 1] - position[i, 1]
    away = max(np.sqrt(dx * dx + dy * dy), NEAREST)
    return 20.0 * np.log10(away) + through_walls


@compiled
def attend(
    share: Floats, above: float, below: float, now: float, attends: Mask, began: Floats
) -> bool:
    """Who attends to whom: it begins above one threshold and ends below a lower one.

    Args:
        share: The attention matrix, shape (n, n).
        above: Share of attention from which attending begins.
        below: Share from which it goes on.
        now: [s].
        attends: Who attends to whom, shape (n, n); brought up to date in place.
        began: Since when [s], NaN where not, shape (n, n); likewise.

    Returns:
        Whether anybody attends to others than before.
    """
    n, changed = share.shape[0], False
    for i in range(n):
        for j in range(n):
            goes_on = attends[i, j]
            attends[i, j] = share[i, j] >= (below if goes_on else above)
            changed |= attends[i, j] != goes_on
            if not attends[i, j]:
                began[i, j] = np.nan
            elif not goes_on:
                began[i, j] = now
    return changed


@compiled
def hear(source: Floats, loss: Floats, level: Floats) -> None:
    """How loud everybody hears each, at least 0.

    Args:
        source: Sound level of each at 1 m, shape (n,) [dB].
        loss: From `separate`, shape (n, n) [dB].
        level: Filled in, shape (n, n) [dB].
    """
    n = len(source)
    for i in range(n):
        for j in range(n):
            level[i, j] = max(source[j] - loss[i, j], 0.0)


@compiled
def perceive(
    walls: Floats,
    tall: Floats,
    wall_loss: float,
    silent: int,
    focus: float,
    distance: float,
    above: float,
    below: float,
    before: Floats,
    hidden: Integers,
    loss: Floats,
    sees: Mask,
    facing: Floats,
    share: Floats,
    level: Floats,
    attends: Mask,
    began: Floats,
    position: Floats,
    gaze: Floats,
    half_view: Floats,
    salience: Floats,
    absorption: Floats,
    source: Floats,
    now: float,
) -> bool:
    """All that everybody perceives at a moment; `Senses` says what is what.

    From ``before`` to ``began`` all is brought up to date in place. Returns whether
    anybody attends to others than before.
    """
    separate(before, position, walls, tall, wall_loss, silent, hidden, loss)
    sight(position, gaze, half_view, hidden, sees, facing)
    attention(position, sees, facing, salience, absorption, focus, distance, share)
    hear(source, loss, level)
    return attend(share, above, below, now, attends, began)

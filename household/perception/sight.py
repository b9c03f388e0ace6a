"""Sight: who is in whose field of view, with nothing in between."""

import numpy as np

from household.compiled.arrays import Mask
from household.compiled.jit import compiled
from household.perception.relations import Entities, Relations


@compiled
def see(entities: Entities, hidden: Mask, relations: Relations) -> None:
    """Finds out who sees whom.

    Args:
        entities: Everybody.
        hidden: Whether anything hides two from each other, shape (n, n).
        relations: Its ``sees`` and ``facing`` are filled in: i sees j if j is in the
            field of view of i and not hidden; nobody sees itself.
    """
    sees, facing = relations.sees, relations.facing
    n = len(entities.position)
    # Plain rows of numbers: the processor looks at several at once.
    xs, ys = entities.position[:, 0].copy(), entities.position[:, 1].copy()
    for i in range(n):
        ahead_x, ahead_y = np.cos(entities.gaze[i]), np.sin(entities.gaze[i])
        half = entities.half_view[i]
        least = np.cos(half) if half >= 0.0 else np.inf
        for j in range(n):
            dx, dy = xs[j] - xs[i], ys[j] - ys[i]
            away = np.sqrt(dx * dx + dy * dy)
            cosine = (dx * ahead_x + dy * ahead_y) / away if away > 0.0 else 1.0
            cosine = 1.0 if cosine > 1.0 else cosine
            facing[i, j] = -1.0 if cosine < -1.0 else cosine
        for j in range(n):
            sees[i, j] = (facing[i, j] >= least) & (not hidden[i, j])
        sees[i, i] = False

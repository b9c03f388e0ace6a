"""Solid ground: bodies stay out of walls and furniture, whatever pushes them.

Physics engines let a fast body sink into a wall for a tick before they push it back;
in a crowd that can be a hand's breadth. This sets it right after the engine's ticks.
"""

import numpy as np
from numba import njit
from numpy.typing import NDArray

from household.perception.kernel import crosses

Array = NDArray[np.float64]

ROUNDS = 3
"""How often a body is pushed out: a corner pushes it from one side to the other."""


@njit(cache=True)
def keep_out(
    before: Array, after: Array, radius: Array, segments: Array, thickness: Array
) -> NDArray[np.bool_]:
    """Puts bodies back that sank into something solid.

    A body whose middle went through a segment goes back to where it was; one that
    overlaps a segment is pushed out along the shortest way.

    Args:
        before: Where the bodies were, out of everything solid, shape (n, 2) [m].
        after: Where the engine moved them, shape (n, 2) [m]; changed in place.
        radius: Shape (n,) [m].
        segments: Shape (m, 4), rows of x1, y1, x2, y2 [m].
        thickness: Half thickness of each segment, shape (m,) [m].

    Returns:
        Whose position was changed, shape (n,).
    """
    n, m = after.shape[0], segments.shape[0]
    moved = np.zeros(n, np.bool_)
    for i in range(n):
        if before[i, 0] == after[i, 0] and before[i, 1] == after[i, 1]:
            continue
        for k in range(m):
            if crosses(
                before[i, 0], before[i, 1], after[i, 0], after[i, 1], segments[k]
            ):
                after[i] = before[i]
                moved[i] = True
        for _ in range(ROUNDS):
            for k in range(m):
                x1, y1, x2, y2 = segments[k]
                dx, dy = x2 - x1, y2 - y1
                ox, oy = after[i, 0] - x1, after[i, 1] - y1
                along = (ox * dx + oy * dy) / max(dx * dx + dy * dy, 1e-12)
                along = min(max(along, 0.0), 1.0)
                gx, gy = ox - along * dx, oy - along * dy
                gap = np.sqrt(gx * gx + gy * gy)
                least = radius[i] + thickness[k]
                if 1e-9 < gap < least:
                    after[i, 0] += gx / gap * (least - gap)
                    after[i, 1] += gy / gap * (least - gap)
                    moved[i] = True
    return moved

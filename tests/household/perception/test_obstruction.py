"""What stands between two: compared with exact geometry."""

from fractions import Fraction

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from household.home.geometry import crosses
from household.perception.obstruction import between

corner = st.tuples(st.integers(-20, 20), st.integers(-20, 20))


def properly_crosses(a, b, c, d):
    """Whether two segments cross, by solving for where; None if that is on an edge."""
    (ax, ay), (bx, by), (cx, cy), (dx, dy) = a, b, c, d
    determinant = (bx - ax) * (dy - cy) - (by - ay) * (dx - cx)
    if determinant == 0:
        return None
    t = Fraction((cx - ax) * (dy - cy) - (cy - ay) * (dx - cx), determinant)
    u = Fraction((cx - ax) * (by - ay) - (cy - ay) * (bx - ax), determinant)
    if t in (0, 1) or u in (0, 1):
        return None
    return 0 < t < 1 and 0 < u < 1


@settings(max_examples=300, deadline=None)
@given(corner, corner, corner, corner)
def test_lines_of_sight_are_crossed_exactly_where_geometry_says(a, b, c, d):
    expected = properly_crosses(a, b, c, d)
    if expected is not None:
        ends = np.array([a, b], dtype=float)
        columns = np.array([[*c, *d]], dtype=float).T.copy()
        assert between(ends, 0, 1, columns) == expected
        assert between(ends, 1, 0, columns) == expected
        assert crosses(*ends[0], *ends[1], columns[:, 0]) == expected

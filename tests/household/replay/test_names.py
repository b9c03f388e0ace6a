"""Names in the plan, and the lines that lead to them."""

import numpy as np

from household.replay.names import _leaders


def test_a_line_leads_to_the_edge_of_a_name_and_not_through_it():
    body = np.array([[[0.0, 0.0], [0.0, 0.0], [0.0, 0.0]]])
    center = np.array([[[3.0, 0.0], [0.0, -2.0], [0.1, 0.1]]])
    size = np.full((1, 3, 2), [2.0, 1.0])
    lines = _leaders(body, center, size)
    np.testing.assert_array_equal(lines[:, :, 0], body)
    ends = [[2.0, 0.0], [0.0, -1.5], [0.0, 0.0]]  # The last body is below its name.
    np.testing.assert_allclose(lines[0, :, 1], ends, atol=1e-12)

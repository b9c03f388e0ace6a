"""Heads: how fast they turn, and where walkers look."""

import math

import numpy as np
import pytest

from household.compiled.arrays import NOBODY


def test_heads_turn_no_faster_than_they_can_and_the_shorter_way(room, crowd_in):
    def look(*degrees: float) -> None:
        angles = np.radians(degrees)
        ahead = np.column_stack([np.cos(angles), np.sin(angles)])
        crowd.turn_heads(
            np.full(2, NOBODY), crowd.position + ahead, np.radians([30, 30])
        )

    crowd = crowd_in(room(), [(1.0, 2.5), (4.0, 2.5)])
    crowd.gaze[:] = math.radians(170.0), 0.0
    look(-170.0, 10.0)
    turned = np.degrees(crowd.gaze) % 360.0
    np.testing.assert_allclose(turned, [190.0, 10.0])
    look(-90.0, 180.0)
    assert np.degrees(crowd.gaze[0]) % 360.0 == pytest.approx(220.0)
    assert abs(np.degrees(crowd.gaze[1]) - 10.0) == pytest.approx(30.0)


def test_walkers_look_ahead_unless_at_somebody_and_who_has_nothing_to_look_at_too(
    room, crowd_in
):
    crowd = crowd_in(room(), [(1.0, 1.0), (4.0, 1.0), (1.0, 4.0)])
    crowd.heading[:] = crowd.gaze[:] = math.radians(40.0)
    nothing = (math.nan, math.nan)
    focus, most = np.array([(1.0, 2.0), nothing]), np.full(3, np.pi)
    crowd.walking[0] = True
    crowd.turn_heads(np.full(2, NOBODY), focus, most)
    np.testing.assert_allclose(np.degrees(crowd.gaze), 40.0)
    crowd.walking[0] = False
    crowd.turn_heads(np.array([NOBODY, 0]), focus, most)
    np.testing.assert_allclose(np.degrees(crowd.gaze) % 360.0, [90.0, 180.0, 40.0])

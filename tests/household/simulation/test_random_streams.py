"""Random numbers are the same whenever they are drawn."""

import numpy as np
import pytest

from household.simulation.random_streams import AHEAD, Draws


def some(distribution):
    return Draws([np.random.default_rng(k) for k in range(3)], 5, distribution)


@pytest.mark.parametrize("distribution", ["uniform", "normal"])
@pytest.mark.parametrize("leisure", [1, 3, AHEAD])
def test_numbers_drawn_ahead_at_any_time_are_those_drawn_when_needed(
    distribution, leisure
):
    eager, lazy = some(distribution), some(distribution)
    rng = np.random.default_rng(0)
    for _ in range(5 * AHEAD):
        numbers = eager.next()
        before = numbers.copy()
        for _ in range(rng.integers(leisure + 1)):
            eager.draw_ahead()
        assert (numbers == before).all()  # Still to be read.
        assert (numbers == lazy.next()).all()


def test_drawing_ahead_ends_when_there_is_no_room():
    draws = some("normal")
    for _ in range(AHEAD // 2):
        draws.next()
    pieces = 0
    while draws.draw_ahead():
        pieces += 1
    assert 0 < pieces < AHEAD
    assert not draws.draw_ahead()

from itertools import pairwise

import numpy as np
import pytest

from household.view.labels import place_labels

SIZE = np.array([1.2, 0.3])
BOUNDS = np.array([0.0, 0.0, 12.0, 8.0])


@pytest.fixture
def rng():
    return np.random.default_rng(1)


def placed(position, size=SIZE):
    sizes = np.tile(size, (*position.shape[:2], 1))
    return place_labels(position, np.full(position.shape[1], 0.2), sizes, BOUNDS)


def overlaps(centers, size=SIZE):
    """How many pairs of names cover each other."""
    apart = np.abs(centers[:, :, None] - centers[:, None]) + 1e-9 >= size
    covered = ~apart.any(axis=-1)
    return int(covered.sum() - covered.shape[0] * covered.shape[1])


def test_names_of_people_who_stand_together_do_not_overlap(rng):
    spots = rng.uniform((4.0, 3.0), (7.0, 5.0), (200, 12, 2))
    assert overlaps(placed(spots)) == 0


def test_a_name_that_nothing_hinders_is_below_its_body():
    centers = placed(np.array([[[6.0, 4.0]]]))
    assert abs(centers[0, 0, 0] - 6.0) < 1e-9
    assert centers[0, 0, 1] < 4.0 - 0.3


def test_names_stay_on_the_drawing():
    corners = np.array([[[0.1, 0.1], [11.9, 0.1], [0.1, 7.9], [11.9, 7.9]]])
    centers = placed(corners)
    assert (centers - SIZE / 2 >= BOUNDS[:2] - 1e-9).all()
    assert (centers + SIZE / 2 <= BOUNDS[2:] + 1e-9).all()


def test_names_rarely_jump_while_people_walk(rng):
    steps = rng.normal(0.0, 0.05, (300, 6, 2))
    spots = np.clip(5.0 + np.cumsum(steps, axis=0), 1.0, 7.0)
    offset = placed(spots) - spots
    jumps = sum((abs(b - a) > 0.1).any() for a, b in pairwise(offset))
    assert jumps < 60

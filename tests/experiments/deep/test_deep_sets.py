"""The encoder to which people are a set (extra `deep`)."""

import numpy as np
import pytest

pytest.importorskip("torch", reason="needs the extra `deep` (not in CI)")
pytest.importorskip("stable_baselines3", reason="needs the extra `deep` (not in CI)")

import torch

from experiments.deep.deep_sets import MOST, DeepSets, space, table

N_FEATURES = 5


def person(number):
    features = np.random.default_rng(number).uniform(-1, 1, N_FEATURES)
    return np.r_[1.0, features[1:]].astype(np.float32)


@pytest.fixture
def encoder():
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(0)
        return DeepSets(space(N_FEATURES))


def encoded(encoder, *rows):
    people = np.stack(rows)[None]
    with torch.no_grad():
        return encoder(torch.from_numpy(people))[0].numpy()


def test_the_order_of_people_makes_no_difference(encoder):
    here = table({str(i): person(i) for i in range(4)}, N_FEATURES)
    mixed = np.random.default_rng(0).permutation(here)
    assert not np.array_equal(mixed, here)
    assert encoded(encoder, *mixed) == pytest.approx(encoded(encoder, *here), abs=1e-5)


def test_empty_slots_make_no_difference(encoder):
    here = table({"ann": person(1), "bob": person(2)}, N_FEATURES)
    assert here.shape == (MOST, N_FEATURES)
    two = encoded(encoder, person(1), person(2))
    assert encoded(encoder, *here) == pytest.approx(two, abs=1e-5)


def test_who_is_there_makes_a_difference_and_nobody_is_nothing(encoder):
    one, other = (encoded(encoder, person(number)) for number in (1, 2))
    both = encoded(encoder, person(1), person(2))
    assert np.abs(one - other).max() > 0.01
    assert both == pytest.approx(one + other, abs=1e-5)
    assert not encoded(encoder, *table({}, N_FEATURES)).any()

"""Facts about what the people who are there want of a robot."""

import numpy as np
import pytest

from household.people.appraisal import heard_strength, seen_strength
from household.people.appropriateness import weigh_behaviors
from household.perception.relations import Relations

N_PEOPLE, N_ROBOTS, N_ACTIVITIES, N_BEHAVIORS = 3, 2, 4, 5


@pytest.fixture
def rng():
    return np.random.default_rng(0)


@pytest.fixture
def relations(rng):
    n = N_PEOPLE + N_ROBOTS
    return Relations(
        sees=np.ones((n, n), np.bool_),
        facing=np.ones((n, n)),
        attention=rng.uniform(0, 1, (n, n)),
        attends=rng.uniform(0, 1, (n, n)) < 0.5,
        attention_began=np.zeros((n, n)),
        loss=rng.uniform(0, 60, (n, n)),
        level=np.zeros((n, n)),
    )


@pytest.fixture
def preferences(rng):
    return rng.uniform(-1, 1, (N_PEOPLE, N_ACTIVITIES, 2, N_BEHAVIORS))


LOUDNESS = np.array([0.0, 40.0, 60.0, 80.0, 100.0])
ACTIVITY = np.array([0, 2, 3])


def appropriateness(preferences, relations, robot):
    weighed = np.full(N_BEHAVIORS, np.nan)
    weigh_behaviors(preferences, LOUDNESS, ACTIVITY, relations, robot, weighed)
    return weighed


@pytest.mark.parametrize("robot", range(N_ROBOTS))
def test_it_is_the_mean_of_what_each_wants_times_how_well_each_perceives_it(
    preferences, relations, robot
):
    target = N_PEOPLE + robot
    wanted = [
        [
            preferences[i, ACTIVITY[i], int(relations.attends[i, target]), b]
            * max(
                seen_strength(relations.attention[i, target]),
                heard_strength(LOUDNESS[b] - relations.loss[i, target]),
            )
            for b in range(N_BEHAVIORS)
        ]
        for i in range(N_PEOPLE)
    ]

    found = appropriateness(preferences, relations, robot)

    np.testing.assert_allclose(found, np.mean(wanted, axis=0), rtol=1e-12)


def test_nobody_minds_what_they_neither_see_nor_hear(preferences, relations):
    relations.attention[:] = 0.0
    relations.loss[:] = np.inf

    assert not appropriateness(preferences, relations, 0).any()

"""A robot that nobody perceives does what brought it among people."""

import numpy as np
import pytest

from learners import load, make_learner
from learners.components import made
from learners.errors import ParameterError, SavedFileError, StateError
from learners.experience import Experience
from learners.exploration import Estimates, Greedy, SeekCompany
from learners.representation.views import is_alone

from ..conftest import ToyState

READING = (("ann", "reading"),)
BY_ANN = frozenset({("ann", "robot")})
ALONE, HEARD = ToyState(READING), ToyState(READING, hears=BY_ANN)
SEEN = ToyState(READING, looks=BY_ANN)
PLAY, FOLLOW = 0, 1


def learner(seed=3, **settings):
    exploration = {"name": "seek_company", "among": "greedy"}
    settings = made(
        {"representation": "nested_views", "exploration": exploration} | settings
    )
    return make_learner("full_sharing", 2, np.random.default_rng(seed), **settings)


def lived(learner, *entries):
    for time, (state, action, after) in enumerate(entries):
        learner.learn(
            Experience(
                state=state,
                action=action,
                next_state=after,
                time=float(time),
                next_time=time + 1.0,
            )
        )
    return learner


def shares(learner, state, n=600):
    return np.bincount([learner.act(state) for _ in range(n)], minlength=2) / n


def test_who_is_neither_seen_nor_heard_is_alone():
    assert is_alone(ALONE)
    assert not is_alone(HEARD)
    assert not is_alone(SEEN)


def test_at_first_a_lonely_robot_tries_everything():
    assert shares(learner(), ALONE) == pytest.approx([0.5, 0.5], abs=0.07)


def test_it_learns_what_brings_it_among_people():
    entries = [(ALONE, PLAY, ALONE), (ALONE, FOLLOW, HEARD)] * 20
    assert shares(lived(learner(), *entries), ALONE)[FOLLOW] > 0.99


def test_what_it_does_among_people_says_nothing_of_how_to_get_there():
    entries = [(HEARD, PLAY, ALONE), (HEARD, FOLLOW, SEEN)] * 20
    assert shares(lived(learner(), *entries), ALONE) == pytest.approx(
        [0.5, 0.5], abs=0.07
    )


def test_among_people_the_other_rule_chooses(rng):
    rule = SeekCompany(among=Greedy())
    rule.note(PLAY, found=True)
    assert rule.choose(Estimates([0.0, 1.0], [1.0, 1.0]), rng) == FOLLOW


def test_values_are_not_touched_by_company():
    entries = [(ALONE, FOLLOW, HEARD)] * 5
    assert lived(learner(), *entries).q_values(ALONE).tolist() == [0.0, 0.0]


def test_a_whole_situation_can_be_sought_out_as_well():
    whole = lived(learner(representation="named"), *[(ALONE, FOLLOW, SEEN)] * 20)
    assert shares(whole, ALONE)[FOLLOW] > 0.9


def test_a_saved_learner_goes_on_seeking_as_it_would_have(tmp_path):
    entries = [(ALONE, PLAY, ALONE), (ALONE, FOLLOW, HEARD)] * 3
    one = lived(learner(), *entries)
    one.save(tmp_path / "learner.json")
    twin = load(tmp_path / "learner.json")
    assert [twin.act(ALONE) for _ in range(50)] == [one.act(ALONE) for _ in range(50)]
    assert twin.exploration.found == {FOLLOW: 3}
    assert twin.exploration.missed == {PLAY: 3}


@pytest.mark.parametrize("count", [-1, 10**400])
def test_a_count_that_cannot_be_is_refused(tmp_path, count):
    odd = learner()
    odd.exploration.found[PLAY] = count
    odd.save(tmp_path / "learner.json")
    with pytest.raises(SavedFileError, match="company"):
        load(tmp_path / "learner.json")


def test_a_state_without_views_is_refused_before_anything_is_learned():
    whole = learner(representation="named")
    with pytest.raises(StateError, match="views"):
        lived(whole, ("calling", PLAY, "reading"))
    assert not len(whole.history)


def test_the_rule_among_people_must_be_one():
    with pytest.raises(ParameterError, match="among people"):
        SeekCompany(among="greedy")

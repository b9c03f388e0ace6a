import numpy as np
import pytest

from household.errors import HouseholdError
from household.replay import RecordEpisodes
from household.replay.finding import find, first_touch
from household.replay.reading import read_replay


@pytest.fixture
def path(busy_home, tmp_path):
    env = RecordEpisodes(busy_home, tmp_path, flush_every=64)
    env.reset(seed=3)
    rng = np.random.default_rng(0)
    while env.agents:
        env.step({a: int(rng.integers(len(env.behaviors))) for a in env.agents})
    return tmp_path / "episode_00000.rrd"


@pytest.mark.parametrize("kind", ["tap", "caress"])
def test_all_touches_of_a_person_are_found_and_no_others(path, kind):
    touches = read_replay(path, tried=True).touches
    givers = {t.feedback.giver for each in touches.values() for t in each}
    for giver in givers:
        felt = [
            decision
            for decision, each in touches.items()
            for touch in each
            if (touch.feedback.giver, touch.feedback.kind) == (giver, kind)
        ]
        if felt:
            events = find(path, f"{kind.upper()}  by {giver} ", tried=True)
            assert [event.decision for event in events] == sorted(felt)
            assert {event.kind for event in events} == {kind.upper()}


def test_touches_for_what_another_robot_did_are_wrong_blame(path):
    touches = read_replay(path, tried=True).touches
    blamed = [
        decision
        for decision, each in touches.items()
        for touch in each
        if touch.cause.robot != touch.robot
    ]
    assert [
        event.decision for event in find(path, "wrong blame", tried=True)
    ] == sorted(blamed)
    assert blamed


def test_the_first_touch_is_the_earliest_of_all(path):
    assert first_touch(path) == min(read_replay(path, tried=True).touches)


def test_what_is_not_found_is_told_with_what_can_be(path):
    with pytest.raises(HouseholdError, match='no event says "opera"; ask for'):
        find(path, "opera", tried=True)
    with pytest.raises(HouseholdError, match="no such file"):
        find(path.with_name("other.rrd"), "tap", tried=True)

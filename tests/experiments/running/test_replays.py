import pytest

from experiments.running.replays import record
from experiments.running.study import Condition, Trial
from household.replay.reading import read_replay


@pytest.fixture(scope="module")
def replay(tmp_path_factory):
    """A replay of one minute of experiment 1."""
    path = tmp_path_factory.mktemp("replays") / "short.rrd"
    condition = Condition(
        name="a",
        scenario="experiment_1",
        learner="q_asynchronous",
        scenario_overrides={"max_cycles": 60},
    )
    record(Trial(condition=condition, seed=2), path)
    return path


def test_a_replay_shows_every_decision_from_the_reset_to_the_end(replay):
    assert read_replay(replay, tried=True).moments.decision.tolist() == list(range(61))


def test_nothing_but_the_replay_is_left_behind(replay):
    assert list(replay.parent.iterdir()) == [replay]

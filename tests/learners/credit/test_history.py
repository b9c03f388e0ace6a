import pytest

from learners.credit.history import History
from learners.errors import ExperienceError, ParameterError


@pytest.fixture
def history(entry):
    history = History(horizon=10.0)
    for time in (0.0, 2.0, 3.0):
        history.append(entry(time=time, next_time=time + 1.0))
    return history


@pytest.mark.parametrize(
    ("time", "in_force", "before"),
    [(-1, 0, 0), (0, 0, 0), (2, 1, 0), (2.5, 1, 1), (9, 2, 2)],
)
def test_an_entry_is_in_force_from_its_beginning(history, time, in_force, before):
    assert history.in_force(time) == in_force
    assert history.before(time) == before


def test_entries_beyond_the_horizon_are_forgotten(history, entry):
    history.append(entry(time=11.5, next_time=12.5))
    assert [each.time for each in history.entries] == [2.0, 3.0, 11.5]
    assert len(history.exploratory) == 3


def test_an_entry_that_overlaps_the_last_one_is_refused(history, entry):
    with pytest.raises(ExperienceError, match="start_episode"):
        history.check(entry(time=3.5))


def test_clocks_may_differ_by_rounding(entry):
    history = History()
    history.append(entry(time=0.0, next_time=0.1 + 0.2))
    history.check(entry(time=0.3))


def test_a_touch_older_than_the_history_is_refused(history, entry, touch):
    with pytest.raises(ExperienceError, match="older than the history"):
        history.check(entry("s", 0, 5.0, touch(time=-3.0)))


def test_a_touch_older_than_the_horizon_is_refused(history, entry, touch):
    with pytest.raises(ExperienceError, match="older than the history"):
        history.check(entry("s", 0, 30.0, touch(time=3.5)))


@pytest.mark.parametrize("ask", ["in_force", "before"])
def test_an_empty_history_has_nothing_to_credit(ask):
    with pytest.raises(ExperienceError, match="empty"):
        getattr(History(), ask)(1.0)


def test_a_horizon_of_zero_is_refused():
    with pytest.raises(ParameterError, match="horizon"):
        History(horizon=0.0)

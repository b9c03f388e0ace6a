"""Work that another thread does."""

import threading

import pytest

from household.replay.aside import Aside


def test_a_task_goes_on_while_its_beginner_does_something_else():
    aside, may, done = Aside(), threading.Event(), []
    aside.begin(lambda: (may.wait(), done.append(1)))
    assert not done
    may.set()
    aside.wait()
    assert done == [1]


def test_tasks_are_done_one_after_the_other():
    aside, done = Aside(), []
    for number in range(20):
        aside.begin(lambda number=number: done.append(number))
    aside.wait()
    assert done == list(range(20))


def test_an_error_comes_back_once_where_one_waits():
    aside = Aside()
    aside.begin(lambda: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        aside.wait()
    aside.wait()


def test_no_thread_is_left_behind():
    before, aside = threading.active_count(), Aside()
    aside.begin(lambda: None)
    aside.wait()
    assert threading.active_count() == before

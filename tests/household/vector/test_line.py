"""Two processes tell each other that they may go on, asleep or awake."""

import os
import socket
import threading
import time

import numpy as np
import pytest

from household.vector import line
from household.vector.line import PARENT, WORKER, Line


@pytest.fixture(params=[True, False], ids=["memory in order", "sockets only"])
def ends(request, monkeypatch):
    """Both ends of a line, and their sockets."""
    monkeypatch.setattr(line, "ORDERED", request.param and line.ORDERED)
    here, there = socket.socketpair()
    memory = np.zeros((2, 2), np.int64)
    yield Line(here, memory, PARENT), Line(there, memory, WORKER), here, there
    here.close()
    there.close()


def later(seconds, what):
    """Does something in another thread after a while."""
    thread = threading.Timer(seconds, what)
    thread.start()
    return thread


def test_each_word_is_heard_once(ends):
    parent, worker, *_ = ends
    for word in (b"s", b"s", b"b", b"\xff"):
        parent.tell(word)
        assert worker.hear() == word
        worker.tell(b".")
        assert parent.hear() == b"."


def test_who_sleeps_is_woken_and_hears_the_next_word_too(ends):
    parent, worker, *_ = ends
    for word in (b"s", b"b", b"s"):
        thread = later(20 * line.SPIN, lambda word=word: parent.tell(word))
        assert worker.hear() == word
        thread.join()
    parent.tell(b"!")
    assert worker.hear() == b"!"


def test_a_word_that_wakes_nobody_is_heard_after_a_nap(ends, monkeypatch):
    parent, worker, *_ = ends
    if not line.ORDERED:
        pytest.skip("every word wakes there")
    poll = worker._poll

    class Missed:
        """As if the word were told when this side was about to sleep."""

        def poll(self, most):
            worker._mine[line.ASLEEP] = False
            parent.tell(b"s")
            return poll.poll(most)

    monkeypatch.setattr(worker, "_poll", Missed())
    before = time.monotonic()
    assert worker.hear() == b"s"
    assert time.monotonic() - before < 10


def test_work_is_done_meanwhile_until_a_word_comes(ends):
    parent, worker, *_ = ends
    done = []

    def pieces():
        for piece in range(10):
            done.append(piece)
            if piece == 6:
                parent.tell(b"s")
            yield

    assert worker.hear(pieces()) == b"s"
    if line.ORDERED:
        assert done == list(range(7))


def test_the_end_of_the_other_side_is_heard(ends):
    _, worker, here, _ = ends
    thread = later(20 * line.SPIN, lambda: here.shutdown(socket.SHUT_RDWR))
    assert worker.hear() == b""
    thread.join()


def test_a_text_is_heard_as_a_word_and_the_rest(ends):
    parent, _, _, there = ends
    there.setblocking(True)
    there.sendall(b"!too bad")
    there.shutdown(socket.SHUT_RDWR)
    assert parent.hear() == b"!"
    assert parent.rest() == b"too bad"


def test_a_worker_whose_parent_is_another_now_hears_the_end(ends, monkeypatch):
    _, worker, *_ = ends
    monkeypatch.setattr(os, "getppid", lambda: -1)
    assert worker.hear() == b""

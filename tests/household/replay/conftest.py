"""What tests of replays share."""

import time

import pytest


@pytest.fixture
def until():
    """Waits until something holds; viewers start slowly on a busy machine."""

    def wait(true, seconds=60.0):
        end = time.monotonic() + seconds
        while True:
            try:
                if true():
                    return
            except Exception:  # Clients have no errors of their own to name here.
                if time.monotonic() > end:
                    raise
            assert time.monotonic() < end, "waited too long"
            time.sleep(0.1)

    return wait

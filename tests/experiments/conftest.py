"""Shared helpers: a module of tiny trial functions that worker processes can import."""

import os
import subprocess
import sys
import textwrap
import time

import pytest


@pytest.fixture
def program(tmp_path):
    """Returns a function that starts a Python script in a process group of its own."""

    def start(source, *arguments):
        script = tmp_path / "script.py"
        script.write_text(textwrap.dedent(source))
        return subprocess.Popen(
            [sys.executable, str(script), *map(str, arguments)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
        )

    return start


@pytest.fixture
def group_is_empty():
    """Returns a function that says whether a process group died out (waits 10 s)."""

    def check(group):
        for _ in range(100):
            try:
                os.killpg(group, 0)
            except ProcessLookupError:
                return True
            time.sleep(0.1)
        return False

    return check

"""Who analyzes beside other processes uses one thread, unless asked for otherwise."""

import os
import subprocess
import sys

import pytest

ASK = """
from experiments.threads import one_thread

one_thread()
import polars

print(polars.thread_pool_size())
"""


@pytest.mark.parametrize("asked", [None, "3"])
def test_a_library_starts_one_thread_unless_the_user_said_how_many(asked):
    plain = {k: v for k, v in os.environ.items() if k != "POLARS_MAX_THREADS"}
    own = plain if asked is None else plain | {"POLARS_MAX_THREADS": asked}
    said = subprocess.run(
        [sys.executable, "-c", ASK], env=own, capture_output=True, text=True, check=True
    )
    assert said.stdout.strip() == (asked or "1")


def test_commands_decide_that_before_tables_are_read():
    script = (
        "import sys; import experiments.commands.reproducing, experiments.cli; "
        "print('polars' in sys.modules, 'numpy' in sys.modules)"
    )
    said = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert said.stdout.strip() == "False False"

"""Trying out in another process whether a replay file can be read.

Rerun's reader ends its whole process at some files that were damaged or forged. Where a
person gives a file to a command, another process is therefore the first to read it.
"""

import subprocess
import sys
from pathlib import Path

from household.errors import HouseholdError, shown_path

WITHIN = 600.0
"""How long reading may take [s]."""

_READ = """
import sys
from household.errors import HouseholdError
from household.replay.reading import read_replay
try:
    read_replay(sys.argv[1])
except HouseholdError as error:
    sys.exit(f"\\n{error}")
"""


def check_readable(path: Path | str) -> None:
    """Has another process read a replay file.

    Raises:
        HouseholdError: If it cannot be read; one line that names the file.
    """
    command = [sys.executable, "-c", _READ, str(path)]
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=WITHIN, check=False
        )
    except (OSError, ValueError, subprocess.TimeoutExpired) as error:
        reason = " ".join(str(error).split()).replace(str(path), "it")
        raise HouseholdError(f"{shown_path(path)}: {shown_path(reason)}") from None
    if done.returncode == 0:
        return
    if done.returncode == 1 and done.stderr:
        raise HouseholdError(done.stderr.splitlines()[-1])
    raise HouseholdError(f"{shown_path(path)}: damaged; Rerun cannot read it")

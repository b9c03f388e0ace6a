"""Trying out in another process whether replay files can be read.

Rerun's reader ends its whole process at some files that were damaged or forged. Where a
file may come from anywhere, another process is therefore the first to read it.
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
    for path in sys.argv[1:]:
        print("next", flush=True)
        read_replay(path, tried=True)
except HouseholdError as error:
    sys.exit(f"\\n{error}")
"""


Version = tuple[str, int, int]
"""A file as it is now: its place, when it was written [ns], and its size [bytes]."""

_READ_WELL: set[Version] = set()
"""What need not be tried again: each time takes a second or two."""


def check_readable(*paths: Path | str) -> None:
    """Has another process read replay files, one after the other.

    Files that could be read, and have not changed since, are not tried again.

    Raises:
        HouseholdError: If one cannot be read; one line that names the file.
    """
    found = {path: _version(path) for path in paths}
    new = [path for path, version in found.items() if version not in _READ_WELL]
    if new:
        _try(*new)
        _READ_WELL.update(filter(None, found.values()))


def _version(path: Path | str) -> Version | None:
    """Of a file; None if there is none."""
    try:
        place = Path(path).absolute()
        now = place.stat()
    except (OSError, ValueError):
        return None
    return str(place), now.st_mtime_ns, now.st_size


def _try(*paths: Path | str) -> None:
    command = [sys.executable, "-c", _READ, *map(str, paths)]
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=WITHIN, check=False
        )
    except (OSError, ValueError, subprocess.TimeoutExpired) as error:
        reason = " ".join(str(error).split()).replace(str(paths[0]), "it")
        raise HouseholdError(f"{shown_path(paths[0])}: {shown_path(reason)}") from None
    if done.returncode == 0:
        return
    if done.returncode == 1 and done.stderr:
        raise HouseholdError(done.stderr.splitlines()[-1])
    last = paths[max(len(done.stdout.splitlines()), 1) - 1]
    raise HouseholdError(f"{shown_path(last)}: damaged; Rerun cannot read it")

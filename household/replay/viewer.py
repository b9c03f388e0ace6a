"""Replays on screen: which one, and in the Rerun viewer."""

import tempfile
from collections.abc import Callable
from pathlib import Path
from urllib.parse import quote

from household.config.toml import is_file
from household.errors import HouseholdError, shown_path
from household.replay.process import LOOPBACK, free_ports, start_viewer
from household.replay.serving import moment_of, served


def recordings(path: Path | str) -> tuple[Path, ...]:
    """All replay files at or below a path, sorted.

    Raises:
        HouseholdError: If there are none.
    """
    path = Path(path)
    found = (path,) if is_file(path) else tuple(sorted(path.rglob("*.rrd")))
    if not found:
        raise HouseholdError(f"{shown_path(path)}: no replay file (.rrd) there")
    return found


def choose(
    path: Path | str,
    ask: Callable[[str], str] = input,
    show: Callable[[str], None] = print,
) -> Path:
    """The replay at a path, or the one that a person chooses below it.

    Args:
        path: A file, or a directory such as a study's.
        ask: Asks the person with a text and returns the answer.
        show: Shows a line of text.

    Raises:
        HouseholdError: If there is none, or the answer is not one of the numbers.
    """
    found = recordings(path)
    if len(found) == 1:
        return found[0]
    for number, file in enumerate(found, start=1):
        show(f"{number:4d}  {file.relative_to(path)}")
    try:
        answer = ask(f"Which one (1 to {len(found)})? ").strip()
    except (EOFError, OSError, RuntimeError):  # Nobody is there to answer.
        answer = ""
    numbered = {str(number): file for number, file in enumerate(found, start=1)}
    if answer not in numbered:
        raise HouseholdError(
            f"{shown_path(path)} holds {len(found)} replays; name one of them, or a "
            f"number from 1 to {len(found)}"
        )
    return numbered[answer]


def view_two(
    one: Path | str,
    other: Path | str,
    *,
    web: bool = False,
    at: int | None = None,
    show: Callable[[str], None] = print,
) -> None:
    """Opens two replays of the same home side by side; says where they part.

    Args:
        one: The file that is shown on the left.
        other: The one on the right.
        web: As for `view`.
        at: Decision at which to open them; None: where they part.
        show: Shows a line of text.

    Raises:
        HouseholdError: As `view`, or if they are of different homes.
    """
    from household.replay.comparison import join

    with tempfile.TemporaryDirectory(prefix="household_") as folder:
        both = Path(folder) / "two_runs.rrd"
        parted = join(Path(one), Path(other), both)
        if parted is None:
            show("They are equal, moment by moment, as long as both last.")
        else:
            show(f"{str(parted).capitalize()} (decision {parted.decision}).")
            at = parted.decision if at is None else at
        _open(both, web=web, at=at, show=show)


def view(
    path: Path | str,
    *,
    web: bool = False,
    at: int | None = None,
    show: Callable[[str], None] = print,
) -> None:
    """Opens a replay in the viewer and waits until that is closed.

    Args:
        path: The file.
        at: The decision to open it at; None: its beginning.
        web: Serves the viewer to a browser on this machine; Ctrl-C ends it.
        show: Shows a line of text, such as the page to open.

    Raises:
        HouseholdError: If the file is no replay or the viewer does not run.
    """
    _open(Path(path), web=web, at=at, show=show)


def _open(
    path: Path, *, web: bool, at: int | None, show: Callable[[str], None]
) -> None:
    page, data = free_ports(2)
    with served(path) as replay:
        link = replay if at is None else replay + moment_of(at)
        arguments = [f"--port={data}", link]
        if web:
            arguments[1:] = ["--serve-web", f"--web-viewer-port={page}"]
            source = quote(link, safe="")
            show(f"Open http://{LOOPBACK}:{page}/?url={source} (Ctrl-C ends it)")
        with start_viewer(*arguments) as process:
            try:
                status = process.wait()
            except KeyboardInterrupt:
                process.terminate()
                return
    if status:
        raise HouseholdError(
            f"the Rerun viewer ended with status {status}; on a machine without a "
            "screen or graphics driver, use the web viewer"
        )

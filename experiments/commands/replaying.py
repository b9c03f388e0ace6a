"""`household replay`."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Annotated

from tyro.conf import Positional, arg


@dataclass(frozen=True, kw_only=True)
class Replay:
    """Open a recorded episode in the Rerun viewer, or draw or film it."""

    path: Annotated[Positional[Path], arg(metavar="FILE.rrd|DIR")]
    """A recording, or a directory; asks which one if there are several below it."""

    other: Annotated[Positional[Path | None], arg(metavar="FILE.rrd|DIR")] = None
    """Another recording of the same home and seed, to show beside the first one."""

    at: Annotated[int | None, arg(metavar="DECISION")] = None
    """Open it at this moment, or draw this one; else a page opens at a touch."""

    find: Annotated[str | None, arg(metavar="WORDS")] = None
    """List the events that say this, such as "tap by father" or "wrong credit", and
    open the replay at the first of them (with --at: at the first one since then)."""

    web: bool = False
    """Show it in a browser on this machine, where there is no screen for the viewer."""

    picture: Annotated[Path | None, arg(metavar="FILE.svg|.pdf|.png")] = None
    """Draw a moment instead of opening the viewer."""

    video: Annotated[Path | None, arg(metavar="FILE.mp4|.gif")] = None
    """Make a film instead of opening the viewer."""

    page: Annotated[Path | None, arg(metavar="FILE.html")] = None
    """Make a page that shows it in any browser, without installation; with --video it
    has the film for browsers that cannot."""

    speed: Annotated[float | None, arg(metavar="TIMES")] = None
    """How many times as fast as it was a film goes; else it lasts 20 s to 60 s."""

    size: Annotated[str | None, arg(metavar="WIDTHxHEIGHT")] = None
    """Of pictures and films, in pixels, such as 1280x720."""

    def run(self) -> None:
        """Makes what was asked for, or shows the replay until the viewer is closed."""
        from household.replay.page import write_page
        from household.replay.rendering import FILMS, PICTURES, write_picture
        from household.replay.viewer import choose, view, view_two
        from household.view.figure import SIZE

        _check_file("--video", self.video, FILMS)
        _check_file("--picture", self.picture, PICTURES)
        _check_file("--page", self.page, (".html",))
        _check_speed(self.speed)
        size = None if self.size is None else _size(self.size)
        path = choose(self.path)
        if self.other is not None:
            view_two(path, choose(self.other), web=self.web, at=self.at)
            return
        at = self.at if self.find is None else _found(path, self.find, self.at)
        if self.video:
            _film(path, self.video, size, self.speed)
        if self.picture:
            write_picture(path, self.picture, at, size or SIZE)
        if self.page:
            write_page(path, self.page, film=self.video, at=at)
        if not (self.video or self.picture or self.page):
            view(path, web=self.web, at=at)


def _found(path: Path, words: str, since: int | None) -> int:
    """Lists the events that say some words; returns when the first one is."""
    from household.replay.finding import find

    events = find(path, words)
    for event in events:
        print(f"{event.decision:7d}  {event.kind:8}  {event.text}")
    later = [event.decision for event in events if event.decision >= (since or 0)]
    return later[0] if later else events[-1].decision


def _check_file(option: str, file: Path | None, endings: tuple[str, ...]) -> None:
    """Refuses a file that could not be written as what it is called."""
    from experiments.errors import ExperimentError

    if file is None:
        return
    if file.suffix.lower() not in endings:
        allowed = " or ".join(endings)
        raise ExperimentError(f"{option} {file}: the name must end in {allowed}.")
    if not file.parent.is_dir():
        raise ExperimentError(f"{option} {file}: {file.parent} is not a directory.")


def _check_speed(speed: float | None) -> None:
    from experiments.errors import ExperimentError

    if speed is not None and not 0.1 <= speed <= 1000.0:
        raise ExperimentError(f"--speed {speed:g}: allowed: 0.1 to 1000.")


def _size(text: str) -> tuple[int, int]:
    """Width and height; both even, as films need it."""
    from experiments.errors import ExperimentError

    numbers = re.fullmatch(r"(\d{2,5})x(\d{2,5})", text)
    width, height = map(int, numbers.groups()) if numbers else (0, 0)
    if not (200 <= width <= 8000 and 150 <= height <= 8000):
        raise ExperimentError(
            f"--size {text}: allowed: WIDTHxHEIGHT, such as 1280x720, from 200x150 to "
            "8000x8000."
        )
    return width + width % 2, height + height % 2


def _film(
    path: Path, out: Path, size: tuple[int, int] | None, speed: float | None
) -> None:
    from rich.progress import track

    from household.replay.rendering import write_film

    progress = partial(track, description="Making the film")
    write_film(path, out, size, speed, progress)

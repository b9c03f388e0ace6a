"""`household replay`."""

from __future__ import annotations

import re
from dataclasses import dataclass
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

    web: bool = False
    """Show it in a browser on this machine, where there is no screen for the viewer."""

    picture: Annotated[Path | None, arg(metavar="FILE.svg|.pdf|.png")] = None
    """Draw a moment instead of opening the viewer."""

    at: Annotated[float | None, arg(metavar="SECONDS")] = None
    """Which moment to draw; the last unless said otherwise."""

    video: Annotated[Path | None, arg(metavar="FILE.mp4|.gif")] = None
    """Make a film instead of opening the viewer."""

    speed: Annotated[float | None, arg(metavar="TIMES")] = None
    """How many times as fast as it was a film goes; else it lasts 20 s to 60 s."""

    size: Annotated[str | None, arg(metavar="WIDTHxHEIGHT")] = None
    """Of pictures and films, in pixels, such as 1280x720."""

    def run(self) -> None:
        """Makes what was asked for, or shows the replay until the viewer is closed."""
        from household.replay.rendering import FILMS, PICTURES, write_picture
        from household.replay.viewer import choose, view, view_two
        from household.view.figure import SIZE

        _check_file("--video", self.video, FILMS)
        _check_file("--picture", self.picture, PICTURES)
        _check_speed(self.speed)
        size = None if self.size is None else _size(self.size)
        path = choose(self.path)
        if self.other is not None:
            view_two(path, choose(self.other), web=self.web)
            return
        if self.video:
            _film(path, self.video, size, self.speed)
        if self.picture:
            write_picture(path, self.picture, self.at, size or SIZE)
        if not (self.video or self.picture):
            view(path, web=self.web)


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

    def tracked(replay):  # type: ignore[no-untyped-def] # noqa: ANN001, ANN202
        return track(replay, "Making the film")

    write_film(path, out, size, speed, tracked)

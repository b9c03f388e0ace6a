"""`household replay`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from tyro.conf import Positional, arg


@dataclass(frozen=True, kw_only=True)
class Replay:
    """Open a recorded episode in the Rerun viewer."""

    path: Annotated[Positional[Path], arg(metavar="FILE.rrd|DIR")]
    """A recording, or a directory; asks which one if there are several below it."""

    at: Annotated[int | None, arg(metavar="DECISION")] = None
    """Open it at this moment, or draw this one."""

    find: Annotated[str | None, arg(metavar="WORDS")] = None
    """List the events that say this, such as "tap by father" or "wrong credit", and
    open the replay at the first of them (with --at: at the first one since then)."""

    web: bool = False
    """Show it in a browser on this machine, where there is no screen for the viewer."""

    video: Annotated[Path | None, arg(metavar="FILE.mp4")] = None
    """Make a film instead of opening the viewer."""

    png: Annotated[Path | None, arg(metavar="FILE.png")] = None
    """Draw a moment, without --at the last one, instead of opening the viewer."""

    def run(self) -> None:
        """Makes what was asked for, or shows the replay until the viewer is closed."""
        from household.replay.viewer import choose, view, write_png

        _check_file("--video", self.video, ".mp4")
        _check_file("--png", self.png, ".png")
        path = choose(self.path)
        at = self.at if self.find is None else _found(path, self.find, self.at)
        if self.video:
            _film(path, self.video)
        if self.png:
            write_png(path, self.png, at)
        if not (self.video or self.png):
            view(path, web=self.web, at=at)


def _found(path: Path, words: str, since: int | None) -> int:
    """Lists the events that say some words; returns when the first one is."""
    from household.replay.finding import find
    from household.replay.probing import check_readable

    check_readable(path)
    events = find(path, words)
    for event in events:
        print(f"{event.decision:7d}  {event.kind:8}  {event.text}")
    later = [event.decision for event in events if event.decision >= (since or 0)]
    return later[0] if later else events[-1].decision


def _check_file(option: str, file: Path | None, suffix: str) -> None:
    """Refuses a file that could not be written as what it is called."""
    from experiments.errors import ExperimentError

    if file is None:
        return
    if file.suffix.lower() != suffix:
        raise ExperimentError(f"{option} {file}: the name must end in {suffix}.")
    if not file.parent.is_dir():
        raise ExperimentError(f"{option} {file}: {file.parent} is not a directory.")


def _film(path: Path, out: Path) -> None:
    from rich.progress import track

    from household.replay.viewer import write_video

    write_video(path, out, track=lambda replay: track(replay, "Making the film"))

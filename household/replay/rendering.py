"""Rendering: a replay as a picture, as a film, or as a GIF, without a viewer."""

from collections.abc import Callable, Iterable
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from household.errors import HouseholdError, shown_path
from household.replay.reading import Replay, read_replay
from household.simulation.snapshot import Snapshot
from household.view import figure, film
from household.view.painter import SHOWN

if TYPE_CHECKING:
    from numpy.typing import NDArray

PICTURES, FILMS = (".png", ".svg", ".pdf"), (".mp4", ".gif")
"""Endings of what can be written."""

SMALL = (640, 360)
"""Width and height of a GIF, unless asked for otherwise [pixels]."""

GIF_FPS = 8.0
"""Most frames in a second of a GIF, whose frames are large."""

Track = Callable[[Replay], Iterable[Snapshot]]
"""Goes through the moments of a replay, for example to show progress."""


def can_film() -> bool:
    """Whether the extra ``render``, which films need, is installed."""
    return all(find_spec(name) for name in ("imageio_ffmpeg", "pygame"))


def write_picture(
    path: Path | str,
    out: Path | str,
    at: int | None = None,
    size: tuple[int, int] = figure.SIZE,
) -> None:
    """Draws a moment of a replay.

    Args:
        path: The replay.
        out: The picture to write; its ending, one of `PICTURES`, says in which format.
        at: The decision after which the moment is; None: the last.
        size: Width and height [pixels].

    Raises:
        HouseholdError: If there is no such moment, or it cannot be written.
    """
    replay = read_replay(path)
    index = len(replay) - 1 if at is None else at
    if not 0 <= index < len(replay):
        raise HouseholdError(
            f"{shown_path(path)}: no decision {index}; allowed: 0 to {len(replay) - 1}"
        )
    # Recent touches are still seen in the picture.
    before = round(SHOWN / replay.scenario.decision_period)
    shown = [replay.snapshot(i) for i in range(max(0, index - before), index + 1)]
    figure.save(replay.scenario, shown, out, size)


def write_film(
    path: Path | str,
    out: Path | str,
    size: tuple[int, int] | None = None,
    speed: float | None = None,
    track: Track = iter,
    fps: float | None = None,
) -> None:
    """Makes a film of a replay.

    Args:
        path: The replay.
        out: The film to write; its ending, one of `FILMS`, says in which format.
        size: Width and height [pixels]; None: as usual for that format.
        speed: Seconds of the episode in one of the film; None: so that the film lasts
            20 s to 60 s.
        track: Goes through the moments.
        fps: The most frames in a second; None: as usual for that format.

    Raises:
        HouseholdError: If the extra ``render`` is missing.
    """
    replay, gif = read_replay(path), Path(out).suffix.lower() == ".gif"
    size = size or (SMALL if gif else film.SIZE)
    most = fps or (GIF_FPS if gif else film.MOST_FPS)
    period = replay.scenario.decision_period
    pace = film.pace_of(len(replay), period, speed, most)
    painter = film.FilmPainter(replay.scenario, size)
    frames = painter.frames(track(replay), pace.every)
    (_write_gif if gif else _write_mp4)(str(out), frames, size, pace.fps)


def _write_mp4(
    out: str, frames: Iterable["NDArray[Any]"], size: tuple[int, int], fps: float
) -> None:
    try:
        from imageio_ffmpeg import write_frames
    except ImportError:
        raise HouseholdError(
            "films need imageio-ffmpeg: pip install 'polite-household[render]'"
        ) from None
    # A film of flat colors gets hardly larger; ffmpeg takes two thirds of the time.
    quick = ["-preset", "veryfast"]
    writer = write_frames(out, size, fps=fps, macro_block_size=2, output_params=quick)
    writer.send(None)
    try:
        for frame in frames:
            writer.send(frame)
    finally:
        writer.close()


def _write_gif(
    out: str, frames: Iterable["NDArray[Any]"], size: tuple[int, int], fps: float
) -> None:
    from PIL import Image

    pictures = (Image.fromarray(frame) for frame in frames)
    first = next(pictures).quantize(64)
    # One palette for all: what did not change is then left out of a frame.
    others = [
        picture.quantize(palette=first, dither=Image.Dither.NONE)
        for picture in pictures
    ]
    first.save(out, save_all=True, append_images=others, duration=1e3 / fps, loop=0)

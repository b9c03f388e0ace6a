"""Replays on screen: in the Rerun viewer, as a film, or as a picture."""

from collections.abc import Callable, Iterable
from pathlib import Path
from urllib.parse import quote

from household.config.toml import is_file
from household.errors import HouseholdError, shown_path
from household.replay.probing import check_readable
from household.replay.process import LOOPBACK, free_ports, start_viewer
from household.replay.reading import Replay, read_replay
from household.replay.serving import moment_of, served
from household.simulation.snapshot import Snapshot
from household.view.painter import SHOWN, SIZE, Painter, load_pygame

FPS = 8
"""Decisions in a second of film: 8 times real time if a decision takes 1 s."""


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
    check_readable(path)
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


def write_png(path: Path | str, out: Path | str, decision: int | None = None) -> None:
    """Draws a moment of a replay, without a viewer.

    Args:
        path: The replay.
        out: The picture to write.
        decision: Which moment; None: the last.

    Raises:
        HouseholdError: If there is no such moment, or the extra ``render`` is missing.
    """
    check_readable(path)
    replay = read_replay(path)
    last = int(replay.moments.decision[-1])
    chosen = last if decision is None else decision
    if not 0 <= chosen <= last:
        raise HouseholdError(f"{path}: no decision {chosen}; allowed: 0 to {last}")
    painter = Painter(replay.scenario)
    # Recent touches are still seen in the picture.
    before = round(SHOWN / replay.scenario.decision_period)
    for index in range(max(0, chosen - before), chosen):
        painter.remember(replay.snapshot(index))
    picture = painter.paint(replay.snapshot(chosen))
    load_pygame().image.save(picture, str(out))


def write_video(
    path: Path | str,
    out: Path | str,
    fps: int = FPS,
    track: Callable[[Replay], Iterable[Snapshot]] = iter,
) -> None:
    """Makes a film of a replay, without a viewer.

    Args:
        path: The replay.
        out: The film to write, ends in .mp4.
        fps: Decisions in a second.
        track: Goes through the moments, for example to show progress.

    Raises:
        HouseholdError: If the extra ``render`` is missing.
    """
    check_readable(path)
    replay = read_replay(path)
    try:
        from imageio_ffmpeg import write_frames
    except ImportError:
        raise HouseholdError(
            "films need imageio-ffmpeg: pip install 'polite-household[render]'"
        ) from None
    painter = Painter(replay.scenario)
    film = write_frames(str(out), SIZE, fps=fps)
    film.send(None)
    try:
        for moment in track(replay):
            film.send(painter.pixels(moment))
    finally:
        film.close()

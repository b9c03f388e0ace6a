"""A replay as a page: any browser opens it, without installation, server or network."""

import base64
import html
from pathlib import Path
from string import Template
from urllib.parse import quote

from household.errors import HouseholdError, shown_path
from household.replay.finding import first_touch
from household.replay.probing import check_readable
from household.replay.web_viewer import LOADER, MEGABYTES, PROGRAM, place_viewer

_TEMPLATE = Path(__file__).with_name("page.html")


def write_page(
    path: Path | str,
    out: Path | str,
    title: str = "",
    film: Path | str | None = None,
    at: int | None = None,
) -> None:
    """Writes a page that shows a replay in the web viewer of the installed Rerun.

    The viewer is put beside the page, in a folder that pages share; the recording is in
    the page itself.

    Args:
        path: The replay.
        out: The page to write, an `.html` file.
        title: What it is called; empty: as the file.
        film: What is shown where the browser cannot run the viewer, or the screen is
            small: a film beside or below the page.
        at: The decision that it shows first; None: that of the first touch.

    Raises:
        HouseholdError: If the file is no replay, or the page cannot be written.
    """
    check_readable(path)
    path, out = Path(path), Path(out)
    at = first_touch(path) if at is None else at
    try:
        viewer = place_viewer(out.parent)
        shown = None if film is None else Path(film).relative_to(out.parent).as_posix()
        text = _filled(path, title or path.stem, viewer.name, shown, at)
        unfinished = out.with_name(f".{out.name}.tmp")
        unfinished.write_text(text, "utf-8")
        unfinished.replace(out)  # so that it is whole as soon as it has its name
    except OSError as error:
        raise HouseholdError(
            f"{shown_path(out)}: cannot be written ({error.strerror or error})"
        ) from error


def _filled(path: Path, title: str, viewer: str, film: str | None, at: int) -> str:
    template = Template(_TEMPLATE.read_text("utf-8"))
    return template.substitute(
        title=html.escape(title),
        film=_video(film),
        decision=at,
        command=html.escape(f"household replay {path.name}"),
        loader=f"{viewer}/{LOADER}",
        program=f"{viewer}/{PROGRAM}",
        version=viewer.removeprefix("viewer_"),
        megabytes=MEGABYTES,
        recording=base64.b64encode(path.read_bytes()).decode(),
    )


def _video(film: str | None) -> str:
    if film is None:
        return ""
    source = quote(film)
    return f'<video controls playsinline preload="metadata" src="{source}"></video>'

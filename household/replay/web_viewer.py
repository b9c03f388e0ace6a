"""Rerun's web viewer as files that a page opens without a server.

The viewer is that of the installed Rerun, which recorded; its version is in the name of
the folder, so the two stay together. A page that is opened from a disk may not fetch
files, but it may load scripts: so the program is written as a script, too.
"""

import base64
import gzip
import tempfile
import time
from http.client import HTTPConnection
from pathlib import Path

from household.errors import HouseholdError
from household.replay.process import (
    LOOPBACK,
    OPENS_WITHIN,
    free_ports,
    listens,
    start_viewer,
)

LOADER, PROGRAM = "re_viewer.js", "re_viewer_wasm.js"
"""The scripts: what starts the program, and the program, which sets `VARIABLE`."""

VARIABLE = "rerunViewer"
"""Of the page: the program, as WebAssembly, zipped, in base 64."""

MEGABYTES = 19
"""What both scripts take."""


def viewer_version() -> str:
    """Version of the installed Rerun, as "0.41.0"."""
    from rerun import __version__

    return str(__version__)


def recorded_by(path: Path) -> str:
    """Version of the Rerun that recorded a file, as "0.41.0"."""
    with path.open("rb") as file:
        header = file.read(8)
    return ".".join(str(part) for part in header[4:7])


def place_viewer(folder: Path) -> Path:
    """Puts the web viewer below a folder, unless it is there.

    Args:
        folder: Of the pages.

    Returns:
        The viewer's own folder.

    Raises:
        HouseholdError: If Rerun does not give its viewer away.
    """
    place = folder / f"viewer_{viewer_version()}"
    if not place.exists():
        with tempfile.TemporaryDirectory(
            dir=folder, prefix=".viewer", suffix=".tmp"
        ) as made:
            written = Path(made) / "viewer"
            written.mkdir()
            _write(written)
            try:
                written.rename(place)
            except OSError:  # another process was faster
                if not place.exists():
                    raise
    return place


def _write(folder: Path) -> None:
    loader, program = _served((f"/{LOADER}", "/re_viewer_bg.wasm"))
    packed = base64.b64encode(gzip.compress(program, 6, mtime=0)).decode()
    (folder / LOADER).write_bytes(loader)
    (folder / PROGRAM).write_text(f'window.{VARIABLE} = "{packed}";\n')


def _served(names: tuple[str, ...]) -> list[bytes]:
    """Files of the web viewer, as the installed Rerun serves them on this machine."""
    page, data = free_ports(2)
    arguments = (f"--port={data}", "--serve-web", f"--web-viewer-port={page}")
    with start_viewer(*arguments, quiet=True) as process:
        try:
            end = time.monotonic() + OPENS_WITHIN
            while not listens(page):
                if process.poll() is not None or time.monotonic() > end:
                    raise HouseholdError("Rerun does not serve its web viewer")
                time.sleep(0.05)
            return [_fetched(page, name) for name in names]
        finally:
            process.kill()


def _fetched(port: int, name: str) -> bytes:
    connection = HTTPConnection(LOOPBACK, port, timeout=OPENS_WITHIN)
    try:
        connection.request("GET", name)
        response = connection.getresponse()
        content = response.read()
    finally:
        connection.close()
    if response.status != 200:
        raise HouseholdError(f"Rerun's web viewer lacks {name}")
    return content

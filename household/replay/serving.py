"""Serving: a replay to viewers, which fetch only what they show, and links to moments.

Rerun's own server of recordings knows links that open at a moment; the address of a
file does not. The ids in a link are made anew each time that a replay is served.
"""

import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from household.errors import HouseholdError, shown_path
from household.replay.blueprint import blueprint
from household.replay.process import (
    LOOPBACK,
    OPENS_WITHIN,
    free_ports,
    listens,
    start_server,
)
from household.replay.reading import read_replay

if TYPE_CHECKING:
    import rerun.blueprint as rrb
    from rerun_bindings import DatasetEntryInternal


@contextmanager
def served(path: Path | str) -> Iterator[str]:
    """Serves a replay on this machine for as long as the context lasts.

    Args:
        path: The file.

    Yields:
        Its address; with `moment_of` behind it, that of a moment.

    Raises:
        HouseholdError: If it cannot be read or served.
    """
    replay = read_replay(path)
    views = blueprint(replay.scenario, bool(replay.values), live=False)
    (port,) = free_ports(1)
    # In a process of its own, as it would wait for browsers to be closed; it begins in
    # an empty folder, as it takes no single file.
    with (
        tempfile.TemporaryDirectory() as folder,
        start_server(Path(folder), port) as server,
    ):
        try:
            end = time.monotonic() + OPENS_WITHIN
            while not listens(port):
                if server.poll() is not None or time.monotonic() > end:
                    raise HouseholdError(f"{shown_path(path)}: Rerun does not serve it")
                time.sleep(0.05)
            yield _address(port, Path(path), views)
        finally:
            server.kill()


def _address(port: int, path: Path, views: "rrb.Blueprint") -> str:
    """Gives a server a replay and its views; returns the address of the replay."""
    from rerun_bindings import CatalogClientInternal

    origin = f"rerun+http://{LOOPBACK}:{port}"
    # Rerun's public client of its server would need DataFusion, which is 115 MB.
    (entry,) = CatalogClientInternal(origin, None).datasets(False)
    identity, blueprints = entry.entry_details().id, entry.blueprint_dataset()
    segment = _registered(entry, path)
    assert blueprints is not None
    with tempfile.TemporaryDirectory() as folder:
        stored = Path(folder) / "views.rbl"
        views.save(str(identity), str(stored))
        entry.set_default_blueprint_segment_id(_registered(blueprints, stored))
    return f"{origin}/dataset/{identity}?segment_id={segment}"


def _registered(entry: "DatasetEntryInternal", path: Path) -> str:
    """Gives a server a file; returns what it calls it."""
    handle = entry.register(
        [path.resolve().as_uri()],
        recording_layers=["base"],
        on_duplicate="replace",
        object_store_config=None,
    )
    return str(handle.wait(None)[0])


def moment_of(decision: int) -> str:
    """What is added to the address of a served replay to open it at a moment."""
    return f"#when=decision@{decision}"

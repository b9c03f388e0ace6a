"""Streams: the interface to Rerun, which writes columns to a file or to a viewer.

Rerun changes between minor versions; only the modules of this folder call it.
"""

import ctypes
import shutil
import tempfile
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from household.compiled.arrays import Floats, Integers
from household.errors import HouseholdError, shown_path

if TYPE_CHECKING:
    import rerun as rr
    import rerun.blueprint as rrb

Times = tuple[Integers, Floats]
"""When something happened: decisions, and the same in seconds."""


WAITS, ATTEMPTS = 2.0, 60
"""How long to wait at a stretch for a file to be written [s], and how often."""

ROOM = 2**16
"""Less than this is a full disk [bytes]."""


class Stream:
    """One recording.

    Args:
        kind: Recordings of the same kind share their blueprint in the viewer.
        name: Shown as the recording's name.
        path: File to write; None: none.
        watch: Address of a viewer that shows it while it is made; None: none.
    """

    def __init__(
        self, kind: str, name: str, path: Path | None, watch: str | None = None
    ) -> None:
        import rerun as rr

        self.kind = kind
        self._recording: rr.RecordingStream | None = rr.RecordingStream(
            kind, send_properties=False
        )
        self._path, self._watched = path, watch is not None
        self._failed = False
        sinks: list[Any] = [] if watch is None else [rr.GrpcSink(watch)]
        if path is not None:
            path.parent.mkdir(parents=True, exist_ok=True)
            sinks.append(rr.FileSink(path))
        self.recording.set_sinks(*sinks)
        rr.set_log_time_enabled(False, recording=self.recording)
        self.recording.send_recording_name(name)

    @property
    def recording(self) -> "rr.RecordingStream":
        """Rerun's own stream."""
        if self._recording is None:
            raise ValueError("the recording is closed")
        return self._recording

    @property
    def is_open(self) -> bool:
        """Whether it can still be written to."""
        return self._recording is not None

    def send_blueprint(self, blueprint: bytes) -> None:
        """Writes a blueprint, as `saved_blueprint` makes it.

        It goes through a file, as Rerun's own call leaves two threads behind each time.
        """
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "blueprint.rbl"
            path.write_bytes(blueprint)
            self.recording.log_file_from_path(path)
            self.flush()

    def describe(self, scenario: str) -> None:
        """Writes the whole scenario as a property of the recording, as JSON."""
        import rerun as rr

        self.recording.send_property("household", rr.AnyValues(scenario=scenario))

    def send_static(self, entity: str, *parts: Any) -> None:  # noqa: ANN401 - archetypes
        """Writes what is the same at all times."""
        self.recording.log(entity, *parts, static=True)

    def send(
        self,
        entity: str,
        times: Times,
        columns: Iterable["rr.ComponentColumn"],
    ) -> None:
        """Writes columns.

        Args:
            entity: Path of the entity.
            times: When.
            columns: One value, or one group of values, for each of them.
        """
        import rerun as rr

        decision, time = times
        if len(decision):
            nanoseconds = np.round(time * 1e9).astype("timedelta64[ns]")
            indexes = [
                rr.TimeColumn("decision", sequence=decision),
                rr.TimeColumn("seconds", duration=nanoseconds),
            ]
            self.recording.send_columns(entity, indexes, list(columns))

    def flush(self) -> None:
        """Waits until all that was sent has arrived."""
        recording = self.recording
        self._despite_viewer(lambda: self._wait_for(recording))

    def _wait_for(self, recording: "rr.RecordingStream") -> None:
        """Flushes; where a disk is full, Rerun alone may wait forever."""
        if self._path is None or self._watched:
            recording.flush()
            return
        for attempt in reversed(range(ATTEMPTS)):
            try:
                recording.flush(timeout_sec=WAITS)
            except RuntimeError:
                self._failed = not attempt or _is_full(self._path)
                if self._failed:
                    _abandon(recording)
                    raise
            else:
                return

    def close(self) -> None:
        """Ends the recording and frees what it holds; then the file is complete."""
        import rerun_bindings

        if self._recording is not None:
            recording, self._recording = self._recording, None
            if self._failed:
                return
            self._despite_viewer(lambda: self._wait_for(recording))
            self._despite_viewer(recording.disconnect)
            del recording
            # Otherwise each closed stream would keep two threads forever.
            cleanup = rerun_bindings.flush_and_cleanup_orphaned_recordings
            self._despite_viewer(cleanup)

    def _despite_viewer(self, action: Callable[[], object]) -> None:
        """Closing the viewer ends neither the episode nor its file."""
        try:
            action()
        except RuntimeError:
            if not self._watched:
                raise HouseholdError(
                    f"{shown_path(self._path)}: cannot be written to its end; the "
                    "disk may be full"
                ) from None


def _abandon(recording: "rr.RecordingStream") -> None:
    """Leaves a recording that cannot be written to its end as it is.

    Rerun may wait forever when one is taken down whose disk is full, and at the end of
    the process. So this one is never taken down: one more reference to it is counted
    than there is, since Python clears even what its modules hold.
    """
    import rerun as rr

    ctypes.pythonapi.Py_IncRef(ctypes.py_object(recording))
    rr.unregister_shutdown()


def _is_full(path: Path) -> bool:
    """Whether the disk of a file has no room for one more message."""
    return shutil.disk_usage(path.parent).free < ROOM


def saved_blueprint(blueprint: "rrb.Blueprint", kind: str) -> bytes:
    """A blueprint for recordings of one kind, as it is stored."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "blueprint.rbl"
        blueprint.save(kind, str(path))
        return path.read_bytes()


def times_of(decisions: Iterable[int], period: float) -> Times:
    """The times of decisions.

    Args:
        decisions: Steps since the episode began.
        period: Between two of them [s].
    """
    at = np.array(list(decisions), dtype=np.int64)
    return at, np.asarray(at * period, dtype=np.float64)

"""`household replay`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from tyro.conf import Positional, arg

from experiments.errors import ExperimentError


@dataclass(frozen=True, kw_only=True)
class Replay:
    """Open recorded episodes in the Rerun viewer."""

    path: Annotated[Positional[Path], arg(metavar="FILE.rrd|DIR")]
    """A recording, or a directory with recordings in it (or in its `replays`)."""

    web: bool = False
    """Serve the viewer to a browser on this machine, where there is no screen."""

    def run(self) -> None:
        """Opens the viewer and waits until it is closed."""
        import subprocess

        arguments = ["--bind", "127.0.0.1"]
        if self.web:
            arguments += ["--serve-web"]
        files = [str(file) for file in recordings(self.path)]
        ended = subprocess.run([str(_viewer()), *arguments, *files], check=False)
        if ended.returncode:
            raise ExperimentError(
                f"the Rerun viewer ended with status {ended.returncode}; without a "
                "screen or its drivers, try --web."
            )


def recordings(path: Path) -> tuple[Path, ...]:
    """Returns the recordings that a path stands for.

    Raises:
        ExperimentError: If there are none.
    """
    if path.is_file():
        return (path,)
    found = [*sorted(path.glob("*.rrd")), *sorted(path.glob("replays/*.rrd"))]
    if not found:
        raise ExperimentError(f"{path}: no recording (.rrd) there.")
    return tuple(found)


def _viewer() -> Path:
    """Returns the viewer itself; the script of that name would outlive its end."""
    import rerun_cli

    binary = Path(rerun_cli.__file__).with_name("rerun")
    return binary if binary.exists() else binary.with_suffix(".exe")

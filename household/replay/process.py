"""The viewer as a process of its own."""

import os
import socket
import subprocess
import time
from pathlib import Path

from household.errors import HouseholdError

LOOPBACK = "127.0.0.1"
"""Viewers accept connections from this machine only; Rerun's default is from any."""

PORT = 9876
"""Rerun's default, on which a viewer that a person has opened listens."""


OPENS_WITHIN, SETTLES = 20.0, 1.0
"""How long a viewer may take to open, and to notice that it has no screen [s]."""


def address(port: int) -> str:
    """The address at which a viewer on this machine accepts recordings."""
    return f"rerun+http://{LOOPBACK}:{port}/proxy"


def open_viewer() -> str:
    """Returns the address of an open viewer, and opens one if there is none.

    Raises:
        HouseholdError: If no viewer opens, as on a machine without a screen.
    """
    if not listens(PORT):
        process = start_viewer(f"--port={PORT}", detached=True, quiet=True)
        _wait_for(process)
    return address(PORT)


def listens(port: int) -> bool:
    """Whether something on this machine accepts connections at a port."""
    with socket.socket() as probe:
        return probe.connect_ex((LOOPBACK, port)) == 0


def _wait_for(process: "subprocess.Popen[bytes]") -> None:
    """Waits until a viewer accepts recordings; one without a screen ends at once."""
    end = time.monotonic() + OPENS_WITHIN
    while process.poll() is None and time.monotonic() < end:
        if listens(PORT):
            time.sleep(SETTLES)  # It listens before it looks for a screen.
            break
        time.sleep(0.1)
    if process.poll() is not None or not listens(PORT):
        process.terminate()
        raise HouseholdError(
            "the Rerun viewer did not open; on a machine without a screen record "
            "without watching, and look at it with `household replay FILE --web`"
        )


def start_viewer(
    *arguments: str, detached: bool = False, quiet: bool = False
) -> "subprocess.Popen[bytes]":
    """Starts a viewer.

    Args:
        *arguments: Arguments of the command ``rerun``.
        detached: Whether the viewer outlives this process.
        quiet: Whether to hide the viewer's messages.
    """
    command = [_binary(), "--bind", LOOPBACK, "--hide-welcome-screen", *arguments]
    return subprocess.Popen(
        command,
        env={"RUST_LOG": "warn"} | os.environ | {"RERUN_APP_ONLY": "true"},
        start_new_session=detached,
        stderr=subprocess.DEVNULL if quiet else None,
    )


def start_server(folder: Path, port: int) -> "subprocess.Popen[bytes]":
    """Starts a server of recordings, which viewers fetch piece by piece.

    Args:
        folder: Of the recordings.
        port: Where it listens, on this machine only.
    """
    where = ["--host", LOOPBACK, "--port", str(port)]
    command = [_binary(), "server", *where, "--dataset", f"replay={folder}"]
    return subprocess.Popen(
        command,
        env={"RUST_LOG": "warn"} | os.environ | {"RERUN_APP_ONLY": "true"},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )


def _binary() -> str:
    """Rerun's program.

    It is not the script of that name, since ending that would leave the viewer running.
    """
    import rerun_cli

    binary = Path(rerun_cli.__file__).with_name("rerun")
    return str(binary if binary.exists() else binary.with_suffix(".exe"))


def free_ports(count: int) -> list[int]:
    """Ports of this machine that are not in use."""
    sockets = [socket.socket() for _ in range(count)]
    try:
        for each in sockets:
            each.bind((LOOPBACK, 0))
        return [int(each.getsockname()[1]) for each in sockets]
    finally:
        for each in sockets:
            each.close()

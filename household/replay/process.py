"""The viewer as a process of its own."""

import os
import socket
import subprocess
from pathlib import Path

LOOPBACK = "127.0.0.1"
"""Viewers listen on this machine alone; Rerun's own default is everywhere."""

PORT = 9876
"""Rerun's own; a viewer that a person has open listens there."""


def address(port: int) -> str:
    """Where a viewer on this machine takes recordings."""
    return f"rerun+http://{LOOPBACK}:{port}/proxy"


def open_viewer() -> str:
    """Opens a viewer that stays, unless one is open, and returns its address."""
    with socket.socket() as probe:
        if probe.connect_ex((LOOPBACK, PORT)) != 0:
            start_viewer(f"--port={PORT}", detached=True)
    return address(PORT)


def start_viewer(*arguments: str, detached: bool = False) -> "subprocess.Popen[bytes]":
    """Starts a viewer.

    Args:
        *arguments: Of the command ``rerun``.
        detached: The viewer outlives this process.
    """
    import rerun_cli

    # Not the script of that name: ending that would leave the viewer running.
    binary = Path(rerun_cli.__file__).with_name("rerun")
    if not binary.exists():
        binary = binary.with_suffix(".exe")
    command = [str(binary), "--bind", LOOPBACK, "--hide-welcome-screen", *arguments]
    return subprocess.Popen(
        command,
        env={"RUST_LOG": "warn"} | os.environ | {"RERUN_APP_ONLY": "true"},
        start_new_session=detached,
    )


def free_ports(count: int) -> list[int]:
    """Ports of this machine that nobody listens on."""
    sockets = [socket.socket() for _ in range(count)]
    try:
        for each in sockets:
            each.bind((LOOPBACK, 0))
        return [int(each.getsockname()[1]) for each in sockets]
    finally:
        for each in sockets:
            each.close()

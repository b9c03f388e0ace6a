"""Pages that let Sphinx document the code: one for each room of a package."""

from __future__ import annotations

import pkgutil
from collections.abc import Mapping, Sequence
from importlib import import_module
from pathlib import Path

from experiments.docs_tools.pages import render
from experiments.docs_tools.site.pages import write

PACKAGES = ("household", "learners", "policies", "experiments")

LEFT_OUT = {
    "household": (
        *("arguments", "companions", "compiled", "config", "motion"),
        *("simulation", "state"),
    ),
    "experiments": (
        *("__main__", "bench", "cli", "commands", "docs_tools", "errors"),
        *("figures", "paper", "report", "running"),
    ),
}
"""Rooms that nobody calls from elsewhere; docs/architecture.md tells of them."""


def write_reference(folder: Path) -> None:
    """Writes `index.md` and a page for each room.

    Args:
        folder: Where to write.
    """
    rooms = {package: rooms_of(package) for package in PACKAGES}
    about = {room: _first_line(room) for found in rooms.values() for room in found}
    write(folder / "index.md", render("reference.md.j2", rooms=rooms, about=about))
    for found in rooms.values():
        for room, modules in found.items():
            page = render("room.md.j2", room=room, modules=modules)
            write(folder / f"{room}.md", page)


def rooms_of(package: str) -> Mapping[str, Sequence[str]]:
    """Returns the modules of each room of a package; the package is one, too."""
    rooms = {package: [package]}
    for found in pkgutil.iter_modules(import_module(package).__path__):
        if found.name not in LEFT_OUT.get(package, ()):
            room = f"{package}.{found.name}"
            rooms[room] = [room, *(_inside(room) if found.ispkg else ())]
    return rooms


def _inside(room: str) -> Sequence[str]:
    """All modules in a room, at any depth; first those of what the room exports."""
    package = import_module(room)
    names = [one.name for one in pkgutil.walk_packages(package.__path__, f"{room}.")]
    parts = [getattr(package, name) for name in getattr(package, "__all__", ())]
    exporting = {getattr(part, "__module__", "") for part in parts}
    return sorted(names, key=lambda name: name not in exporting)


def _first_line(module: str) -> str:
    """What a module is, by the first line of its docstring."""
    return (import_module(module).__doc__ or "").partition("\n")[0]

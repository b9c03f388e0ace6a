"""Everything that is held against published figures, and the file that says how."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path

import msgspec

from experiments.running.engine import Engine
from experiments.running.files import to_json, write_text
from experiments.validation import delays, kinds, moving, rimea
from experiments.validation.figures import Finding, Published, not_modeled
from experiments.validation.scenes import Scene, watch, watchings

GROUPS: Mapping[str, Sequence[Scene]] = {
    "Delays": delays.SCENES,
    "Teachers": kinds.SCENES,
    "At home": moving.SCENES,
    "Walking": rimea.SCENES,
}
"""Scenes by what they are about."""

NOT_MODELED: Mapping[str, Sequence[Published]] = {
    "Teachers": kinds.NOT_MODELED,
    "At home": moving.NOT_MODELED,
}
"""Figures that nothing in the simulation answers to, with the reason."""

Found = Mapping[str, Sequence[Finding]]
"""Findings by group."""


def how_many() -> int:
    """How often scenes are watched in all."""
    return sum(len(watchings(scenes)) for scenes in GROUPS.values())


def validate(engine: Engine, advance: Callable[[], None]) -> Found:
    """Watches every scene and holds it against what was published.

    Args:
        engine: Where to run.
        advance: Called `how_many` times.
    """
    return {
        group: [
            *watch(scenes, engine, advance),
            *map(not_modeled, NOT_MODELED.get(group, ())),
        ]
        for group, scenes in GROUPS.items()
    }


def count(found: Iterable[Finding], verdict: str) -> int:
    """How many findings have a verdict."""
    return sum(one.verdict == verdict for one in found)


def store(found: Found, out: Path) -> Path:
    """Writes findings as validation.json.

    Args:
        found: From `validate`.
        out: The directory; it is there.

    Returns:
        The file.
    """
    file = out / "validation.json"
    groups = {name: msgspec.to_builtins(list(each)) for name, each in found.items()}
    write_text(file, to_json({"format": 1, "groups": groups}))
    return file

"""The digests that are kept, and how others differ from them."""

import json
from collections.abc import Mapping
from pathlib import Path

from . import episodes, learning

PATH = Path(__file__).parent / "digests.json"
RENEW = "make golden"

Told = Mapping[str, str]
"""What -> digest, of one episode or run."""

Kept = Mapping[str, Mapping[str, Told]]
"""Kind -> name of the scenario or learner -> its digests."""

KINDS = {
    "episodes": (tuple(episodes.HOMES), episodes.episode),
    "learners": (learning.RUNS, learning.run),
}
"""Kind -> the names there are, and what works out the digests of one."""

NAMES = [(kind, name) for kind, (names, _) in KINDS.items() for name in names]


def computed() -> Kept:
    """All digests, worked out anew."""
    return {
        kind: {name: work_out(name) for name in names}
        for kind, (names, work_out) in KINDS.items()
    }


def read() -> Kept:
    """The digests that are kept."""
    return json.loads(PATH.read_text(encoding="utf-8"))


def write(digests: Kept) -> None:
    """Keeps digests, in an order in which two versions compare well."""
    text = json.dumps(digests, indent=2, sort_keys=True)
    PATH.write_text(text + "\n", encoding="utf-8")


def changed(before: Told, now: Told) -> list[str]:
    """What of one episode or run is no longer what it was, or new, or gone."""
    return sorted(what for what in {*before, *now} if before.get(what) != now.get(what))


def report(before: Kept, now: Kept) -> list[str]:
    """A line for each episode and run that is no longer what it was."""
    lines = []
    for kind in sorted({*before, *now}):
        old, new = before.get(kind, {}), now.get(kind, {})
        for name in sorted({*old, *new}):
            what = changed(old.get(name, {}), new.get(name, {}))
            lines += [f"{kind}: {name}: {', '.join(what)}"] if what else []
    return lines

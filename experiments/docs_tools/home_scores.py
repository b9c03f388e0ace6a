"""Reference scores in the shipped scenarios, for the pages of the homes.

    python -m experiments.docs_tools.home_scores docs/scores/scenarios.json

scores the references in every shipped scenario and stores what came of it; `make docs`
writes the tables. Scenarios that are named after the file are scored alone, and the
others stay as they are stored.
"""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from experiments.analysis.statistics import Estimate, mean

SEEDS = tuple(range(5))
"""Each has a probe set and lived episodes of its own."""

STEPS = 900
"""Of the lived episodes at most."""

REFERENCES = ("random", "best constant", "population", "persona", "lookahead")

Stored = Mapping[str, Any]
"""Of one scenario: a list with a value for each seed, by measure and policy."""


@dataclass(frozen=True, kw_only=True)
class Row:
    """What one reference comes to in a scenario."""

    policy: str
    probe: Estimate | None
    """None where the policy has no probe score, or no moment makes a difference."""

    per_minute: float
    """Verdicts in a robot's minute of its own episodes."""

    lived: float
    """Where that is between random (0) and lookahead (1); NaN if those are equal."""


def scored(scenario: str, seed: int) -> Stored:
    """Scores the references in a scenario.

    Args:
        scenario: Its name.
        seed: Of the probe set and the episodes.

    Returns:
        Numbers by measure (``probe``, None where there is none, and ``per_minute``) and
        policy.
    """
    from experiments.scoring.households import score_references
    from household import household_v0

    scores = score_references(household_v0.parallel_env(scenario), seed, STEPS)
    return {
        "probe": {
            name: None if math.isnan(each.probe_greedy) else each.probe_greedy
            for name, each in scores.items()
        },
        "per_minute": {name: each.lived.per_minute for name, each in scores.items()},
    }


def rows(stored: Sequence[Stored]) -> Iterator[Row]:
    """Yields a row for each reference.

    Args:
        stored: From `scored`, one of each seed.
    """
    lived = {
        name: float(np.mean([one["per_minute"][name] for one in stored]))
        for name in stored[0]["per_minute"]
    }
    floor, ceiling = lived["random"], lived["lookahead"]
    for called in REFERENCES:
        name = _best_constant(stored) if called == "best constant" else called
        probes = [one["probe"][name] for one in stored]
        known = [probe for probe in probes if probe is not None]
        spread = ceiling - floor
        yield Row(
            policy=name.replace("constant:", "always "),
            probe=mean(known) if known else None,
            per_minute=lived[name],
            lived=(lived[name] - floor) / spread if spread else math.nan,
        )


def _best_constant(stored: Sequence[Stored]) -> str:
    """The constant behavior with the highest probe score, else the best lived one."""

    def merit(name: str) -> tuple[float, float]:
        probes = [one["probe"][name] for one in stored]
        known = [probe for probe in probes if probe is not None]
        lived = float(np.mean([one["per_minute"][name] for one in stored]))
        return (float(np.mean(known)) if known else 0.0, lived)

    names = [name for name in stored[0]["probe"] if name.startswith("constant:")]
    return max(names, key=merit)


def main(out: Path, names: Sequence[str]) -> None:
    """Scores scenarios and stores the scores.

    Args:
        out: A JSON file.
        names: The scenarios; none: all that are shipped.
    """
    from household.config.toml import shipped

    stored: dict[str, Any] = {}
    if names and out.exists():
        stored = json.loads(out.read_text("utf-8"))
    out.parent.mkdir(parents=True, exist_ok=True)
    for name in names or shipped("scenario"):
        stored[name] = [scored(name, seed) for seed in SEEDS]
        ordered = {key: stored[key] for key in sorted(stored)}
        out.write_text(json.dumps(ordered, indent=1) + "\n", "utf-8")
        print(f"{name}: {len(SEEDS)} seeds", flush=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2:])

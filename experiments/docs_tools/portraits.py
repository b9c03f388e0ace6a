"""Portraits of the shipped personas: how often each answers a bout with a touch.

Run as `python -m experiments.docs_tools.portraits docs/people.md`, which renews the
table on that page.
"""

from __future__ import annotations

import re
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from household.config.toml import shipped
from household.environment import Household
from household.people.mind import Intentions, Minds, Percepts
from household.scenario.scenario import PersonSpec, RobotSpec, Scenario
from policies.people import make_minds

HOURS, SEEDS = 1, 3
"""Each persona is watched for this long with each of the first seeds."""

PLURAL = {"caress": "caresses", "tap": "taps"}

HEADER = (
    "| persona | pleased | caresses | annoyed | taps | caresses per pleasing bout | "
    "taps per annoying bout |"
)


class CountingMinds(Minds):
    """Counts what a person thinks of the robot; decides as its mind does."""

    def __init__(self, scenario: Scenario, counts: Counter[str]) -> None:
        self._minds = make_minds(scenario)
        self._counts = counts

    def reset(self, rngs: Sequence[np.random.Generator]) -> Intentions:
        """As the person's mind does."""
        return self._minds.reset(rngs)

    def decide(self, percepts: Percepts) -> Intentions:
        """As the person's mind does; counts the bouts that it judges."""
        found = percepts.appraisals
        for value in found.value[found.new]:
            self._counts["pleased" if value > 0.0 else "annoyed"] += 1
        return self._minds.decide(percepts)


def watch(persona: str, seed: int) -> Counter[str]:
    """Watches one person with a robot that acts at random.

    Args:
        persona: Name of a shipped persona.
        seed: Of the episode and of the robot.

    Returns:
        How often the person was pleased and annoyed by a bout, and how often it
        caressed and tapped.
    """
    counts: Counter[str] = Counter()
    env = Household(_at_home(persona), lambda scenario: CountingMinds(scenario, counts))
    env.reset(seed=seed)
    rng = np.random.default_rng(seed)
    while env.agents:
        bout = env.behavior("robot_0").behavior
        over = env.behavior_over("robot_0")
        env.step({"robot_0": int(rng.integers(len(env.behaviors))) if over else bout})
        counts.update(PLURAL[touch.kind] for touch in env.feedback("robot_0"))
    return counts


def _at_home(persona: str) -> Scenario:
    """One person in the smart room, with the shipped schedule and norms."""
    return Scenario(
        name=f"portrait of {persona}",
        max_cycles=HOURS * 3600,
        behaviors=("sleep", "play", "say_hello", "bark", "vacuum", "ask"),
        heterogeneity=0.0,
        people=(PersonSpec(name="person", persona=persona),),
        robots=(RobotSpec(position=(3.8, 2.6)),),
    )


def table() -> Iterator[str]:
    """The lines of the table, in Markdown."""
    yield HEADER
    yield "| --- " + "| ---: " * (HEADER.count("|") - 2) + "|"
    for persona in shipped("persona"):
        counts = sum((watch(persona, seed) for seed in range(SEEDS)), Counter[str]())
        felt = [counts[name] for name in ("pleased", "caresses", "annoyed", "taps")]
        shares = (_share(felt[1], felt[0]), _share(felt[3], felt[2]))
        cells = (persona, *map(str, felt), *shares)
        yield f"| {' | '.join(cells)} |"


def _share(part: int, whole: int) -> str:
    return f"{part / whole:.2f}" if whole else "-"


def renew(page: Path) -> None:
    """Puts the table in the place of the one on a page.

    Raises:
        ValueError: If there is none on the page.
    """
    before = page.read_text("utf-8")
    lines = "\n".join(table()) + "\n"
    after, found = re.subn(rf"{re.escape(HEADER)}\n(?:\|.*\n)*", lines, before)
    if found != 1:
        raise ValueError(f"{page}: {found} tables of portraits, must be 1")
    page.write_text(after, "utf-8")


if __name__ == "__main__":
    renew(Path(sys.argv[1]))

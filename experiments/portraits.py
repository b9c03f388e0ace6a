"""Portraits of the shipped personas: how readily each turns what it thinks into touch.

Run as `python -m experiments.portraits`; prints the table of docs/people.md.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from household.environment import Household
from household.people.mind import Intention, Mind, Percept
from household.records import shipped
from household.scenario import PersonSpec, RobotSpec, Scenario
from policies.people import make_minds
from policies.people.giving import calls_for_feedback

if TYPE_CHECKING:
    from household.people.persona import Persona

HOURS, SEEDS = 1, 3
"""Each persona is watched for this long with each of the first seeds."""

HEADER = (
    "| persona | pleased | caresses | annoyed | taps | caresses per pleasing bout | "
    "taps per annoying bout |"
)


class Witness(Mind):
    """Counts what a person thinks and leaves its decisions as they are."""

    def __init__(self, mind: Mind, persona: Persona, counts: Counter[str]) -> None:
        self._mind = mind
        self._persona = persona
        self._counts = counts

    def reset(self, rng: np.random.Generator) -> Intention:
        """As the mind itself."""
        return self._mind.reset(rng)

    def decide(self, percept: Percept) -> Intention:
        """As the mind itself; bouts that call for no feedback are not counted."""
        for judgement in percept.judgements:
            if calls_for_feedback(self._persona, judgement):
                name = "pleased" if judgement.value > 0.0 else "annoyed"
                self._counts[name] += 1
        return self._mind.decide(percept)


def watch(persona: str, seed: int) -> Counter[str]:
    """Counts of one person with a robot that does whatever comes to its mind.

    Args:
        persona: Name of a shipped persona.
        seed: Of the episode and of the robot.

    Returns:
        How often the person was pleased and annoyed by a bout, and how often it
        caressed and tapped.
    """
    counts: Counter[str] = Counter()

    def witnessed(scenario: Scenario) -> Sequence[Mind]:
        pairs = zip(make_minds(scenario), scenario.personas, strict=True)
        return [Witness(mind, one, counts) for mind, one in pairs]

    env = Household(_at_home(persona), witnessed)
    env.reset(seed=seed)
    rng = np.random.default_rng(seed)
    while env.agents:
        bout = env.behavior("robot_0").behavior
        over = env.behavior_over("robot_0")
        env.step({"robot_0": int(rng.integers(len(env.behaviors))) if over else bout})
        kinds = {"caress": "caresses", "tap": "taps"}
        counts.update(kinds[touch.kind] for touch in env.feedback("robot_0"))
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
    for persona in shipped("people/personas"):
        counts = sum((watch(persona, seed) for seed in range(SEEDS)), Counter[str]())
        felt = [counts[name] for name in ("pleased", "caresses", "annoyed", "taps")]
        shares = (_share(felt[1], felt[0]), _share(felt[3], felt[2]))
        cells = (persona, *map(str, felt), *shares)
        yield f"| {' | '.join(cells)} |"


def _share(part: int, whole: int) -> str:
    return f"{part / whole:.2f}" if whole else "-"


if __name__ == "__main__":
    for line in table():
        print(line)

"""A lesson as in studies of people who teach robots: one person, one robot at hand.

The person watches the robot, which does one thing after another, for ten minutes. What
it does pleases or annoys, wholly or half; how often it pleases is all that differs
between robots.
"""

from __future__ import annotations

from experiments.validation.diary import Diary, live
from household.scenario.behavior import Behavior
from household.scenario.norms import Norm
from household.scenario.scenario import PersonSpec, RobotSpec, Scenario, ScriptStep

VALUES = {"great": 1.0, "fair": 0.5, "poor": -0.5, "bad": -1.0}
"""What the robot can do, and what the person thinks of it."""

GOOD, MIXED, ALWAYS_RIGHT = 0.75, 0.5, 1.0
"""Share of bouts that please (our choice: the studies do not say it)."""

DURATION = 4.0
"""Of a bout [s]; most reactions take less."""

LESSON = 600.0
"""How long it lasts [s]: about as many bouts as the people of CHARM rated."""


def lesson(persona: str, pleasing: float, seed: int) -> Diary:
    """Lives through one lesson.

    Args:
        persona: What kind of teacher.
        pleasing: Share of bouts that please, in [0, 1].
        seed: Another person and another lesson for each.
    """
    chances = [pleasing / 2] * 2 + [(1.0 - pleasing) / 2] * 2
    return live(_classroom(persona, seed), chances, seed)


def _classroom(persona: str, number: int) -> Scenario:
    behavior = Behavior(description="A lesson's", duration=DURATION, loudness=75.0)
    return Scenario(
        name="lesson",
        max_cycles=round(LESSON),
        behaviors=tuple(VALUES),
        behavior=dict.fromkeys(VALUES, behavior),
        norms={"playing": Norm(attending=VALUES, absorbed=VALUES)},
        people=(
            PersonSpec(
                name="teacher",
                persona=persona,
                number=number,
                script=(ScriptStep(place="playing", until=LESSON, look_at="robot_0"),),
            ),
        ),
        robots=(RobotSpec(position=(2.6, 2.6), heading=-90.0),),
    )

"""How people move at home: how fast they walk, and how near they come to a robot."""

from __future__ import annotations

from functools import partial

import numpy as np

from experiments.validation.delays import MEDIAN, TOUCH, home_delays
from experiments.validation.diary import Diary, live
from experiments.validation.figures import Published, around
from experiments.validation.looking import ALONE, ANGLE, MUTUAL, PEAK, TURNS, looks
from experiments.validation.scenes import Measured, Scene
from household.scenario.scenario import PersonSpec, RobotSpec, Scenario
from household.scenario.validation import load_scenario
from household.simulation.simulation import PERSON_RADIUS, ROBOT_RADIUS

WEIDMANN = "Weidmann, through the RiMEA guideline"

PACE = "In the middle of walks through an apartment; published speeds are of streets."

SPEEDS = {
    "child": Published(
        name="walking speed, under 30 years",
        unit="m/s",
        said=".58 to 1.61",
        low=0.58,
        high=1.61,
        source=WEIDMANN,
        reading=PACE,
    ),
    "easygoing": Published(
        name="walking speed, 30 to 50 years",
        unit="m/s",
        said="1.41 to 1.54",
        low=1.41,
        high=1.54,
        source=WEIDMANN,
        reading=PACE,
        because="Adults have 1.2 m/s, as a pace for indoors (our choice).",
    ),
    "elder": Published(
        name="walking speed, over 50 years",
        unit="m/s",
        said=".68 to 1.41; with limited mobility .46 to .76",
        low=0.68,
        high=1.41,
        source=WEIDMANN,
        reading=PACE,
    ),
}
"""By persona."""

APPROACH = Published(
    name="distance at which people stop before a robot",
    unit="m",
    said=".48, before a small humanoid",
    **around(0.48),
    source="a study of 40 people",
    reading="From body to body, at the touch of somebody who walked there.",
    because="A hand reaches .8 m from the middle of the body, and the walk ends at the "
    "first look, every .2 s, at which the robot is in reach.",
)

NOT_MODELED = (
    Published(
        name="reaction to a hand before it touches, distance",
        unit="m",
        said=".20",
        source="Shiomi et al.",
        reading="Robots do not see hands, and nobody touches people.",
    ),
    Published(
        name="speed of a caress",
        unit="cm/s",
        said="1 to 10",
        source="Croy et al.",
        reading="A touch is a moment with a strength.",
    ),
)


def walking_speed(diary: Diary, i: int) -> float:
    """Mean speed of a person in the middle of its walks [m/s]; NaN without any."""
    walks = diary.moved(i)
    middle = walks[1:-1] & walks[:-2] & walks[2:]
    way = np.linalg.norm(np.diff(diary.position[:, i], axis=0), axis=1)[1:-1]
    return float(way[middle].mean() / diary.period) if middle.any() else np.nan


def approaches(diary: Diary) -> list[float]:
    """Returns how near those came who walked to a robot and touched it [m].

    Returns:
        The gap between the two bodies, at the end of the period of each touch.
    """
    found = []
    for touch in diary.touches:
        moment = int(np.searchsorted(diary.time, touch.time - 1e-9))
        if not diary.moved(touch.person)[moment - 1]:
            continue
        robot = diary.people + touch.robot
        way = diary.position[moment, robot] - diary.position[moment, touch.person]
        found.append(float(np.hypot(*way)) - PERSON_RADIUS - ROBOT_RADIUS)
    return found


def stroll(persona: str, seed: int) -> Measured:
    """Watches somebody who lives alone walk about an apartment."""
    scenario = Scenario(
        name="stroll",
        home="family_apartment",
        max_cycles=4500,
        decision_period=0.2,
        behaviors=("sleep", "play"),
        people=(PersonSpec(name="walker", persona=persona),),
        robots=(RobotSpec(position=(6.0, 5.6)),),
    )
    return {SPEEDS[persona].name: walking_speed(live(scenario, (1.0, 0.0), seed), 0)}


def evening(seed: int) -> Measured:
    """Watches a family at home, with two robots that act by chance."""
    scenario = load_scenario("evening")
    n = len(scenario.behaviors)
    diary = live(scenario, [1.0 / n] * n, seed)
    near = approaches(diary)
    return {
        **looks(diary),
        **home_delays(diary),
        APPROACH.name: float(np.mean(near)) if near else np.nan,
    }


def closely(seed: int) -> Measured:
    """Watches the same family for a while, ten times a second."""
    scenario = load_scenario(
        "evening", decision_period=0.1, steering_period=0.1, max_cycles=3000
    )
    n = len(scenario.behaviors)
    return looks(live(scenario, [1.0 / n] * n, seed))


SCENES = (
    Scene(
        name="a family's evening",
        watch=evening,
        published=(MEDIAN, TOUCH, TURNS, ANGLE, ALONE, MUTUAL, APPROACH),
        seeds=12,
    ),
    Scene(
        name="a family's evening, every .1 s",
        watch=closely,
        published=(PEAK,),
        seeds=4,
    ),
    *(
        Scene(
            name=f"alone at home, {persona}",
            watch=partial(stroll, persona),
            published=(figure,),
            seeds=4,
        )
        for persona, figure in SPEEDS.items()
    ),
)

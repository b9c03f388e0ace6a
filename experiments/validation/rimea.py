"""Tests of pedestrian simulators, after the guideline of RiMEA, each in three frames.

Tests of stairs, of smoke and of whole buildings have nothing to do with homes.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from experiments.validation import walks
from experiments.validation.figures import Published
from experiments.validation.halls import FRAMES, Frame
from experiments.validation.scenes import Measured, Scene

Test = Callable[[Frame], float]
"""A test of walking; what it gives for a hall in a frame."""

GUIDELINE = "RiMEA guideline"

TESTS: tuple[tuple[Test, Published], ...] = (
    (
        walks.corridor_time,
        Published(
            name="1: time for 40 m of a corridor, at 1.33 m/s",
            unit="s",
            said="26 to 34",
            low=26.0,
            high=34.0,
            source=GUIDELINE,
            reading="One walker.",
        ),
    ),
    (
        walks.reaction_error,
        Published(
            name="5: reaction times, largest error",
            unit="s",
            said="each sets out at its time",
            low=0.0,
            high=1.0,
            source=GUIDELINE,
            reading="10 people with times from 10 to 100 s; they decide once a second.",
        ),
    ),
    (
        walks.corner_overlap,
        Published(
            name="6: round a corner, deepest into a wall",
            unit="m",
            said="no wall is crossed",
            low=0.0,
            high=0.01,
            source=GUIDELINE,
            reading="20 people; 1 cm is what the physics engine lets bodies overlap. "
            "99 if a wall was crossed or somebody did not get there.",
        ),
    ),
    (
        walks.speed_error,
        Published(
            name="7: own walking speeds, largest error",
            unit="share",
            said="speeds as they were given out",
            low=0.0,
            high=0.05,
            source=GUIDELINE,
            reading="50 people of all personas, at heterogeneity 1, in the corridor.",
        ),
    ),
    (
        walks.astray,
        Published(
            name="10: people who do not get to their own exit",
            unit="1",
            said="0 of 23",
            low=0.0,
            high=0.0,
            source=GUIDELINE,
            reading="From 12 cabins to the nearer or the farther end of the corridor.",
        ),
    ),
    (
        walks.second_jam,
        Published(
            name="12: crowd before the second door by that before the first",
            unit="ratio",
            said="the crowd is before the first door",
            low=0.0,
            high=0.5,
            source=GUIDELINE,
            reading="48 people, doors of 1 m; the most people within 2 m. No number "
            "was published; half counts. 99 if not all got through in 240 s.",
        ),
    ),
    (
        walks.detour,
        Published(
            name="14: way taken by the shortest one",
            unit="ratio",
            said="says which way is taken: here the shortest",
            low=0.95,
            high=1.05,
            source=GUIDELINE,
            reading="Two openings in a wall, then the farther one alone; the worse.",
        ),
    ),
    (
        walks.corner_time,
        Published(
            name="15: time round a corner, between inner (0) and outer (1) length",
            unit="share",
            said="between the two straight corridors",
            low=0.0,
            high=1.0,
            source=GUIDELINE,
            reading="40 people, a corridor of 4 m, until the last is past the corner.",
            because="Everybody takes the shortest way, so all queue at the inner "
            "corner; nobody swings out.",
        ),
    ),
)
"""Each with what the guideline demands."""


def _scene(frame: Frame, test: Test, published: Published) -> Scene:
    return Scene(
        name=f"test {published.name.partition(':')[0]}, {frame.name}",
        watch=partial(_once, test, frame, published.name),
        published=(published,),
        seeds=1,
    )


def _once(test: Test, frame: Frame, name: str, seed: int) -> Measured:
    """Runs a test; there is no chance in it."""
    del seed
    return {name: test(frame)}


SCENES = tuple(
    _scene(frame, test, published) for test, published in TESTS for frame in FRAMES
)

"""Scripts, schedules and minds: what was perceived -> where to be and to look."""

import itertools
import math
from functools import partial

import numpy as np
import pytest

from household import household_v0
from household.activity import Activity
from household.compiled.arrays import NOBODY
from household.people.individuals import Intention
from household.people.mind import OWN_ACTIVITY
from household.scenario.persona import Persona
from household.scenario.scenario import PersonSpec, ScriptStep, Stay
from policies.people.minds import EverydayMinds
from policies.people.routines import Routines
from policies.people.schedule import Schedule, Stop
from policies.people.script import Line, Script

NO_WISH = np.array([NOBODY])

ROBOT = 2
"""Index of the first robot where there are two people."""


def minutes(n):
    return (60.0 * n, 60.0 * n)


def played(lines, there, period=60.0):
    """Places after each period, spent in the place of the line or not."""
    routines = Routines([Script(lines, np.random.default_rng(0))])
    places = [int(routines.place[0])]
    for n, present in enumerate(there, start=1):
        routines.advance(n * period, period, np.array([present]), NO_WISH)
        places.append(int(routines.place[0]))
    return places


A, B, C = (Line(place=i, duration=minutes(2)) for i in range(3))


@pytest.mark.parametrize(
    ("lines", "there", "places"),
    [
        # Two minutes each, over and over.
        ([A, B], [True] * 6, [0, 0, 1, 1, 0, 0, 1]),
        # Time counts from arrival, and stands still while somebody is away.
        ([A, B], [False] * 3, [0, 0, 0, 0]),
        ([A, B], [True, False, False, True], [0, 0, 0, 0, 1]),
        # A line alone is played for ever.
        ([A], [True] * 5, [0] * 6),
        # "until" ends a line by the clock, whether it was reached or not.
        (
            [Line(place=0, until=120.0), Line(place=1, until=240.0)],
            [False] * 3,
            [0, 0, 1, 1],
        ),
        # After the last moment told, the last line goes on.
        (
            [Line(place=0, until=120.0), Line(place=1, until=240.0)],
            [True] * 6,
            [0, 0, 1, 1, 1, 1, 1],
        ),
        # A line whose time is over is passed over.
        (
            [A, Line(place=1, until=60.0), C],
            [True] * 4,
            [0, 0, 2, 2, 0],
        ),
        # A line that ends by the clock and one by its length.
        ([Line(place=0, until=60.0), B, C], [True] * 6, [0, 1, 1, 2, 2, 1, 1]),
    ],
)
def test_a_script_goes_from_line_to_line(lines, there, places):
    assert played(lines, there) == places


def test_a_line_looks_for_a_while_and_looks_away_for_a_while():
    line = Line(
        place=0,
        duration=minutes(10),
        look=ROBOT,
        look_for=(2.0, 2.0),
        look_away=(3.0, 3.0),
    )
    routines = Routines([Script([line], np.random.default_rng(0))])
    looks = [int(routines.look[0])]
    for second in range(1, 11):
        routines.advance(float(second), 1.0, np.array([True]), NO_WISH)
        looks.append(int(routines.look[0]))
    at, away = ROBOT, OWN_ACTIVITY
    assert looks == [at, at, away, away, away, at, at, away, away, away, at]


def test_lengths_are_drawn_anew_between_the_shortest_and_the_longest():
    lines = [Line(place=0, duration=(10.0, 20.0)), Line(place=1, duration=(1.0, 2.0))]
    routines = Routines([Script(lines, np.random.default_rng(0))])
    lengths, began, there = {0: [], 1: []}, 0.0, np.array([True])
    for tick in range(1, 200_000):
        here = int(routines.place[0])
        routines.advance(tick * 0.01, 0.01, there, NO_WISH)
        if routines.place[0] != here:
            lengths[here].append(tick * 0.01 - began)
            began = tick * 0.01
    for place, (shortest, longest) in ((0, (10.0, 20.0)), (1, (1.0, 2.0))):
        found = lengths[place]
        assert shortest - 0.02 <= min(found)
        assert max(found) <= longest + 0.02
        middle, width = (shortest + longest) / 2, longest - shortest
        error = width / math.sqrt(12 * len(found))
        assert np.mean(found) == pytest.approx(middle, abs=4 * error + 0.01)


def test_a_schedule_stays_and_goes_on_by_its_weights():
    stops = [
        Stop(5, (2.0, 2.0), (0.0, 0.75, 1.0)),
        Stop(6, (1.0, 1.0), (1.0, 1.0, 1.0)),
        Stop(7, (1.0, 1.0), (1.0, 1.0, 1.0)),
    ]
    routines = Routines([Schedule(stops, np.random.default_rng(0))])
    visited, there = [int(routines.place[0])], np.array([True])
    for second in range(12_000):
        routines.advance(float(second), 1.0, there, NO_WISH)
        visited.append(int(routines.place[0]))
    assert visited[:2] == [5, 5]
    # Three seconds a round: two at the first place, one at another.
    assert visited.count(5) == pytest.approx(8000, abs=2)
    assert visited.count(6) / 4000 == pytest.approx(0.75, abs=4 * 0.433 / 63)
    assert not any(a == b != 5 for a, b in itertools.pairwise(visited))


def test_a_schedule_waits_for_who_is_away():
    schedule = Schedule(
        [
            Stop(0, (1.0, 1.0), (0.0, 1.0)),
            Stop(1, (1.0, 1.0), (1.0, 1.0)),
        ],
        np.random.default_rng(0),
    )
    routines = Routines([schedule])
    for second in range(50):
        routines.advance(float(second), 1.0, np.array([False]), NO_WISH)
        assert routines.place.tolist() == [0]


def test_everybody_has_a_time_of_its_own():
    """One line of two minutes, one of three; who is away stays behind."""
    two, three = (
        [Line(i, minutes(n)), Line(9, minutes(n))] for i, n in ((0, 2), (1, 3))
    )
    rngs = [np.random.default_rng(i) for i in range(3)]
    lines = (two, three, two)
    routines = Routines([Script(*each) for each in zip(lines, rngs, strict=True)])
    places = []
    for n in range(1, 5):
        arrived = np.array([True, True, n > 1])
        routines.advance(60.0 * n, 60.0, arrived, np.repeat(NO_WISH, 3))
        places.append(routines.place.tolist())
    assert places == [[0, 1, 0], [9, 1, 0], [9, 9, 9], [0, 9, 9]]


@pytest.fixture
def mind(percepts):
    """Makes somebody who plays these lines and minds every fault, beside another."""

    def make(*lines, **traits):
        usual = {"sanction": 1.0, "robot_interest": 0.0, "people_interest": 0.0}
        swift = {"reflex": 0.0, "reaction": 0.0}
        persona = Persona(name="test", **(usual | swift | traits))
        routines = [partial(Script, lines)] * 2
        minds = EverydayMinds([persona] * 2, routines, 2)
        rngs = [np.random.default_rng(i) for i in range(2)]
        begins = first(minds.reset(rngs))
        return (lambda **what: first(minds.decide(percepts(**what)))), begins

    return make


def first(intentions):
    """What the first person is about to do."""
    return Intention(
        place=int(intentions.place[0]),
        look=int(intentions.look[0]),
        eyes_open=bool(intentions.eyes_open[0]),
        wish=intentions.wishes[0],
    )


def fault(robot=0):
    return (-1.0, robot, True)


def test_a_mind_begins_in_the_place_of_its_first_line(mind):
    _, begins = mind(Line(place=4, look=ROBOT))
    assert (begins.place, begins.look, begins.wish) == (4, ROBOT, None)


def test_feedback_interrupts_the_activity_and_afterwards_it_goes_on(mind):
    """Three seconds here, then there; away for ten, it is still here afterwards."""
    person, _ = mind(
        Line(place=0, duration=(3.0, 3.0)), Line(place=1, duration=(9.0, 9.0))
    )
    person()
    out = person(bouts=(fault(robot=1),))
    assert out.wish.robot == 1
    assert out.wish.kind == "tap"
    assert out.look == ROBOT + 1
    for _ in range(10):
        out = person(arrived=False)
        assert out.wish is not None
    back = person(arrived=False, touched=True)
    assert (back.place, back.wish) == (0, None)
    places = [person().place for _ in range(3)]
    assert places == [0, 1, 1]


def test_asleep_means_eyes_closed_and_only_in_bed(mind):
    person, begins = mind(Line(place=0))
    assert begins.eyes_open
    bed = {"activity": Activity.SLEEPING}
    assert not person(**bed).eyes_open
    assert person(**bed, arrived=False).eyes_open
    assert person(activity=Activity.READING).eyes_open


def test_a_noise_wakes_for_as_long_as_it_takes_to_fall_asleep(mind):
    person, _ = mind(Line(place=0), wakes_at=50.0, awake_for=3.0)
    bed = {"activity": Activity.SLEEPING}
    quiet, loud = np.zeros(4), np.array([0.0, 0.0, 0.0, 50.0])
    talk = np.array([0.0, 90.0, 49.9, 0.0])
    levels = (quiet, talk, loud, quiet, quiet, quiet, quiet)
    eyes = [person(**bed, level=level).eyes_open for level in levels]
    assert eyes == [False, False, True, True, True, False, False]


def test_a_sleeper_who_minds_a_noise_gets_up_to_tap(mind):
    person, _ = mind(Line(place=0))
    asleep = person(activity=Activity.SLEEPING)
    assert not asleep.eyes_open
    up = person(activity=Activity.SLEEPING, bouts=(fault(),))
    assert up.eyes_open
    assert up.wish is not None


def test_in_the_household_people_follow_their_script(household_of):
    """Ten seconds on the phone, then 5.8 m to the rug, and back."""
    script = (
        ScriptStep(place="phone", duration=(10.0, 10.0)),
        ScriptStep(place="rug", duration=(10.0, 10.0)),
    )
    ann = PersonSpec(name="ann", persona="paper_actor", script=script)
    env = household_v0.parallel_env(household_of(people=(ann,), norms={}))
    env.reset(seed=1)
    roles = []
    for _ in range(45):
        env.step({"robot_0": 1})
        roles.append(dict(env.situation("robot_0").plays)["ann"])
    changes = [roles[0]] + [b for a, b in itertools.pairwise(roles) if a != b]
    assert changes[:5] == ["calling", "unknown", "playing", "unknown", "calling"]
    assert 9 <= roles.index("unknown") <= 12
    assert 10 <= roles.count("playing") <= 12


def test_in_the_household_people_follow_their_schedule(household_of):
    schedule = {
        "phone": Stay(duration=(5.0, 5.0), then={"rug": 1.0}),
        "rug": Stay(duration=(5.0, 5.0), then={"phone": 1.0}),
    }
    ann = PersonSpec(name="ann", persona="paper_actor", schedule=schedule)
    env = household_v0.parallel_env(
        household_of(people=(ann,), norms={}, max_cycles=60)
    )
    env.reset(seed=1)
    roles = set()
    while env.agents:
        env.step({"robot_0": 1})
        roles.add(dict(env.situation("robot_0").plays)["ann"])
    assert roles == {"calling", "playing", "unknown"}

"""People with minds of their own, written in plain Python by whoever likes."""

import numpy as np

from household.environment import Household
from household.feedback import Cause
from household.people.individuals import Individuals, Intention, Mind
from household.people.mind import Wish
from household.scenario.scenario import PersonSpec, RobotSpec

BARK, SLEEP = 0, 1
NEAR = (RobotSpec(position=(1.7, 2.5)),)


def light_tap():
    """A wish, made anew each time."""
    return Wish(0, "tap", 0.25, Cause("robot_0", 0, 0, 0.0))


class Wisher(Mind):
    """Answers with one wish after the other, the last one for good."""

    def __init__(self, *wishes):
        self._wishes = wishes

    def reset(self, rng):
        self._left = list(self._wishes)
        return self._next()

    def decide(self, percept):
        return self._next()

    def _next(self):
        return Intention(0, wish=self._left.pop(0) if self._left[1:] else self._left[0])


class Grump(Mind):
    """Stays in the first place and taps, lightly, whoever displeases it."""

    def __init__(self):
        self.lived = []

    def reset(self, rng):
        self.lived.clear()
        self.drawn = rng.random()
        return Intention(place=0)

    def decide(self, percept):
        self.lived.append(percept)
        bad = [a for a in percept.appraisals if a.value < 0.0]
        wish = bad and Wish(bad[0].robot, "tap", 0.25, bad[0].cause)
        return Intention(place=0, look=1, wish=wish or None)


def lives(scenario, actions, *minds):
    env = Household(scenario, lambda _: Individuals(minds))
    env.reset(seed=1)
    felt = []
    for action in actions:
        env.step({"robot_0": action})
        felt.append(env.feedback("robot_0"))
    return env, felt


def test_a_mind_of_ones_own_sees_what_happens_and_touches(household_of):
    grump = Grump()
    env, felt = lives(household_of(robots=NEAR), [SLEEP, BARK, SLEEP, SLEEP], grump)
    found = [[(a.robot, a.value) for a in p.appraisals] for p in grump.lived]
    assert found[1] == [(0, -1.0)]
    assert [touch.strength for touches in felt for touch in touches] == [0.25]
    assert [p.touched for p in grump.lived] == [False, False, True, False]
    assert [p.time for p in grump.lived] == [1.0, 2.0, 3.0, 4.0]
    assert grump.lived[0].arrived
    assert env.simulation.people.look.tolist() == [1]


def test_what_a_mind_keeps_of_a_percept_is_its_own(household_of):
    """It may remember what it saw: later moments do not change it."""
    grump = Grump()
    lives(household_of(robots=NEAR), [SLEEP, BARK], grump)
    before, after = grump.lived
    assert before.level[1] < 40.0 < after.level[1]
    assert not np.shares_memory(before.sees, after.sees)


def test_each_mind_has_a_stream_and_a_percept_of_its_own(household_of):
    people = (PersonSpec(name="ann"), PersonSpec(name="bob"))
    one, other = Grump(), Grump()
    lives(household_of(people=people), [BARK], one, other)
    assert one.drawn != other.drawn
    assert one.lived[0].sees.shape == (3,)
    assert not one.lived[0].sees[0]
    assert not other.lived[0].sees[1]


def test_wishes_change_by_their_values_and_when_they_are_fulfilled(percepts):
    """An equal wish is the same, however often it is made, until it is fulfilled."""
    strong = Wish(0, "tap", 1.0, light_tap().cause)
    wished = (None, light_tap(), light_tap(), strong, strong, None, None)
    minds = Individuals([Wisher(*wished), Wisher(None)])
    changed = [minds.reset([None, None]).changed.tolist()]
    for touched in (False, False, False, True, False, False):
        perceived = percepts(2, 2, touched=[touched, False])
        changed.append(minds.decide(perceived).changed.tolist())
    first, second = zip(*changed, strict=True)
    assert first == (False, True, False, True, True, True, False)
    assert not any(second)


def test_who_begins_with_a_wish_touches_what_is_at_hand(household_of):
    _, felt = lives(
        household_of(robots=NEAR), [SLEEP] * 3, Wisher(light_tap(), None, None)
    )
    assert [len(touches) for touches in felt] == [1, 0, 0]


def test_who_goes_on_to_wish_the_same_touches_again_and_again(household_of):
    _, felt = lives(household_of(robots=NEAR), [SLEEP] * 3, Wisher(light_tap()))
    assert [len(touches) for touches in felt] == [1, 1, 1]

"""One person with a mind of its own among others who have the usual ones."""

import copy
import pickle

import numpy as np
import pytest

from household import household_v0, vector
from household.errors import HouseholdError
from household.people import Intention, Mind


class Sitter(Mind):
    """Is always in one place, looks at the father, and keeps what it perceives."""

    place = "armchair"
    look = "father"

    def reset(self, rng):
        self.drawn = rng.random()
        self.lived = 0
        return Intention(place=self.place, look=self.look)

    def decide(self, percept):
        self.lived += 1
        self.percept = percept
        return Intention(place=self.place, look=self.look)


class Sleeper(Sitter):
    place = "sleeping"


class Lost(Sitter):
    place = "armchiar"


class Lonely(Sitter):
    look = "nobody"


def sitting(**arguments):
    return household_v0.parallel_env("evening", max_cycles=60, **arguments)


def live(env, steps, behavior="sleep"):
    action = env.behaviors.index(behavior)
    observations = []
    for _ in range(steps):
        observations.append(env.step(dict.fromkeys(env.agents, action))[0])
    return observations


def places(env):
    regions = env.scenario.plan.regions
    names = env.scenario.person_names
    return {
        name: regions[place].name
        for name, place in zip(names, env.simulation.people._claimed, strict=True)
        if place >= 0
    }


def test_the_person_is_where_its_mind_says_by_name():
    env = sitting(minds={"mother": Sitter})
    env.reset(seed=1)
    live(env, 60)
    assert places(env)["mother"] == "armchair"


def test_of_an_activity_a_person_takes_its_own_place():
    env = sitting(minds={"mother": Sleeper, "father": Sleeper})
    env.reset(seed=1)
    live(env, 2)
    assert places(env)["mother"] == "mother's bed"
    assert places(env)["father"] == "father's bed"


def test_the_others_begin_as_they_would_without_it():
    usual, own = sitting(), sitting(minds={"mother": Sitter})
    usual.reset(seed=1)
    own.reset(seed=1)
    others = {name: place for name, place in places(usual).items() if name != "mother"}
    assert {name: places(own)[name] for name in others} == others


def test_a_percept_speaks_of_others_by_name():
    env = sitting(minds={"mother": Sitter})
    env.reset(seed=1)
    live(env, 3, "bark")
    mind = env.simulation.people._minds._own._minds[0]
    loudness = mind.percept.hears_how_loud("robot_0")
    assert loudness > mind.percept.hears_how_loud("father") == 0.0
    assert mind.percept.sees_who("robot_0") in (True, False)
    with pytest.raises(HouseholdError, match="did you mean 'robot_1'"):
        mind.percept.sees_who("robot1")


@pytest.mark.parametrize(
    ("minds", "complaint"),
    [
        ({"mothre": Sitter}, "did you mean 'mother'"),
        ({"mother": Lost}, "did you mean 'armchair'"),
        ({"mother": Lonely}, "unknown person or robot 'nobody'"),
    ],
)
def test_an_unknown_name_is_a_mistake_of_one_line(minds, complaint):
    with pytest.raises(HouseholdError, match=complaint):
        sitting(minds=minds).reset(seed=1)


@pytest.mark.parametrize(
    "taken", [copy.deepcopy, lambda env: pickle.loads(pickle.dumps(env))]
)
def test_a_copy_in_mid_episode_goes_on_as_the_original_does(taken):
    env = sitting(minds={"mother": Sitter})
    env.reset(seed=1)
    live(env, 20, "play")
    twin = taken(env)
    here, there = live(env, 20, "bark"), live(twin, 20, "bark")
    for ours, theirs in zip(here, there, strict=True):
        for agent, observation in ours.items():
            np.testing.assert_array_equal(observation, theirs[agent])


def test_each_of_many_homes_has_a_mind_of_its_own():
    minds = household_v0.minds_with({"mother": Sitter})
    homes = vector.make("evening", homes=2, seed=1, make_minds=minds, max_cycles=20)
    single = sitting(minds={"mother": Sitter})
    observations, _ = homes.reset()
    alone, _ = single.reset(seed=int(homes.seeds[1]))
    for _ in range(5):
        np.testing.assert_array_equal(observations[2], alone["robot_0"])
        observations = homes.step(np.zeros(4, dtype=np.int64))[0]
        alone = single.step({"robot_0": 0, "robot_1": 0})[0]
    homes.close()

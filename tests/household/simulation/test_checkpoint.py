"""Checkpoints: a household goes on from one as it did from that moment."""

import copy
import pickle
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import numpy as np
import pytest

from household.environment import Household
from household.errors import HouseholdError
from household.household_v0 import parallel_env
from household.people.individuals import Individuals, Intention
from household.people.mind import Wish
from household.scenario import PersonSpec, RobotSpec

SCENARIOS = [
    *(f"experiment_{number}" for number in range(1, 6)),
    *("evening", "party", "home_office", "sleeping_baby"),
]


class Whimsical:
    """Goes, looks and touches by chance, and remembers what it heard."""

    def __init__(self):
        self.heard, self.wish = [], None

    def reset(self, rng):
        self.rng, self.heard, self.wish = rng, [], None
        return Intention(place=0)

    def decide(self, percept):
        self.heard.append(percept.level.sum())
        if percept.touched:
            self.wish = None
        for found in percept.appraisals:
            self.wish = Wish(found.robot, "tap", abs(found.value), found.cause)
        loud = len(self.heard) > 9 and self.heard[-9] > 50.0
        return Intention(int(self.rng.integers(2)), look=int(loud), wish=self.wish)


def whimsical(scenario):
    return Individuals([Whimsical() for _ in scenario.people])


def crowd():
    """Twenty people who step on each other's feet in a studio."""
    people = tuple(PersonSpec(name=f"p{i}", persona="warm") for i in range(20))
    robots = (RobotSpec(position=(2.0, 2.0)), RobotSpec(position=(3.0, 2.0)))
    return parallel_env("party", home="studio", people=people, robots=robots)


MAKERS = {
    **{name: (lambda name=name: parallel_env(name)) for name in SCENARIOS},
    "minds of one's own": lambda: Household("evening", whimsical),
    "crowd": crowd,
}


def lived(env, seed, steps):
    """Lets a household live on, and tells all that can be seen of that."""
    rng, seen = np.random.default_rng(seed), []
    for _ in range(steps):
        actions = {a: int(rng.integers(len(env.behaviors))) for a in env.agents}
        observations, *results, infos = env.step(actions if rng.random() < 0.3 else {})
        seen.append([o.tobytes() for o in observations.values()])
        told = [list(info.values()) for info in infos.values()]
        seen += [results, [np.hstack(each).tolist() for each in told]]
        seen += [[env.feedback(agent) for agent in env.possible_agents]]
        seen.append(env.state().tobytes())
        seen.append(env.simulation.crowd.position.tobytes())
    return seen


def lived_elsewhere(name, checkpoint, seed, steps):
    env = MAKERS[name]()
    env.restore(checkpoint)
    return lived(env, seed, steps)


@pytest.mark.parametrize("name", MAKERS)
def test_a_household_goes_on_from_a_checkpoint_as_it_did(name):
    env, other = MAKERS[name](), MAKERS[name]()
    env.reset(seed=1)
    other.reset(seed=2)
    lived(other, 3, 20)
    for moment in range(4):
        lived(env, moment, 17)
        checkpoint = env.checkpoint()
        went_on = lived(env, 9, 40)
        env.restore(checkpoint)
        assert lived(env, 9, 40) == went_on
        other.restore(pickle.loads(pickle.dumps(checkpoint)))
        assert lived(other, 9, 40) == went_on
    env.reset()
    other.reset()
    assert lived(env, 9, 20) == lived(other, 9, 20)


def test_taking_a_checkpoint_changes_nothing():
    env, undisturbed = parallel_env("party"), parallel_env("party")
    env.reset(seed=1)
    undisturbed.reset(seed=1)
    for moment in range(50):
        env.checkpoint()
        assert lived(env, moment, 3) == lived(undisturbed, moment, 3)


def test_a_household_goes_on_in_another_process():
    names = ["party", "crowd"]
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        for name in names:
            env = MAKERS[name]()
            env.reset(seed=1)
            lived(env, 1, 30)
            elsewhere = pool.submit(lived_elsewhere, name, env.checkpoint(), 2, 60)
            assert lived(env, 2, 60) == elsewhere.result()


@pytest.mark.parametrize(
    "copied", [copy.deepcopy, lambda env: pickle.loads(pickle.dumps(env))]
)
def test_a_copy_of_a_household_lives_on_by_itself(copied):
    env = parallel_env("evening")
    copied(env).reset(seed=1)
    env.reset(seed=1)
    lived(env, 1, 50)
    twin = copied(env)
    assert twin.decision == 50
    went_on = lived(env, 2, 50)
    assert lived(twin, 2, 50) == went_on
    env.reset(seed=1)
    assert env.decision == 0
    assert twin.decision == 100


def test_a_checkpoint_fits_only_its_scenario():
    env, other = parallel_env("evening"), parallel_env("evening", heterogeneity=0.5)
    with pytest.raises(HouseholdError, match="reset"):
        env.checkpoint()
    env.reset(seed=1)
    with pytest.raises(HouseholdError, match="another scenario"):
        other.restore(env.checkpoint())


def test_minds_that_do_not_pickle_are_named_as_the_reason():
    class Secretive(Whimsical):
        """Of a class that pickle cannot find."""

    env = Household("evening", lambda s: Individuals([Secretive() for _ in s.people]))
    env.reset(seed=1)
    with pytest.raises(HouseholdError, match="minds cannot be pickled"):
        env.checkpoint()

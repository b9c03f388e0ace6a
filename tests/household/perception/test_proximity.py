"""Who is near a robot and who would hear it, past walls, and without flicker."""

import numpy as np
import pytest

from household import household_v0
from household.scenario.persona import Persona
from household.scenario.scenario import (
    PersonSpec,
    RobotSpec,
    ScriptStep,
    SituationModel,
)

BOTH = SituationModel(near=2.0, hears=75.0)
WALL = ((4.0, 1.0, 4.0, 4.0),)


@pytest.fixture
def facing_robot(household_of, room):
    """Ann stands at the phone, (1, 2.5); a robot stands somewhere."""

    def make(x, walls=(), model=BOTH, **options):
        scenario = household_of(
            home=room(walls=walls),
            situation=model,
            robots=(RobotSpec(position=(x, 2.5)),),
            **options,
        )
        env = household_v0.parallel_env(scenario)
        env.reset(seed=1)
        return env

    return make


@pytest.mark.parametrize(("x", "near"), [(2.5, True), (3.5, False)])
def test_who_is_within_the_distance_is_near(facing_robot, x, near):
    pairs = facing_robot(x).situation("robot_0").near
    assert pairs == ({("ann", "robot_0")} if near else set())


def test_behind_a_wall_nobody_is_near(facing_robot):
    wall = ((1.6, 1.0, 1.6, 4.0),)
    assert facing_robot(2.2).situation("robot_0").near
    assert not facing_robot(2.2, wall).situation("robot_0").near


def test_a_wall_takes_hearing_away_where_distance_does_not(facing_robot):
    assert facing_robot(6.0).situation("robot_0").hears == {("ann", "robot_0")}
    assert not facing_robot(6.0, WALL).situation("robot_0").hears


@pytest.mark.parametrize(("loudness", "hears"), [(75.0, True), (45.0, False)])
def test_a_quiet_sound_is_not_heard_from_afar(facing_robot, loudness, hears):
    env = facing_robot(6.0, model=SituationModel(hears=loudness))
    assert bool(env.situation("robot_0").hears) == hears


def test_by_default_situations_say_neither(facing_robot):
    situation = facing_robot(2.0, model=SituationModel()).situation("robot_0")
    assert situation.near == situation.hears == frozenset()


def test_at_the_border_nobody_flickers(facing_robot):
    """The robot is moved back and forth; she stays, whatever she thinks."""
    still = Persona(name="still", praise=0.0, sanction=0.0)
    on_the_phone = ScriptStep(place="phone", duration=(900.0, 900.0))
    ann = PersonSpec(name="ann", persona=still, script=(on_the_phone,))
    env = facing_robot(2.9, people=(ann,))
    body, seen = env.simulation.crowd.position[-1], []
    for x in (2.9, 3.1, 2.9, 3.1, 3.6, 3.1):
        body[0] = x
        env.step({"robot_0": env.behaviors.index("sleep")})
        seen.append(bool(env.situation("robot_0").near))
    assert seen == [True, True, True, True, False, False]


def test_each_robot_has_its_own(household_of):
    scenario = household_of(
        situation=BOTH,
        robots=(RobotSpec(position=(2.0, 2.5)), RobotSpec(position=(7.0, 4.0))),
    )
    env = household_v0.parallel_env(scenario)
    env.reset(seed=1)
    assert env.situation("robot_0").near == {("ann", "robot_0")}
    assert env.situation("robot_1").near == frozenset()


def test_features_and_situation_observations_carry_the_same(facing_robot):
    env = facing_robot(2.0)
    observation = env.reset(seed=1)[0]["robot_0"]
    layout = household_v0_layout(env)
    assert observation[layout["person_near"]].tolist() == [1.0]
    assert observation[layout["person_hears"]].tolist() == [1.0]
    other = household_v0.parallel_env(env.scenario, observation="situation")
    situation = other.reset(seed=1)[0]["robot_0"]
    assert situation["near"].tolist() == situation["hears"].tolist() == [1]
    assert other.observation_space("robot_0").contains(situation)
    plain = household_v0.parallel_env(env.scenario, situation=SituationModel())
    assert "person_near" not in household_v0_layout(plain)


def household_v0_layout(env):
    from household.observation import layout

    return layout(env.scenario)


def test_the_relations_go_along_in_checkpoints(household_of):
    script = tuple(
        ScriptStep(place=place, duration=(5.0, 5.0)) for place in ("phone", "rug")
    )
    scenario = household_of(
        situation=BOTH,
        people=(PersonSpec(name="ann", script=script),),
        robots=(RobotSpec(position=(2.0, 2.5)),),
    )
    env = household_v0.parallel_env(scenario)
    env.reset(seed=2)
    checkpoint = env.checkpoint()

    def lived():
        seen = []
        for _ in range(40):
            env.step({})
            seen.append(env.situation("robot_0"))
        return seen

    first = lived()
    env.restore(checkpoint)
    assert lived() == first
    assert len({situation.near for situation in first}) == 2


def test_the_canonical_form_tells_who_is_near_apart(facing_robot):
    from household.perception.situation import Situation

    roles = {"ann": "reading", "bob": "reading"}
    one = Situation.of(roles, near=[("ann", "robot_0")])
    other = Situation.of(roles, near=[("bob", "robot_0")])
    both = Situation.of(roles, near=[("ann", "robot_0"), ("bob", "robot_0")])
    assert one.canonical() == other.canonical() != both.canonical()
    assert one.without("ann").near == frozenset()
    assert one.swapped("ann", "bob") == other
    assert "ann near robot_0" in str(one)
    assert np.array_equal(one.relations("ann"), (False, True, False))

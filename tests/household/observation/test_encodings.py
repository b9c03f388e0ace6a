"""Observations: where each element stands, what it means, and that it moves."""

import math

import numpy as np
import pytest

from household import household_v0
from household.activity import Activity
from household.config.toml import shipped
from household.observation.encodings import Features, fields, layout
from household.observation.kernel import DISTANCE_SCALE, View
from household.scenario.scenario import PersonSpec, RobotSpec, ScriptStep
from household.scenario.validation import load_scenario

# One flag for each slot, 1 where somebody is and 0 in padding: all that stands still.
FLAGS = ("person_here", "robot_here")


def person(name, place="phone", **changes):
    step = ScriptStep(place=place, duration=(900.0, 900.0), **changes)
    return PersonSpec(name=name, persona="paper_actor", script=(step,))


@pytest.fixture
def two_and_two(household_of):
    """Ann on the phone, Bob on the rug; a robot before Ann and one in a corner."""
    return household_of(
        people=(person("ann", look_at="robot_0"), person("bob", "rug")),
        robots=(
            RobotSpec(position=(3.0, 2.5)),
            RobotSpec(position=(7.0, 4.0), heading=90.0),
        ),
        norms={},
    )


def fields_of(env, observation):
    return {name: observation[part] for name, part in layout(env.scenario).items()}


def test_the_layout_covers_every_element_once(shipped_scenario):
    scenario = load_scenario(shipped_scenario)
    (n,) = household_v0.parallel_env(scenario).observation_space("robot_0").shape
    covered = [i for part in layout(scenario).values() for i in range(n)[part]]
    assert covered == list(range(n))


def test_every_element_is_finite_and_has_bounds_that_differ(shipped_scenario):
    space = household_v0.parallel_env(shipped_scenario).observation_space("robot_0")
    assert np.isfinite(space.low).all()
    assert np.isfinite(space.high).all()
    assert (space.low < space.high).all()


@pytest.fixture
def three_and_three(household_of):
    """Three people and three robots, in slots for five and four."""
    return household_of(
        people=(person("ann"), person("bob", "rug"), person("cat")),
        robots=tuple(RobotSpec(position=(3.0 + i, 2.5)) for i in range(3)),
        norms={},
        slots={"people": 5, "robots": 4},
    )


def random_view(rng, n_people=3, n_robots=3):
    """A moment in which no two numbers are alike."""
    n = n_people + n_robots
    return View(
        position=rng.uniform(-8.0, 8.0, (n, 2)),
        facing=rng.uniform(-1.0, 1.0, (n, n)),
        attends=rng.random((n, n)) < 0.5,
        attention=rng.random((n, n)),
        walking=rng.random(n) < 0.5,
        activity=rng.integers(len(Activity), size=n_people),
        mood=rng.uniform(-1.0, 1.0, (n_robots, n_people)),
        behavior=rng.integers(-1, 2, size=n_robots),
        left=rng.random(n_robots),
        touches=rng.random((n_robots, 2)),
        near=rng.random((n_people, n_robots)) < 0.5,
        hears=rng.random((n_people, n_robots)) < 0.5,
    )


def expected(view, robot):
    """What the table's fields should hold, slot by slot, without compiled code."""
    n = len(view.activity)
    me, others = n + robot, [j for j in range(3) if j != robot]
    offset = np.clip((view.position - view.position[me]) / DISTANCE_SCALE, -1.0, 1.0)
    # Index -1, of a robot that does nothing, takes the row without a one.
    behaviors = np.eye(3, 2)[view.behavior]
    return {
        "own_behavior": behaviors[robot],
        "own_time_left": view.left[robot],
        "own_touches": view.touches[robot],
        "person_here": np.ones(n),
        "person_offset": offset[:n],
        "person_activity": np.eye(len(Activity))[view.activity],
        "person_walks": view.walking[:n],
        "person_attends": view.attends[:n, me],
        "person_attention": view.attention[:n, me],
        "person_faces": view.facing[:n, me],
        "person_mood": view.mood[robot],
        "person_near": view.near[:, robot],
        "person_hears": view.hears[:, robot],
        "robot_here": np.ones(2),
        "robot_offset": offset[[n + j for j in others]],
        "robot_behavior": behaviors[others],
    }


@pytest.mark.parametrize("seed", range(5))
def test_every_field_stands_where_the_table_says_and_padding_is_zero(
    three_and_three, seed
):
    situation = {"near": 2.0, "hears": 75.0}
    scenario = load_scenario(three_and_three, situation=situation)
    encoding, view = Features(scenario), random_view(np.random.default_rng(seed))
    rows = encoding.encode(view)
    names = [field.name for field in fields(len(scenario.behaviors))]
    for robot, row in enumerate(rows):
        values = expected(view, robot)
        assert list(values) == names
        assert encoding.space.contains(row)
        for name, part in encoding.layout.items():
            there = np.ravel(values[name]).astype(np.float32)
            np.testing.assert_allclose(row[part][: there.size], there, rtol=1e-6)
            assert not row[part][there.size :].any()


def test_encoding_a_moment_again_makes_new_arrays_and_leaves_it_alone(three_and_three):
    encoding = Features(load_scenario(three_and_three))
    view = random_view(np.random.default_rng(1))
    before = [np.copy(part) for part in view]
    first, second = encoding.encode(view), encoding.encode(view)
    assert not np.shares_memory(first, second)
    np.testing.assert_array_equal(first, second)
    for part, copy in zip(view, before, strict=True):
        assert not np.shares_memory(first, part)
        np.testing.assert_array_equal(part, copy)


def test_the_first_observation_is_as_worked_by_hand(two_and_two):
    env = household_v0.parallel_env(two_and_two)
    observations, _ = env.reset(seed=1)
    seen = fields_of(env, observations["robot_0"])
    assert seen["own_behavior"].tolist() == [0.0, 0.0]
    assert seen["own_time_left"].tolist() == [0.0]
    assert seen["own_touches"].tolist() == [0.0, 0.0]
    assert seen["person_here"].tolist() == [1.0, 1.0]
    # Ann is 2 m to the west, Bob 4 m to the east and 1.5 m to the south, in tens.
    np.testing.assert_allclose(
        seen["person_offset"], [-0.2, 0.0, 0.4, -0.15], atol=1e-6
    )
    roles = seen["person_activity"].reshape(2, len(Activity))
    assert roles.argmax(axis=1).tolist() == [Activity.CALLING, Activity.PLAYING]
    assert roles.sum(axis=1).tolist() == [1.0, 1.0]
    assert seen["person_walks"].tolist() == [0.0, 0.0]
    assert seen["person_attends"].tolist() == [1.0, 0.0]
    # The robot counts 1 / (1 + 4 / 9); Bob and the other robot, 14 degrees off and
    # 6.2 m away, 0.171 each; 0.3 are held back.
    aside = math.exp(-0.5 * (math.atan2(1.5, 6.0) / math.radians(30.0)) ** 2) / 5.25
    assert aside == pytest.approx(0.171, abs=5e-4)
    share = (9 / 13) / (0.3 + 9 / 13 + 2 * aside)
    assert seen["person_attention"][0] == pytest.approx(share, abs=1e-6)
    assert seen["person_faces"][0] == pytest.approx(1.0)
    # Bob looks south at his rug's edge; the robot is at 4 m west, 1.5 m north.
    assert seen["person_faces"][1] == pytest.approx(
        -1.5 / math.hypot(4.0, 1.5), abs=1e-6
    )
    assert seen["robot_here"].tolist() == [1.0]
    np.testing.assert_allclose(seen["robot_offset"], [0.4, 0.15], atol=1e-6)
    assert seen["robot_behavior"].tolist() == [0.0, 0.0]


def test_what_the_robots_do_is_observed_by_themselves_and_by_the_others(two_and_two):
    env = household_v0.parallel_env(two_and_two)
    env.reset(seed=1)
    observations, *_ = env.step({"robot_0": 1, "robot_1": 0})
    own, other = (fields_of(env, observations[f"robot_{i}"]) for i in (0, 1))
    assert own["own_behavior"].tolist() == [0.0, 1.0]
    assert own["robot_behavior"].tolist() == [1.0, 0.0]
    assert other["own_behavior"].tolist() == [1.0, 0.0]
    assert other["robot_behavior"].tolist() == [0.0, 1.0]
    # After one second 7 of 8 s of sleep are left, and 1 of 2 s of barking.
    assert own["own_time_left"].tolist() == [0.875]
    assert other["own_time_left"].tolist() == [0.5]


def test_each_robot_observes_from_where_it_is(two_and_two):
    env = household_v0.parallel_env(two_and_two)
    observations, _ = env.reset(seed=1)
    offsets = [fields_of(env, o)["robot_offset"] for o in observations.values()]
    np.testing.assert_array_equal(offsets[0], -offsets[1])


def test_padding_is_zero_and_what_is_there_stays_the_same(two_and_two):
    plain = household_v0.parallel_env(two_and_two)
    padded = household_v0.parallel_env(two_and_two, slots={"people": 5, "robots": 4})
    for env in (plain, padded):
        env.reset(seed=1)
    for _ in range(5):
        actions = {"robot_0": 1, "robot_1": 0}
        (one, *_), (other, *_) = plain.step(actions), padded.step(actions)
        for agent in one:
            tight, wide = fields_of(plain, one[agent]), fields_of(padded, other[agent])
            assert list(tight) == list(wide)
            for name, values in tight.items():
                n = len(values)
                np.testing.assert_array_equal(wide[name][:n], values)
                assert not wide[name][n:].any()
    assert fields_of(padded, other["robot_0"])["person_here"].tolist() == [
        1,
        1,
        0,
        0,
        0,
    ]
    assert fields_of(padded, other["robot_0"])["robot_here"].tolist() == [1, 0, 0]


def test_scenarios_with_the_same_slots_and_behaviors_share_their_spaces(
    two_and_two, household_of
):
    slots = {"people": 6, "robots": 3}
    one, other = (
        household_v0.parallel_env(scenario, slots=slots)
        for scenario in (two_and_two, household_of())
    )
    assert one.observation_space("robot_0") == other.observation_space("robot_0")


def test_the_state_is_all_observations_one_after_the_other(two_and_two):
    env = household_v0.parallel_env(two_and_two)
    observations, _ = env.reset(seed=1)
    joined = np.concatenate([observations[agent] for agent in env.possible_agents])
    np.testing.assert_array_equal(env.state(), joined)


def test_the_situation_encoding_tells_roles_and_looks(two_and_two):
    env = household_v0.parallel_env(two_and_two, "situation", slots={"people": 4})
    observations, _ = env.reset(seed=1)
    unknown = int(Activity.UNKNOWN)
    roles = [int(Activity.CALLING), int(Activity.PLAYING), unknown, unknown]
    assert observations["robot_0"]["activities"].tolist() == roles
    assert observations["robot_1"]["activities"].tolist() == roles
    assert observations["robot_0"]["attention"].tolist() == [1, 0, 0, 0]
    assert observations["robot_1"]["attention"].tolist() == [0, 0, 0, 0]


def test_both_encodings_tell_the_same_story(two_and_two):
    features, situation = (
        household_v0.parallel_env(two_and_two, name)
        for name in ("features", "situation")
    )
    rich, _ = features.reset(seed=3)
    plain, _ = situation.reset(seed=3)
    for _ in range(20):
        for agent in rich:
            seen = fields_of(features, rich[agent])
            roles = seen["person_activity"].reshape(2, -1).argmax(axis=1)
            assert roles.tolist() == plain[agent]["activities"].tolist()
            looks = seen["person_attends"].astype(int).tolist()
            assert looks == plain[agent]["attention"].tolist()
        rich, *_ = features.step({"robot_0": 0, "robot_1": 1})
        plain, *_ = situation.step({"robot_0": 0, "robot_1": 1})


def test_64_people_and_16_robots_fit(household_of, room):
    people = tuple(person(f"p{i}", ("phone", "rug")[i % 2]) for i in range(64))
    robots = tuple(
        RobotSpec(position=(2.0 + 0.6 * (i % 8), 14.0 + 0.6 * (i // 8)))
        for i in range(16)
    )
    env = household_v0.parallel_env(
        household_of(home=room(size=(16.0, 16.0)), people=people, robots=robots)
    )
    observations, _ = env.reset(seed=1)
    for _ in range(3):
        assert len(observations) == 16
        for agent, seen in observations.items():
            assert env.observation_space(agent).contains(seen)
        observations, *_ = env.step(dict.fromkeys(env.agents, 0))


@pytest.fixture(scope="module")
def travelled():
    """For each field, which elements of a slot moved in some shipped scenario."""
    moved: dict[str, np.ndarray] = {}
    for name in shipped("scenario"):
        env = household_v0.parallel_env(name, max_cycles=900)
        people, robots = len(env.scenario.people), len(env.scenario.robots)
        rng = np.random.default_rng(1)
        observations, _ = env.reset(seed=1)
        low, high = np.copy(observations["robot_0"]), np.copy(observations["robot_0"])
        while env.agents:
            actions = {a: int(rng.integers(len(env.behaviors))) for a in env.agents}
            observations, *_ = env.step(actions)
            np.minimum(low, observations["robot_0"], out=low)
            np.maximum(high, observations["robot_0"], out=high)
        for field, part in layout(env.scenario).items():
            kind = field.partition("_")[0]
            slots = {"own": 1, "person": people, "robot": robots - 1}[kind]
            moves = (high > low)[part].reshape(slots, -1) if slots else None
            if moves is not None:
                size = max(moves.shape[1], len(moved.get(field, ())))
                union = np.zeros(size, dtype=bool)
                union[: len(moved.get(field, ()))] |= moved.get(field, union[:0])
                union[: moves.shape[1]] |= moves.any(axis=0)
                moved[field] = union
    return moved


def test_every_element_moves_in_some_shipped_scenario(travelled):
    still = {
        field: np.flatnonzero(~moves).tolist()
        for field, moves in travelled.items()
        if field not in FLAGS and not moves.all()
    }
    assert still == {}

"""What training libraries demand of an environment, for every shipped scenario."""

import pickle
import subprocess
import sys

import numpy as np
import pettingzoo
import pytest
from gymnasium import spaces
from pettingzoo import ParallelEnv
from pettingzoo.test import (
    api_test,
    max_cycles_test,
    parallel_api_test,
    parallel_seed_test,
    seed_test,
)
from pettingzoo.test.state_test import state_test

from household import household_v0
from household.config.toml import shipped
from household.errors import HouseholdError

INFOS = {
    "caresses": int,
    "taps": int,
    "behavior_over": bool,
    "attended": bool,
    "action_mask": np.ndarray,
}
CYCLES = 12

# A dictionary is neither an array nor a box; PettingZoo says so, and it is meant.
ABOUT_DICTIONARIES = (
    "ignore:Observation is not a NumPy array",
    "ignore:Observation space .*probably should be",
)
pytestmark = [
    pytest.mark.filterwarnings("error"),
    *(pytest.mark.filterwarnings(text) for text in ABOUT_DICTIONARIES),
]


@pytest.fixture(scope="module", params=["features", "situation"])
def encoding(request):
    return request.param


@pytest.fixture
def make(shipped_scenario, encoding):
    def parallel_env(max_cycles: int = CYCLES) -> ParallelEnv:
        return household_v0.parallel_env(
            shipped_scenario, encoding, max_cycles=max_cycles
        )

    return parallel_env


@pytest.fixture
def make_aec(shipped_scenario, encoding):
    def env(max_cycles: int = CYCLES):
        return household_v0.env(shipped_scenario, encoding, max_cycles=max_cycles)

    return env


def arrays(observation):
    values = observation.values() if isinstance(observation, dict) else [observation]
    return list(values)


def exact(observation, space) -> bool:
    """Whether an observation is in its space, in exactly its types and shapes."""
    parts = space.spaces if isinstance(space, spaces.Dict) else {"": space}
    values = observation if isinstance(observation, dict) else {"": observation}
    return list(parts) == list(values) and all(
        values[name].dtype == part.dtype
        and values[name].shape == part.shape
        and part.contains(values[name])
        for name, part in parts.items()
    )


def test_the_parallel_api_test_passes(make):
    parallel_api_test(make(), num_cycles=2 * CYCLES)


def test_the_api_test_passes(make_aec):
    api_test(make_aec(), num_cycles=2 * CYCLES)


def test_the_seed_tests_pass(make, make_aec):
    seed_test(make_aec, num_cycles=2 * CYCLES)
    parallel_seed_test(make, num_cycles=2 * CYCLES)


def test_the_state_test_passes(make, make_aec):
    state_test(make_aec(), make(), num_cycles=2 * CYCLES)


def test_the_max_cycles_test_passes(shipped_scenario, encoding):
    class Module:
        @staticmethod
        def parallel_env(max_cycles):
            return household_v0.parallel_env(
                shipped_scenario, encoding, max_cycles=max_cycles
            )

        @staticmethod
        def env(max_cycles):
            return household_v0.env(shipped_scenario, encoding, max_cycles=max_cycles)

    max_cycles_test(Module)


def test_the_module_itself_passes_the_max_cycles_test():
    max_cycles_test(household_v0)


def test_what_clients_read_of_an_environment_is_there_before_the_first_reset(make):
    env = make()
    n = len(env.possible_agents)
    assert env.possible_agents == [f"robot_{i}" for i in range(n)]
    assert env.metadata["name"] == "household_v0"
    assert env.metadata["is_parallelizable"] is True
    assert isinstance(env.metadata["render_modes"], list)
    assert env.metadata["render_fps"] > 0
    assert env.render_mode is None
    assert env.unwrapped is env


def test_spaces_are_the_same_objects_at_each_call_and_equal_for_all_robots(make):
    env = make()
    first = env.possible_agents[0]
    for agent in env.possible_agents:
        assert env.observation_space(agent) is env.observation_space(agent)
        assert env.action_space(agent) is env.action_space(agent)
        assert env.observation_space(agent) == env.observation_space(first)
        assert env.action_space(agent) == spaces.Discrete(len(env.behaviors))


def test_the_state_is_a_flat_float32_vector_in_its_space_even_after_the_end(make):
    env = make()
    assert isinstance(env.state_space, spaces.Box)
    assert env.state_space.dtype == np.float32
    assert len(env.state_space.shape) == 1
    env.reset(seed=1)
    for _ in range(CYCLES):
        assert exact(env.state(), env.state_space)
        env.step(dict.fromkeys(env.agents, 0))
    assert env.agents == []
    assert exact(env.state(), env.state_space)


def test_infos_are_numbers_and_arrays_of_one_size_from_the_reset_on(make):
    env = make()
    observations, infos = env.reset(seed=1)
    assert list(observations) == env.possible_agents
    for _ in range(CYCLES):
        assert list(infos) == env.possible_agents
        for agent, info in infos.items():
            assert {name: type(value) for name, value in info.items()} == INFOS
            assert info["action_mask"].shape == (len(env.behaviors),)
            assert info["action_mask"].dtype == np.int8
            assert info["behavior_over"] is env.behavior_over(agent)
            assert info["attended"] is env.attended(agent)
            touches = env.feedback(agent)
            assert info["caresses"] == sum(t.kind == "caress" for t in touches)
            assert info["taps"] == sum(t.kind == "tap" for t in touches)
        *_, infos = env.step(dict.fromkeys(env.agents, 0))


def test_a_choice_is_due_when_a_behavior_is_over_and_else_it_goes_on_or_is_broken_off():
    env = household_v0.parallel_env("evening")
    _, infos = env.reset(seed=1)
    play, hello = map(env.behaviors.index, ("play", "say_hello"))
    every = [1] * len(env.behaviors)
    assert infos["robot_0"]["action_mask"].tolist() == every
    env.step({"robot_0": play})
    began = env.behavior("robot_0")
    *_, infos = env.step({"robot_0": play})
    assert env.behavior("robot_0") == began
    assert np.flatnonzero(infos["robot_0"]["action_mask"]).tolist() == [play]
    env.step({})
    assert env.behavior("robot_0") == began
    env.step({"robot_0": hello})
    assert env.behavior("robot_0").behavior == hello
    while not infos["robot_0"]["behavior_over"]:
        *_, infos = env.step({"robot_0": hello})
    assert env.behavior("robot_0").began == 3.0
    assert infos["robot_0"]["action_mask"].tolist() == every
    env.step({"robot_0": hello})
    assert env.behavior("robot_0").began == env.time - 1.0


def test_each_robot_draws_actions_of_its_own_from_the_same_seed():
    drawn = []
    for _ in range(2):
        env = household_v0.parallel_env("evening")
        one, other = (env.action_space(agent) for agent in env.possible_agents)
        assert one is not other
        assert one == other == spaces.Discrete(len(env.behaviors))
        for space in (one, other):
            space.seed(7)
        drawn.append([[int(s.sample()) for _ in range(20)] for s in (one, other)])
    assert drawn[0] == drawn[1]
    assert drawn[0][0] != drawn[0][1]
    plain = spaces.Discrete(len(env.behaviors), seed=7)
    assert drawn[0][0] == [int(plain.sample()) for _ in range(20)]
    again = pickle.loads(pickle.dumps(other))
    assert [again.sample() for _ in range(9)] == [other.sample() for _ in range(9)]


def test_an_environment_a_situation_and_a_touch_say_what_they_are():
    env = household_v0.parallel_env("evening", max_cycles=200)
    about = "Household('evening': 4 people, 2 robots, 8 behaviors; "
    assert repr(env) == about + "not yet reset)"
    assert str(env) == str(household_v0.env("evening", max_cycles=200)) == repr(env)
    env.reset(seed=1)
    touches = ()
    while not touches:
        env.step({"robot_0": env.behaviors.index("bark")})
        touches = env.feedback("robot_0")
    assert repr(env) == about + f"step {env.decision} of 200)"
    situation = env.situation("robot_0")
    assert repr(situation) == f"Situation({situation})"
    touch = touches[0]
    assert repr(touch).startswith(
        f"Feedback({touch.giver}: tap of {touch.strength:.2f} at "
    )
    assert "\n" not in repr(touch)


@pytest.mark.parametrize("encoding", ["features", "situation"])
def test_what_is_no_observation_of_one_robot_is_refused_in_one_line(encoding):
    env = household_v0.parallel_env("evening", observation=encoding)
    observations, _ = env.reset(seed=1)
    for row in (observations, None, [], np.zeros(3), "robot_0", env.state()):
        with pytest.raises(HouseholdError, match="allowed: what one robot obs") as told:
            env.describe(row)
        assert "\n" not in str(told.value)
    assert "son: playing" in env.describe(observations["robot_0"])


def test_an_observation_that_was_stored_as_a_list_is_described_all_the_same():
    env = household_v0.parallel_env("evening")
    observations, _ = env.reset(seed=1)
    row = observations["robot_0"]
    assert env.describe(row.tolist()) == env.describe(row)


def test_every_step_delivers_exact_types_and_the_last_one_ends_for_all(make):
    env = make()
    observations, _ = env.reset(seed=1)
    rng = np.random.default_rng(1)
    n = len(env.behaviors)
    for step in range(1, CYCLES + 1):
        actions = {agent: int(rng.integers(n)) for agent in env.agents}
        observations, rewards, ends, cuts, infos = env.step(actions)
        for answer in (observations, rewards, ends, cuts, infos):
            assert list(answer) == env.possible_agents
        for agent in env.possible_agents:
            assert exact(observations[agent], env.observation_space(agent))
            assert type(rewards[agent]) is float
            assert ends[agent] is False
            assert cuts[agent] is (step == CYCLES)
        assert env.agents == ([] if step == CYCLES else env.possible_agents)


def test_a_step_after_the_end_returns_empty_dictionaries_and_changes_nothing(
    make, same
):
    env = make(max_cycles=2)
    env.reset(seed=1)
    for _ in range(2):
        env.step(dict.fromkeys(env.agents, 0))
    before = env.state()
    assert env.step({}) == ({}, {}, {}, {}, {})
    assert env.step(dict.fromkeys(env.possible_agents, 0)) == ({}, {}, {}, {}, {})
    assert same(env.state(), before)


def test_actions_may_be_of_any_integer_type(make, same):
    one, other = make(), make()
    for env in (one, other):
        env.reset(seed=3)
    for _ in range(CYCLES):
        plain = one.step(dict.fromkeys(one.agents, 1))
        assert same(other.step(dict.fromkeys(other.agents, np.int64(1))), plain)


def test_a_reset_without_a_seed_goes_on_and_does_not_begin_anew(make, same):
    env = make()
    first, _ = env.reset(seed=5)
    seconds = [env.reset()[0] for _ in range(3)]
    states = [env.state()]
    again, _ = env.reset(seed=5)
    assert same(again, first)
    assert same([env.reset()[0] for _ in range(3)], seconds)
    assert same(env.state(), states[0])


def test_zero_is_a_seed_like_any_other(make, same):
    env = make()
    first = env.reset(seed=0)
    env.reset()
    assert same(env.reset(seed=0), first)


def test_two_environments_that_were_never_seeded_differ(shipped_scenario):
    # Perceived moods carry noise, so that two histories never look the same.
    one, other = (household_v0.parallel_env(shipped_scenario) for _ in range(2))
    one.reset()
    other.reset()
    assert not np.array_equal(one.state(), other.state())


def test_returned_arrays_are_neither_reused_nor_shared(make, same):
    env = make()
    observations, infos = env.reset(seed=1)
    kept = {
        agent: [*arrays(observations[agent]), infos[agent]["action_mask"]]
        for agent in env.possible_agents
    }
    copies = {agent: [a.copy() for a in kept[agent]] for agent in kept}
    state, state_copy = env.state(), env.state().copy()
    env.step(dict.fromkeys(env.agents, 0))
    assert same(kept, copies)
    assert same(state, state_copy)
    everything = [array for agent in kept for array in kept[agent]]
    everything += [
        array for o in (env.reset()[0],) for a in o for array in arrays(o[a])
    ]
    for i, array in enumerate(everything):
        assert array.flags.writeable
        for other in everything[:i]:
            assert not np.shares_memory(array, other)


def test_writing_into_what_was_returned_changes_nothing(make, same):
    one, other = make(), make()
    for env in (one, other):
        env.reset(seed=2)
    for _ in range(CYCLES):
        expected = one.step(dict.fromkeys(one.agents, 0))
        given = other.step(dict.fromkeys(other.agents, 0))
        assert same(given, expected)
        for agent in other.possible_agents:
            for array in (*arrays(given[0][agent]), given[4][agent]["action_mask"]):
                array[...] = 0
            given[4][agent].clear()
        other.state()[...] = 0


def test_a_pickled_environment_is_made_anew_and_goes_on_from_its_moment(make, same):
    env = make()
    env.reset(seed=1)
    copy = pickle.loads(pickle.dumps(env))
    assert copy.agents == env.agents
    assert copy.max_cycles == CYCLES
    assert same(copy.step({}), env.step({}))
    assert copy.scenario == env.scenario
    assert copy.observation_spaces == env.observation_spaces
    assert same(copy.reset(seed=4), env.reset(seed=4))


def test_a_pickled_environment_needs_none_of_the_files_that_it_was_made_of(
    tmp_path, same
):
    (tmp_path / "here.toml").write_text(shipped("home")["smart_room"].read_text())
    text = shipped("scenario")["experiment_1"].read_text()
    assert 'home = "smart_room"' in text
    path = tmp_path / "mine.toml"
    path.write_text(text.replace('"smart_room"', '"here.toml"'))
    env = household_v0.parallel_env(path, max_cycles=CYCLES)
    pickled, first = pickle.dumps(env), env.reset(seed=4)
    for file in tmp_path.iterdir():
        file.unlink()
    assert same(pickle.loads(pickled).reset(seed=4), first)
    assert same(env.reset(seed=4), first)


def test_overrides_may_be_arrays_and_numbers_of_theirs():
    env = household_v0.parallel_env(
        max_cycles=np.int64(7),
        decision_period=np.float32(1.0),
        robots=[{"position": np.array([2.6, 2.6])}],
    )
    assert env.max_cycles == 7
    assert env.scenario.robots[0].position == (2.6, 2.6)


def test_a_pickled_environment_keeps_a_scenario_of_its_own_and_all_overrides(
    household_of, same
):
    env = household_v0.parallel_env(
        household_of(), "situation", max_cycles=7, slots={"people": 3}
    )
    copy = pickle.loads(pickle.dumps(env))
    assert copy.scenario == env.scenario
    assert copy.max_cycles == 7
    assert copy.observation_spaces == env.observation_spaces
    assert same(copy.reset(seed=4), env.reset(seed=4))


def test_the_turn_based_form_gives_access_to_everything_through_unwrapped(make_aec):
    env = make_aec()
    env.reset(seed=1)
    bare = env.unwrapped
    agent = env.agent_selection
    assert bare.situation(agent).entities == tuple(sorted(bare.scenario.person_names))
    assert bare.feedback(agent) == ()
    assert bare.appropriateness(agent).shape == (len(bare.behaviors),)
    assert bare.state_space.contains(bare.state())


def test_what_evaluation_reads_stays_in_its_range(make):
    env = make(max_cycles=60)
    env.reset(seed=1)
    while env.agents:
        env.step(dict.fromkeys(env.agents, env.decision // 10 % len(env.behaviors)))
        for agent in env.possible_agents:
            values = env.appropriateness(agent)
            assert np.isfinite(values).all()
            assert (np.abs(values) <= 1.0).all()
            assert all(1 <= x <= 10 for x in env.opinion(agent).values())


@pytest.mark.parametrize("action", [-1, 2, 0.0, "sleep", None, 2**70, "x" * 5000])
def test_an_action_that_is_no_behavior_is_refused_in_one_line(action):
    env = household_v0.parallel_env()
    env.reset(seed=1)
    with pytest.raises(HouseholdError, match=r"robot_0: .*allowed: 0 to 1$"):
        env.step({"robot_0": action})


@pytest.mark.parametrize("actions", [None, 0, [0], "robot_0", "x" * 5000])
def test_actions_that_are_no_mapping_are_refused_in_one_line(actions):
    env = household_v0.parallel_env()
    env.reset(seed=1)
    with pytest.raises(HouseholdError, match=r"^actions: .*allowed: a behavior for"):
        env.step(actions)


@pytest.mark.parametrize("agent", ["robot0", "robot_1", None, ("robot_0",), []])
def test_an_agent_that_is_no_robot_is_refused_with_the_nearest_name(agent):
    env = household_v0.parallel_env()
    env.reset(seed=1)
    with pytest.raises(HouseholdError, match=r"^unknown agent .*\(allowed: robot_0\)$"):
        env.situation(agent)
    with pytest.raises(HouseholdError, match="unknown agent"):
        env.observation_space(agent)
    if not isinstance(agent, list):
        with pytest.raises(HouseholdError, match="unknown agent"):
            env.step({agent: 0})


def test_refused_actions_leave_the_household_as_it_was(same):
    one, other = household_v0.parallel_env(), household_v0.parallel_env()
    for env in (one, other):
        env.reset(seed=1)
    for wrong in (None, {"robot_0": 7}, {"robot0": 0}, {"robot_0": 0, "robot_1": 0}):
        with pytest.raises(HouseholdError):
            one.step(wrong)
    for _ in range(CYCLES):
        assert same(one.step({"robot_0": 0}), other.step({"robot_0": 0}))


@pytest.mark.parametrize("seed", [-1, 1.5, "a", "1", b"1", [1], 2.0, float("nan")])
def test_a_seed_that_is_no_whole_number_from_0_up_is_refused_in_one_line(seed):
    env = household_v0.parallel_env()
    with pytest.raises(
        HouseholdError, match=r"^seed: .*allowed: None or a whole number"
    ):
        env.reset(seed=seed)
    with pytest.raises(HouseholdError, match=r"^nobody is at home yet"):
        env.state()


def test_a_seed_may_be_any_whole_number_from_0_up(same):
    one, other = household_v0.parallel_env(), household_v0.parallel_env()
    for seed in (0, 7, 2**63, 2**200):
        assert same(one.reset(seed=seed), other.reset(seed=seed))
    assert same(one.reset(seed=np.int64(7)), other.reset(seed=np.uint8(7)))


def test_a_step_before_the_first_reset_says_what_to_do():
    env = household_v0.parallel_env()
    with pytest.raises(HouseholdError, match=r"^nobody is at home yet: .*reset\(\)"):
        env.step({"robot_0": 0})


@pytest.mark.parametrize(
    "ask",
    [
        lambda env: env.state(),
        lambda env: env.situation("robot_0"),
        lambda env: env.attended("robot_0"),
        lambda env: env.appropriateness("robot_0"),
        lambda env: env.opinion("robot_0"),
    ],
    ids=["state", "situation", "attended", "appropriateness", "opinion"],
)
def test_what_is_not_there_before_the_first_reset_says_what_to_do(ask):
    env = household_v0.parallel_env()
    with pytest.raises(HouseholdError, match=r"^nobody is at home yet: .*reset\(\)"):
        ask(env)
    env.reset(seed=1)
    ask(env)


@pytest.mark.parametrize(
    ("arguments", "hint"),
    [
        ({"scenario": "experimnt_1"}, "did you mean 'experiment_1'"),
        ({"observation": "featurs"}, "did you mean 'features'"),
        ({"render_mode": "humn"}, "render mode 'humn'"),
        ({"max_cycle": 3}, "did you mean 'max_cycles'"),
        ({"max_cycles": 0}, "max_cycles"),
        ({"behaviors": ["bark", "plya"]}, "did you mean 'play'"),
        ({"observation": []}, "unknown observation []"),
        ({"render_mode": 3}, "unknown render mode 3"),
        ({"scenario": None}, "unknown scenario 'None'"),
        ({"scenario": "x" * 5000}, "unknown scenario 'xxx"),
        ({"max_cycles": object()}, "max_cycles: <object"),
        ({"max_cycles": np.float64(3)}, "max_cycles: Expected `int`"),
        ({"behaviors": 10**5000}, "behaviors: Expected `array`"),
    ],
)
def test_a_wrong_argument_is_answered_by_one_line_with_a_hint(arguments, hint):
    with pytest.raises(HouseholdError) as caught:
        household_v0.parallel_env(**arguments)
    assert hint in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.skipif(
    not hasattr(pettingzoo, "register"), reason="PettingZoo has it since 1.27"
)
def test_importing_household_alone_enters_it_into_the_registry():
    code = (
        "import household, pettingzoo, sys\n"
        "assert 'policies' not in sys.modules\n"
        "for form in ('parallel', 'aec'):\n"
        "    env = pettingzoo.make(form, 'household/household-v0', max_cycles=3)\n"
        "    env.reset(seed=1)\n"
        "    print(env.unwrapped.max_cycles, env.possible_agents)\n"
    )
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", code],
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout == "3 ['robot_0']\n" * 2

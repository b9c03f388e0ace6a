"""Many homes at once live as each of them would alone."""

import copy
import pickle

import gymnasium
import numpy as np
import pytest
from gymnasium.vector import AutoresetMode, SyncVectorEnv, VectorEnv
from gymnasium.wrappers.vector import RecordEpisodeStatistics

from household import vector
from household.config.toml import shipped
from household.errors import HouseholdError
from household.household_v0 import parallel_env
from household.observation.frame import common_frame
from household.scenario.family import Draw, draw
from household.vector.seeds import home_seeds

CYCLES = 25


@pytest.fixture(params=[0, 1], ids=["alone", "with a worker"])
def workers(request):
    return request.param


@pytest.fixture
def make():
    """Makes vector environments that are closed in the end."""
    made = []

    def make(*arguments, **options):
        made.append(vector.make(*arguments, **options))
        return made[-1]

    yield make
    for envs in made:
        envs.close()


def random_actions(envs, seed=3):
    rng = np.random.default_rng(seed)
    while True:
        yield rng.integers(len(envs.behaviors), size=envs.num_envs)


class Singles:
    """The same homes, one by one, as plain parallel environments."""

    def __init__(self, envs, **overrides):
        frame = common_frame(envs.scenarios)
        slots = {"people": frame.people, "robots": frame.robots}
        self.envs = [
            parallel_env(scenario, slots=slots, **overrides)
            for scenario in envs.scenarios
        ]
        self.seeds, self.home, self.agents = envs.seeds, envs.home, envs.agents

    def reset(self, seeded=True):
        seeds = self.seeds if seeded else [None] * len(self.envs)
        found = [env.reset(seed=s)[0] for env, s in zip(self.envs, seeds, strict=True)]
        return self._rows(found)

    def step(self, actions):
        """Observations, rewards, ends; and the last observations of episodes."""
        found, final = [], [None] * len(actions)
        rewards, ends = np.zeros(len(actions)), np.zeros(len(actions), bool)
        for home, env in enumerate(self.envs):
            slots = np.flatnonzero(self.home == home)
            chosen = dict(zip(env.possible_agents, actions[slots], strict=True))
            observations, felt, _, over, _ = env.step(chosen)
            rewards[slots], ends[slots] = list(felt.values()), list(over.values())
            if not env.agents:
                for slot, row in zip(slots, observations.values(), strict=True):
                    final[slot] = row
                observations, _ = env.reset()
            found.append(observations)
        return self._rows(found), rewards, ends, final

    def _rows(self, found):
        return np.array(
            [found[h][a] for h, a in zip(self.home, self.agents, strict=True)]
        )


@pytest.fixture(params=["one scenario", "families"])
def households(request):
    """Homes that are alike, and homes of different families, sizes and lengths."""
    if request.param == "one scenario":
        return "evening"
    return [
        draw("phone", Draw(seed=1, n_people=2, n_robots=1)),
        draw("party", Draw(seed=2, n_people=6, n_robots=3)),
        draw("elder_care", Draw(seed=3, n_people=1, n_robots=2)),
    ]


def test_each_home_lives_as_it_does_alone_over_several_episodes(
    make, households, workers
):
    envs = make(households, homes=3, workers=workers, seed=5, max_cycles=CYCLES)
    singles = Singles(envs)
    observations, _ = envs.reset()
    assert (observations == singles.reset()).all()
    touched = 0
    for step, actions in zip(range(3 * CYCLES + 5), random_actions(envs), strict=False):
        observations, rewards, ends, cuts, infos = envs.step(actions)
        rows, felt, over, final = singles.step(actions)
        assert (observations == rows).all()
        assert (rewards == felt).all()
        assert not ends.any()
        assert (cuts == over).all()
        assert cuts.any() == ((step + 1) % CYCLES == 0) == ("final_obs" in infos)
        for slot in np.flatnonzero(cuts):
            assert (infos["final_obs"][slot] == final[slot]).all()
        touched += np.count_nonzero(rewards)
    assert touched
    observations, _ = envs.reset()
    assert (observations == singles.reset(seeded=False)).all()


def test_homes_whose_episodes_end_at_different_times_begin_anew_by_themselves(make):
    envs = make([short("evening", 3), short("evening", 5)], seed=1)
    envs.reset()
    cut = []
    for actions in take(15, random_actions(envs)):
        _, _, _, cuts, infos = envs.step(actions)
        cut.append(cuts[[0, 2]].tolist())
        ended = [row is not None for row in infos.get("final_obs", [None] * 4)]
        assert ended == cuts.tolist()
    steps = range(1, 16)
    assert cut == [[step % 3 == 0, step % 5 == 0] for step in steps]


def short(name, cycles):
    return parallel_env(name, max_cycles=cycles).scenario


def take(n, stream):
    return [each for each, _ in zip(stream, range(n), strict=False)]


class OneRobot(gymnasium.Env):
    """A home with one robot, as a plain Gymnasium environment."""

    def __init__(self, seed):
        self.env, self.first = parallel_env("experiment_1", max_cycles=CYCLES), seed
        self.observation_space = self.env.observation_space("robot_0")
        self.action_space = self.env.action_space("robot_0")

    def reset(self, *, seed=None, options=None):
        seed, self.first = self.first if seed is None else seed, None
        observations, _ = self.env.reset(seed=seed)
        return observations["robot_0"], {"step": 0}

    def step(self, action):
        answers = self.env.step({"robot_0": action})
        row, reward, end, cut, _ = (answer["robot_0"] for answer in answers)
        return row, reward, end, cut, {"step": self.env.decision}


def test_episodes_end_and_begin_as_in_gymnasiums_own_vector_environment(make):
    envs = make("experiment_1", homes=3, seed=2, max_cycles=CYCLES)
    assert envs.metadata["autoreset_mode"] is AutoresetMode.SAME_STEP
    makers = [lambda s=s: OneRobot(s) for s in envs.seeds]
    theirs = SyncVectorEnv(makers, autoreset_mode=AutoresetMode.SAME_STEP)
    assert envs.single_observation_space == theirs.single_observation_space
    assert envs.single_action_space == theirs.single_action_space
    assert envs.observation_space == theirs.observation_space
    assert envs.action_space == theirs.action_space
    assert (envs.reset()[0] == theirs.reset()[0]).all()
    for actions in take(2 * CYCLES, random_actions(envs)):
        *ours, infos = envs.step(actions)
        *same, theirs_infos = theirs.step(actions)
        for one, other in zip(ours, same, strict=True):
            assert one.dtype == other.dtype
            assert (one == other).all()
        keys = {"final_obs", "_final_obs", "final_info", "_final_info"}
        assert keys & set(infos) == keys & set(theirs_infos)
        if "final_obs" in infos:
            for one, other in zip(
                infos["final_obs"], theirs_infos["final_obs"], strict=True
            ):
                assert (one == other).all()
            for mask in ("_final_obs", "_final_info"):
                assert (infos[mask] == theirs_infos[mask]).all()
            last = theirs_infos["final_info"]["_step"]
            assert (infos["final_info"]["_caresses"] == last).all()


def test_gymnasiums_wrappers_accept_it(make):
    envs = make("evening", homes=2, seed=1, max_cycles=CYCLES)
    assert isinstance(envs, VectorEnv)
    wrapped = RecordEpisodeStatistics(envs)
    wrapped.reset()
    total = np.zeros(4)
    for actions in take(CYCLES, random_actions(envs)):
        _, rewards, _, _, infos = wrapped.step(actions)
        total += rewards
    assert np.allclose(infos["episode"]["r"], total)
    assert infos["episode"]["l"].tolist() == [CYCLES] * 4


def test_what_is_returned_is_in_the_spaces_and_always_of_the_same_shape(
    make, households
):
    envs = make(households, homes=3, seed=1, max_cycles=CYCLES)
    observations, infos = envs.reset()
    shapes = {name: (value.shape, value.dtype) for name, value in infos.items()}
    assert set(shapes) == {
        *("caresses", "taps", "behavior_over", "attended", "action_mask"),
        *("_caresses", "_taps", "_behavior_over", "_attended", "_action_mask"),
    }
    assert infos["action_mask"].shape == (envs.num_envs, len(envs.behaviors))
    assert infos["behavior_over"].all()
    for actions in take(CYCLES + 2, random_actions(envs)):
        assert observations in envs.observation_space
        observations, rewards, _, _, infos = envs.step(actions)
        assert rewards.dtype == np.float64
        assert (
            shapes.items()
            <= {
                n: (v.shape, v.dtype)
                for n, v in infos.items()
                if isinstance(v, np.ndarray)
            }.items()
        )
        touches = infos["caresses"] + infos["taps"]
        final = infos.get("final_info")
        if final is None:
            assert ((touches > 0) == (rewards != 0)).all()
        else:
            assert not touches.any()  # They are those of the episode that begins.
            touches = final["caresses"] + final["taps"]
            assert ((touches > 0) == (rewards != 0)).all()


def test_the_mask_allows_every_choice_when_one_is_due_and_else_what_goes_on(make):
    envs = make("evening", homes=2, seed=4, max_cycles=CYCLES)
    _, infos = envs.reset()
    actions = np.zeros(envs.num_envs, int)
    rng = np.random.default_rng(0)
    due = 0
    for _ in range(CYCLES - 1):
        over, mask = infos["behavior_over"], infos["action_mask"]
        assert (mask.sum(axis=1) == np.where(over, len(envs.behaviors), 1)).all()
        assert (mask[np.arange(envs.num_envs), actions] == 1).all()
        fresh = rng.integers(len(envs.behaviors), size=envs.num_envs)
        actions = np.where(over, fresh, actions)
        due += np.count_nonzero(over)
        _, _, _, _, infos = envs.step(actions)
    assert 0 < due < (CYCLES - 1) * envs.num_envs


def test_robots_of_homes_with_other_behaviors_share_the_numbers_of_actions(make):
    short_list = parallel_env("evening", behaviors=["sleep", "bark"]).scenario
    long_list = parallel_env("evening", behaviors=["bark", "play", "sleep"]).scenario
    envs = make([short_list, long_list], seed=1, max_cycles=CYCLES)
    assert envs.behaviors == ("sleep", "bark", "play")
    _, infos = envs.reset()
    assert infos["action_mask"].tolist() == [[1, 1, 0]] * 2 + [[1, 1, 1]] * 2
    doing = envs.layout["own_behavior"]
    observations, *_ = envs.step(np.array([1, 0, 1, 2]))
    assert observations[:, doing].argmax(axis=1).tolist() == [1, 0, 1, 2]
    # Nobody at the first home can play: its robots go on with what they do.
    observations, *_ = envs.step(np.array([2, 2, 2, 2]))
    assert observations[:, doing].argmax(axis=1).tolist() == [1, 0, 2, 2]


def test_no_two_homes_have_the_same_seed_and_the_same_seed_draws_the_same():
    seeds = home_seeds(7, 1000)
    assert len(set(seeds)) == 1000
    assert seeds == home_seeds(7, 1000)
    assert seeds[:5] == home_seeds(7, 5)
    assert not set(seeds) & set(home_seeds(8, 1000))
    assert home_seeds(None, 3) != home_seeds(None, 3)
    assert all(0 <= seed < 2**63 for seed in seeds)


def test_seeds_may_be_handed_to_reset(make):
    envs = make("evening", homes=3, seed=5)
    first, _ = envs.reset()
    again, _ = envs.reset(seed=5)
    assert (first == again).all()
    other, _ = envs.reset(seed=6)
    assert (first != other).any()
    given, _ = envs.reset(seed=home_seeds(5, 3))
    assert (first == given).all()
    assert envs.seeds == home_seeds(5, 3)


def test_homes_of_one_vector_differ_also_across_processes(make):
    envs = make("evening", homes=4, workers=1, seed=1)
    observations, _ = envs.reset()
    assert len({row.tobytes() for row in observations}) == envs.num_envs


def test_what_was_returned_is_the_callers_own_unless_it_waives_that(make):
    envs = make("evening", homes=2, seed=1)
    kept, infos = envs.reset()
    copies = kept.copy(), infos["action_mask"].copy()
    step = envs.step(np.zeros(4, int))
    assert (kept == copies[0]).all()
    assert (infos["action_mask"] == copies[1]).all()
    assert not np.shares_memory(kept, step[0])
    thrifty = make("evening", homes=2, seed=1, copy=False)
    first, _ = thrifty.reset()
    second, *_ = thrifty.step(np.zeros(4, int))
    assert np.shares_memory(first, second)
    assert (second == step[0]).all()


@pytest.mark.parametrize("copy", [True, False])
def test_what_no_step_writes_anew_is_the_callers_own_in_any_case(make, copy):
    envs = make("evening", homes=2, seed=1, copy=copy)
    _, infos = envs.reset()
    for _ in range(3):
        infos["_caresses"][:] = False
        _, _, terminations, _, infos = envs.step(np.zeros(4, int))
        assert not terminations.any()
        terminations[:] = True
        assert all(infos[key].all() for key in infos if key.startswith("_"))
    _, infos = envs.reset()
    assert infos["_action_mask"].all()


@pytest.mark.parametrize(
    ("actions", "text"),
    [
        ([0, 0], "allowed: whole numbers of shape (4,)"),
        ([0.0] * 4, "actions: float64 of shape (4,)"),
        ([0, 0, 99, 0], "slot 2: action 99 is none of the behaviors; allowed: 0 to 7"),
        ([0, 0, 0, -1], "slot 3: action -1 is none of the behaviors"),
    ],
)
def test_wrong_actions_are_refused_in_one_line(make, actions, text):
    envs = make("evening", homes=2, seed=1)
    envs.reset()
    with pytest.raises(HouseholdError) as caught:
        envs.step(np.array(actions))
    assert text in str(caught.value)
    assert "\n" not in str(caught.value)
    envs.step(np.zeros(4, int))  # Nothing has happened.


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ({"homes": 0}, "homes: 0; allowed: whole numbers from 1 up"),
        ({"workers": -1}, "workers: -1; allowed: whole numbers from 0 up"),
        ({"seed": -3}, "seed: -3"),
        ({"scenario": []}, "scenario: none"),
        ({"scenario": "evenig"}, "did you mean 'evening'?"),
        ({"max_cycle": 3}, "max_cycle"),
    ],
)
def test_wrong_arguments_are_refused_in_one_line(arguments, text):
    with pytest.raises(HouseholdError) as caught:
        vector.make(**{"scenario": "evening"} | arguments)
    assert text in str(caught.value)
    assert "\n" not in str(caught.value)


def test_wrong_calls_are_refused_in_one_line(make):
    envs = make("evening", homes=2, seed=1)
    with pytest.raises(HouseholdError, match="call reset"):
        envs.step(np.zeros(4, int))
    for seed in (-1, "x", [1], [1, 2, 3], [1, -2], [1, 2**63], 1.5):
        with pytest.raises(HouseholdError):
            envs.reset(seed=seed)
    with pytest.raises(HouseholdError, match="options"):
        envs.reset(options={"reset_mask": np.ones(4, bool)})
    envs.reset()
    envs.close()
    with pytest.raises(HouseholdError, match="closed"):
        envs.step(np.zeros(4, int))


@pytest.mark.parametrize("copied", [copy.deepcopy, copy.copy, pickle.dumps])
def test_homes_that_share_memory_are_not_copied(make, copied):
    """A copy of the arrays alone would look alive and be dead."""
    envs = make("experiment_1", homes=2)
    envs.reset()
    with pytest.raises(HouseholdError, match="cannot be copied or pickled"):
        copied(envs)


def test_numbers_of_other_libraries_count_homes(make):
    envs = make("experiment_1", homes=np.int64(2), workers=np.uint8(0))
    assert len(envs.scenarios) == 2


def test_homes_of_every_family_live_side_by_side(make):
    families = [draw(name, 1) for name in sorted(shipped("family"))]
    envs = make(families, seed=1)
    assert len(families) >= 8
    assert (
        str(envs) == f"VectorHousehold(8 households: 8 homes, {envs.num_envs} robots)"
    )
    envs.reset()
    for actions in take(3, random_actions(envs)):
        observations, *_ = envs.step(actions)
    assert observations in envs.observation_space

"""What callers of an environment hand over: seeds, actions, agents, arguments."""

import numpy as np
import pytest
from hypothesis import strategies as st

from household import household_v0
from household.errors import HouseholdError

from .inputs import told
from .living import STEPS, check_moment
from .plain_data import ODD

NUMBERS = (np.int8(1), np.uint64(2), np.float64(1.0), np.array(1), np.array([1, 2]))


@pytest.fixture(scope="module")
def home():
    env = household_v0.parallel_env("evening", max_cycles=10**6)
    env.reset(seed=0)
    return env


ACTIONS = st.one_of(
    st.dictionaries(
        st.sampled_from(("robot_0", "robot_1")), st.integers(0, 5), max_size=2
    ),
    st.dictionaries(
        st.sampled_from(("robot_0", "robot_9", "", 0)) | st.text(max_size=8),
        st.sampled_from(NUMBERS) | ODD,
        max_size=3,
    ),
    ODD,
)


def test_an_action_is_refused_in_one_line_or_lived_through(explore, home, deepest):
    from household.home.enclosure import outdoors

    plan = home.scenario.plan
    open_air = outdoors(plan, plan.wall_segments)

    def check(actions):
        before = home.state().tobytes()
        try:
            _, rewards, *_ = home.step(actions)
        except HouseholdError as error:
            told(error)
            assert home.state().tobytes() == before
            return "refused"
        assert np.isfinite(list(rewards.values())).all()
        check_moment(home, open_air, deepest)
        return "accepted"

    explore(ACTIONS, check, few=60)
    assert home.decision >= min(STEPS, explore.counts["accepted"])


def test_a_seed_is_refused_in_one_line_or_begins_an_episode(explore, home):
    def check(seed):
        try:
            home.reset(seed=seed)
        except HouseholdError as error:
            told(error)
            return "refused"
        assert home.decision == 0
        return "accepted"

    explore(ODD | st.sampled_from(NUMBERS), check, few=30)
    home.reset(seed=0)


ASKED = ("situation", "feedback", "causes", "behavior", "attended", "appropriateness")


def test_an_agent_is_refused_in_one_line_or_told_of(explore, home):
    def check(case):
        question, agent = case
        try:
            getattr(home, question)(agent)
        except HouseholdError as error:
            told(error)
            return "refused"
        return "accepted"

    agents = st.sampled_from(home.possible_agents) | ODD
    spaces = ("observation_space", "action_space", "opinion")
    explore(st.tuples(st.sampled_from(ASKED + spaces), agents), check, few=40)


def test_an_argument_is_refused_in_one_line_or_makes_a_household(explore):
    def check(arguments):
        try:
            env = household_v0.parallel_env("experiment_1", **arguments)
        except HouseholdError as error:
            told(error)
            return "refused"
        env.reset(seed=1)
        env.step({})
        return "accepted"

    explore(
        st.dictionaries(
            st.sampled_from(("observation", "render_mode", "max_cycles", "seed")),
            st.sampled_from(("features", "situation", 5)) | ODD,
            max_size=2,
        ),
        check,
        few=20,
    )

"""Held: an agent chooses when its behavior is over, and is told what lay between."""

import copy
import pickle

import numpy as np
import pytest
from pettingzoo.test import api_test, parallel_api_test, parallel_seed_test, seed_test
from pettingzoo.utils.wrappers import BaseParallelWrapper

import household
from household import household_v0
from household.errors import HouseholdError
from household.household_v0 import env as turn_based
from household.household_v0 import parallel_env

CYCLES = 60


def held(name="evening", max_cycles=CYCLES, **options):
    return household.held(parallel_env(name, max_cycles=max_cycles, **options))


def held_turns(name="evening", max_cycles=CYCLES):
    return household.held(turn_based(name, max_cycles=max_cycles))


def drawn(env, rng):
    return {agent: int(rng.integers(len(env.behaviors))) for agent in env.agents}


@pytest.mark.filterwarnings("error")
def test_pettingzoos_tests_pass(shipped_scenario):
    parallel_api_test(held(shipped_scenario), num_cycles=3 * CYCLES)
    api_test(held_turns(shipped_scenario), num_cycles=3 * CYCLES)
    seed_test(lambda: held_turns(shipped_scenario), num_cycles=CYCLES)
    parallel_seed_test(lambda: held(shipped_scenario), num_cycles=CYCLES)


def test_a_household_lives_as_if_everybody_had_acted_only_when_due():
    """The same choices, made in the plain environment, give the same history."""
    env, plain = held(), parallel_env("evening", max_cycles=CYCLES)
    observations, infos = env.reset(seed=3)
    plain.reset(seed=3)
    rng = np.random.default_rng(1)
    since = dict.fromkeys(env.agents, (0, 0.0, 0))
    felt = 0
    while env.agents:
        due = env.due
        assert due == [a for a in env.agents if infos[a]["behavior_over"]]
        actions = drawn(env, rng)
        observations, rewards, _, cuts, infos = env.step(actions)
        since |= dict.fromkeys(due, (0, 0.0, 0))
        choices = {agent: actions[agent] for agent in due}
        while plain.decision < env.unwrapped.decision:
            theirs, gained, *_ = plain.step(choices)
            choices = {}
            for agent, reward in gained.items():
                steps, total, touches = since[agent]
                touches += len(plain.feedback(agent))
                since[agent] = steps + 1, total + reward, touches
        for agent, (steps, total, touches) in since.items():
            assert (observations[agent] == theirs[agent]).all()
            assert infos[agent]["elapsed"] == steps
            told = infos[agent]["behavior_over"] or cuts[agent]
            assert rewards[agent] == (total if told else 0.0)
            counted = infos[agent]["caresses"] + infos[agent]["taps"]
            assert counted == (touches if told else 0)
            felt += counted
    assert felt > 0
    assert all(cuts.values())


def test_nobody_is_ever_interrupted():
    env = held(max_cycles=200)
    env.reset(seed=1)
    rng = np.random.default_rng(1)
    lasted = {}
    while env.agents:
        bouts = {agent: env.behavior(agent) for agent in env.agents}
        env.step(drawn(env, rng))
        for agent, bout in bouts.items():
            if env.behavior(agent).began != bout.began:
                assert env.behavior(agent).began >= bout.ends
                lasted[agent] = lasted.get(agent, 0) + 1
    assert min(lasted.values()) > 10


def test_a_step_lasts_until_a_behavior_is_over_and_no_longer():
    env = held("experiment_1", max_cycles=100)
    _, infos = env.reset(seed=1)
    durations = [b.duration for b in env.scenario.repertoire]
    action = 0
    while env.agents:
        began = env.unwrapped.time
        assert infos["robot_0"]["behavior_over"]
        *_, infos = env.step({"robot_0": action})
        if env.agents:
            steps = env.unwrapped.time - began
            assert durations[action] <= steps < durations[action] + 1
            assert infos["robot_0"]["elapsed"] == steps
        action = 1 - action


def test_agents_that_are_not_due_and_their_actions_are_ignored():
    one, other = held(), held()
    for env in (one, other):
        env.reset(seed=1)
    rng = np.random.default_rng(4)
    ignored = 0
    while one.agents:
        actions = drawn(one, rng)
        needed = {agent: actions[agent] for agent in one.due}
        ignored += len(actions) - len(needed)
        results, fewer = one.step(actions), other.step(needed)
        assert results[1] == fewer[1]
    assert ignored > 0


def test_turns_come_to_those_whose_behavior_is_over_with_all_rewards_since():
    env, parallel = held_turns(), held()
    env.reset(seed=5)
    parallel.reset(seed=5)
    rng = np.random.default_rng(2)
    total, gained = dict.fromkeys(env.agents, 0.0), {}
    actions = {}
    while env.agents:
        agent = env.agent_selection
        _, reward, _, cut, info = env.last()
        total[agent] += reward
        if cut:
            env.step(None)
            continue
        assert info["behavior_over"]
        assert agent in parallel.due
        actions[agent] = int(rng.integers(8))
        env.step(actions[agent])
        if set(actions) == set(parallel.due):
            _, rewards, *_ = parallel.step(actions)
            actions = {}
            for name, each in rewards.items():
                gained[name] = gained.get(name, 0.0) + each
    assert not parallel.agents
    assert gained == pytest.approx(total)
    assert any(gained.values())


def test_touches_are_those_since_the_last_choice():
    env = held(max_cycles=300)
    env.reset(seed=1)
    rng, several = np.random.default_rng(0), 0
    while env.agents:
        _, rewards, _, _, infos = env.step(drawn(env, rng))
        for agent, reward in rewards.items():
            if infos[agent]["behavior_over"]:
                touches = env.feedback(agent)
                assert reward == pytest.approx(sum(touch.value for touch in touches))
                several += len(touches) != len(env.unwrapped.feedback(agent))
    assert several > 0
    with pytest.raises(HouseholdError, match="unknown agent"):
        env.feedback("robot0")


@pytest.mark.parametrize(
    "copied", [copy.deepcopy, lambda env: pickle.loads(pickle.dumps(env))]
)
def test_copies_and_checkpoints_go_on_where_the_original_stood(copied):
    env = held()
    env.reset(seed=1)
    rng = np.random.default_rng(0)
    while len(env.due) == 2:  # So that somebody's interval is open.
        env.step(drawn(env, rng))
    twin, checkpoint = copied(env), env.checkpoint()

    def lived(env):
        rng, told = np.random.default_rng(1), []
        while env.agents:
            _, rewards, _, _, infos = env.step(drawn(env, rng))
            told += [rewards, [info["elapsed"] for info in infos.values()]]
        return told

    went_on = lived(env)
    assert lived(twin) == went_on
    env.restore(checkpoint)
    assert lived(env) == went_on


def test_a_step_after_the_end_is_empty_and_one_before_the_reset_an_error():
    env = held(max_cycles=2)
    with pytest.raises(HouseholdError, match="call reset"):
        env.step({})
    env.reset(seed=1)
    while env.agents:
        env.step(dict.fromkeys(env.agents, 0))
    assert env.step({}) == ({}, {}, {}, {}, {})
    assert repr(env) == str(env) == f"Held({env.unwrapped!r})"


def test_a_misspelled_agent_is_an_error_although_others_are_ignored():
    env = held()
    env.reset(seed=1)
    with pytest.raises(HouseholdError, match="unknown agent 'robot0'"):
        env.step({"robot0": 1})


def test_it_holds_households_inside_other_wrappers_and_nothing_else():
    wrapped = BaseParallelWrapper(household_v0.parallel_env("evening"))
    assert household.held(wrapped).reset(seed=1)[1].keys() == {"robot_0", "robot_1"}
    for thing in (None, "evening", object()):
        with pytest.raises(HouseholdError, match="takes households"):
            household.held(thing)

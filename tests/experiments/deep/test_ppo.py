"""PPO of Stable-Baselines3 as a learner (extra `deep`)."""

import copy

import numpy as np
import pytest

pytest.importorskip("torch", reason="needs the extra `deep` (not in CI)")
pytest.importorskip("stable_baselines3", reason="needs the extra `deep` (not in CI)")

import torch

from experiments.deep.ppo import ppo
from experiments.phases.seeing import Seen
from learners.experience import Experience, Reward

ANN = Seen("ann", {"ann": np.array([1.0, 0.0], np.float32)})
BOB = Seen("bob", {"bob": np.array([1.0, 1.0], np.float32)})
NOBODY = Seen("nobody", {})


SETTINGS = {
    "n_steps": 16,
    "batch_size": 8,
    "n_epochs": 10,
    "learning_rate": 1e-3,
    "gamma": 0.5,
    "ent_coef": 0.01,
}


def learner(**settings):
    return ppo(2, np.random.default_rng(0), **SETTINGS | settings)


def entry(number, state, action, values=(), *, next_state=None, chosen=True):
    begun = 10.0 * number
    rewards = tuple(
        Reward(value=value, time=begun + 5, giver="ann", attending=True)
        for value in values
    )
    return Experience(
        state=state,
        action=action,
        next_state=next_state or state,
        time=begun,
        next_time=begun + 10,
        rewards=rewards,
        attended=True,
        chosen=chosen,
    )


def live(robot, n, first=0):
    """Ann likes behavior 0, and Bob behavior 1; they are there in turn."""
    for number in range(first, first + n):
        likes = number % 2
        here, then = (ANN, BOB) if likes == 0 else (BOB, ANN)
        action = robot.act(here)
        felt = (1.0,) if action == likes else (-1.0,)
        robot.learn(entry(number, here, action, felt, next_state=then))


def test_it_learns_who_likes_what():
    robot = learner()
    live(robot, 400)
    assert robot.q_values(ANN)[0] > 0.8
    assert robot.q_values(BOB)[1] > 0.8


def test_the_reward_of_a_choice_is_all_that_is_felt_until_the_next():
    robot = learner()
    robot.learn(entry(0, ANN, 1, (1.0,), next_state=BOB))
    robot.learn(entry(1, BOB, 1, (1.0, -0.5), next_state=ANN, chosen=False))
    robot.learn(entry(2, ANN, 0, (-1.0,)))
    robot.learn(entry(3, ANN, 0))
    buffer = robot._model.rollout_buffer
    assert buffer.rewards[:2, 0] == pytest.approx([1.5, -1.0])
    assert buffer.actions[:2, 0].tolist() == [[1], [0]]
    assert buffer.episode_starts[:2, 0].tolist() == [1.0, 0.0]


def test_it_can_be_copied_right_after_it_learned():
    robot = learner()
    live(robot, 16)  # The last of 16 choices is still open,
    robot.start_episode()  # and over now: the library learns.
    assert copy.deepcopy(robot).q_values(ANN) == pytest.approx(robot.q_values(ANN))


def test_an_episode_that_was_broken_off_would_have_gone_on():
    robot = learner(gamma=0.5)
    robot.learn(entry(0, ANN, 1, (1.0,), next_state=BOB))
    value = float(robot._evaluate(robot._people(BOB), 0)[0])
    robot.start_episode()
    robot.learn(entry(0, ANN, 0))
    robot.learn(entry(1, ANN, 0))
    buffer = robot._model.rollout_buffer
    assert value != 0.0
    assert buffer.rewards[0, 0] == pytest.approx(1.0 + 0.5 * value)
    assert buffer.episode_starts[:2, 0].tolist() == [1.0, 1.0]


def test_before_anybody_was_seen_any_behavior_is_as_good():
    robot = learner()
    robot.learn(entry(0, NOBODY, robot.act(NOBODY)))
    assert robot.q_values(NOBODY).tolist() == [0.5, 0.5]
    live(robot, 40, first=1)
    assert robot.q_values(NOBODY).sum() == pytest.approx(1.0)


def test_a_copy_goes_on_as_the_original_does():
    robot = learner()
    live(robot, 50)
    other = copy.deepcopy(robot)
    for each in (robot, other):
        live(each, 50, first=50)
    assert robot.q_values(ANN).tolist() == other.q_values(ANN).tolist()


def test_whatever_else_draws_in_the_process_a_seed_gives_one_network():
    found = []
    for word in (1, 2):
        torch.manual_seed(word)
        np.random.seed(word)  # noqa: NPY002 - what libraries draw from
        before = torch.get_rng_state(), np.random.get_state()[1].tolist()  # noqa: NPY002
        robot = learner()
        live(robot, 50)
        found.append(robot.q_values(ANN).tolist())
        assert torch.equal(torch.get_rng_state(), before[0])
        assert np.random.get_state()[1].tolist() == before[1]  # noqa: NPY002
    assert found[0] == found[1]

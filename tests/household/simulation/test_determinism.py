"""One seed, one history: whole episodes are compared, in one process and in two."""

import os
import subprocess
import sys
from collections.abc import Iterator

import numpy as np
import pytest

from household import household_v0
from household.config.toml import shipped
from household.observation.encodings import layout
from household.scenario.persona import Persona
from household.scenario.scenario import PersonSpec, RobotSpec, Scenario, ScriptStep
from household.simulation.random_streams import Streams

STEPS = 80


@pytest.fixture(scope="module")
def episode(random_actions):
    """Plays an episode and tells all that anybody could see of it, step by step."""

    def play(env, seed: int | None, actions: int = 0) -> Iterator[tuple[object, ...]]:
        yield env.reset(seed=seed)
        for action in random_actions(env, actions):
            answers = env.step(action)
            names = env.possible_agents
            causes = [env.causes(name) for name in names]
            yield (
                *answers,
                causes,
                env.state(),
                env.simulation.crowd.position.copy(),
                env.simulation.crowd.gaze.copy(),
            )
            if not env.agents:
                return

    return play


DIGEST = """
import hashlib, sys
import numpy as np
from household import household_v0
from household.config.toml import shipped

def told(value):
    # Sets are written in an order that depends on the process.
    if isinstance(value, np.ndarray):
        return f"{value.dtype}{value.shape}{value.tobytes().hex()}"
    if isinstance(value, dict):
        return str([(key, told(each)) for key, each in value.items()])
    if isinstance(value, (tuple, list)):
        return str([told(each) for each in value])
    return str(value)

def digest(name):
    env = household_v0.parallel_env(name, max_cycles=int(sys.argv[1]))
    rng = np.random.default_rng(0)
    read = hashlib.sha256(told(env.reset(seed=11)).encode())
    while env.agents:
        actions = {agent: int(rng.integers(len(env.behaviors))) for agent in env.agents}
        answers = env.step(actions)
        causes = [env.causes(agent) for agent in env.possible_agents]
        world = [env.state(), env.simulation.crowd.position, env.simulation.crowd.gaze]
        read.update(told([answers, causes, world]).encode())
    return read.hexdigest()

for name in shipped("scenario"):
    print(name, digest(name))
"""


def test_the_same_seed_gives_the_same_whole_episode(shipped_scenario, episode, same):
    one, other = (
        household_v0.parallel_env(shipped_scenario, max_cycles=STEPS) for _ in range(2)
    )
    for step, (here, there) in enumerate(
        zip(episode(one, 7), episode(other, 7), strict=True)
    ):
        assert same(here, there), f"differs at step {step}"


def test_people_touch_robots_in_every_episode_that_is_compared(shipped_scenario):
    env = household_v0.parallel_env(shipped_scenario, max_cycles=STEPS)
    env.reset(seed=11)
    touches = 0
    for step in range(STEPS):
        env.step(dict.fromkeys(env.agents, step // 10 % len(env.behaviors)))
        touches += sum(len(env.feedback(agent)) for agent in env.possible_agents)
    assert touches > 0


def test_the_same_seed_gives_the_same_episodes_in_two_processes(monkeypatch, capsys):
    """Here and in another one, which hashes texts otherwise."""
    hash_seed = "1" if os.environ.get("PYTHONHASHSEED") != "1" else "2"
    other = subprocess.run(
        [sys.executable, "-c", DIGEST, str(STEPS)],
        check=True,
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONHASHSEED": hash_seed},
    ).stdout.splitlines()
    monkeypatch.setattr(sys, "argv", ["here", str(STEPS)])
    exec(DIGEST, {})
    one = capsys.readouterr().out.splitlines()
    assert len(set(one)) == len(list(shipped("scenario")))
    assert one == other


def test_unseeded_resets_go_on_reproducibly_and_with_other_episodes(episode, same):
    histories = []
    for _ in range(2):
        env = household_v0.parallel_env("experiment_5", max_cycles=60)
        histories.append([list(episode(env, seed)) for seed in (3, None, None)])
    assert same(histories[0], histories[1])
    first, second, third = histories[0]
    assert not same(first, second)
    assert not same(second, third)


@pytest.mark.parametrize("scenario", ["experiment_5", "party"])
def test_an_episode_does_not_depend_on_what_was_played_before_it(
    scenario, episode, same
):
    """Nor on who pushed whom then: in a crowd the physics engine is at work."""
    fresh, used = (household_v0.parallel_env(scenario, max_cycles=60) for _ in range(2))
    list(episode(used, 1, actions=5))
    list(episode(used, None, actions=6))
    used.reset()
    used.step({"robot_0": 1})
    assert same(list(episode(used, 9)), list(episode(fresh, 9)))


def test_different_seeds_give_different_episodes(shipped_scenario, episode, same):
    env = household_v0.parallel_env(shipped_scenario, max_cycles=60)
    assert not same(list(episode(env, 1)), list(episode(env, 2)))


def test_reading_never_changes_what_happens(episode, same):
    watched = household_v0.parallel_env("experiment_5", max_cycles=STEPS)
    expected = list(episode(household_v0.parallel_env("experiment_5"), 4))[: STEPS + 1]
    for step, seen in enumerate(episode(watched, 4)):
        for agent in watched.possible_agents:
            watched.situation(agent)
            watched.feedback(agent)
            watched.appropriateness(agent)
            watched.opinion(agent)
            watched.attended(agent)
        watched.state()
        # The last step of the shorter episode is cut, that of the longer is not.
        if step < STEPS:
            assert same(seen, expected[step])


def test_a_further_person_or_robot_leaves_the_draws_of_the_others_unchanged():
    few, many = Streams(2, 1), Streams(5, 3)
    for seed in (8, None, None):
        few.begin(seed)
        many.begin(seed)
        for mine, theirs in zip(few.people, many.people, strict=False):
            assert np.array_equal(mine.random(50), theirs.random(50))
        assert np.array_equal(few.robots[0].random(50), many.robots[0].random(50))


def test_streams_of_people_and_robots_all_differ():
    streams = Streams(3, 3)
    streams.begin(8)
    draws = [rng.random() for rng in (*streams.people, *streams.robots)]
    streams.begin(None)
    draws += [rng.random() for rng in (*streams.people, *streams.robots)]
    assert len(set(draws)) == 12


@pytest.fixture(scope="module")
def walled_off(household_of, room):
    """Ann and a robot in one room, who else there is in the other; all are quiet."""
    home = room(walls=((4.0, 0.0, 4.0, 4.0),))
    line = ScriptStep(place="phone", duration=(5.0, 15.0))
    curious = Persona(name="curious", robot_interest=0.5, people_interest=0.0)
    ann = PersonSpec(name="ann", persona=curious, script=(line, line))
    zoe = PersonSpec(name="zoe", script=(ScriptStep(place="rug", until=900.0),))
    near, far = RobotSpec(position=(2.5, 2.5)), RobotSpec(position=(7.5, 4.5))

    def make(people: int, robots: int) -> Scenario:
        return household_of(
            home=home, people=(ann, zoe)[:people], robots=(near, far)[:robots]
        )

    return make


def gazes_and_moods(scenario):
    """Where Ann looks, and how the first robot reads her mood, step by step."""
    env = household_v0.parallel_env(scenario)
    mood = layout(env.scenario)["person_mood"].start
    observations, _ = env.reset(seed=6)
    told = []
    while env.agents:
        told.append((env.simulation.crowd.gaze[0], observations["robot_0"][mood]))
        observations, *_ = env.step(dict.fromkeys(env.agents, 1))
    return told


def test_a_person_next_door_changes_neither_gaze_nor_misreading_here(walled_off):
    assert gazes_and_moods(walled_off(1, 1)) == gazes_and_moods(walled_off(2, 1))


def test_a_robot_next_door_does_not_change_how_the_first_misreads_moods(walled_off):
    alone, both = (gazes_and_moods(walled_off(1, robots)) for robots in (1, 2))
    assert [mood for _, mood in alone] == [mood for _, mood in both]
    assert len({mood for _, mood in alone}) == len(alone)

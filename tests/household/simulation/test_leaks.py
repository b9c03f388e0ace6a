"""What people keep to themselves: no learner can reach it."""

import dataclasses

import msgspec
import numpy as np
import pytest

from household import household_v0
from household.feedback import Feedback
from household.observation.encodings import layout
from household.perception.situation import Situation
from household.scenario.validation import load_scenario

PLAIN = (str, bool, int, float, type(None), np.integer, np.floating, np.bool_)
FELT = {
    "giver",
    "kind",
    "strength",
    "time",
    "mood",
    "attending",
    "approach_began",
    "attention_began",
}


def things_in(value):
    """A value and everything that can be reached from it."""
    yield value
    if isinstance(value, dict):
        parts = [*value.keys(), *value.values()]
    elif isinstance(value, tuple | list | frozenset | set):
        parts = list(value)
    elif dataclasses.is_dataclass(value):
        parts = [getattr(value, f.name) for f in dataclasses.fields(value)]
    else:
        parts = []
    for part in parts:
        yield from things_in(part)


def is_open(value) -> bool:
    """Whether a learner may hold a thing of this kind."""
    if isinstance(value, np.ndarray):
        return value.dtype.kind in "biuf"
    return isinstance(value, PLAIN) or type(value) in {
        dict,
        tuple,
        frozenset,
        Feedback,
        Situation,
    }


def first_moments(scenario, seed=3):
    """What learners see at the very beginning, in both encodings, as bytes."""
    told = []
    for encoding in ("features", "situation"):
        env = household_v0.parallel_env(scenario, encoding)
        observations, infos = env.reset(seed=seed)
        told.append(env.state().tobytes())
        for agent in env.possible_agents:
            seen = observations[agent]
            parts = seen.values() if isinstance(seen, dict) else [seen]
            told += [part.tobytes() for part in parts]
            told.append(env.situation(agent))
            told.append(np.hstack(list(infos[agent].values())).tolist())
    return told


def with_personas(scenario, **changes):
    """The scenario with every person's private constants changed."""
    people = tuple(
        msgspec.structs.replace(
            person, persona=msgspec.structs.replace(persona, **changes)
        )
        for person, persona in zip(scenario.people, scenario.personas, strict=True)
    )
    return msgspec.structs.replace(scenario, people=people)


def contrary(scenario):
    """The household's norms with every sign turned."""
    norms = msgspec.to_builtins(scenario.household_norms)
    return {
        activity: {
            part: {behavior: -value for behavior, value in values.items()}
            for part, values in norm.items()
        }
        for activity, norm in norms.items()
    }


@pytest.mark.parametrize(
    "hidden",
    [
        {"praise": 0.01, "sanction": 0.02},
        {"habituation": 1.0, "contrast": 0.0, "recovery": 1.0, "tolerance": 0.9},
        {"patience": 1.0, "mistakes": 1.0, "only_when_attending": True},
        {"irritability": 1.0, "mood_change": 1.0, "mood_recovery": 1.0},
        {"preferences": {"playing": {"attending": {"sleep": -0.123}}}},
        {"name": "somebody_else", "description": "of whom nobody knows"},
    ],
    ids=lambda hidden: next(iter(hidden)),
)
def test_a_hidden_trait_leaves_first_observations_byte_identical(
    shipped_scenario, hidden
):
    scenario = load_scenario(shipped_scenario)
    # Traits are drawn already: the same personas are given as they are.
    plain = with_personas(scenario)
    assert first_moments(with_personas(plain, **hidden)) == first_moments(plain)


def test_the_norms_leave_first_observations_byte_identical(shipped_scenario):
    scenario = load_scenario(shipped_scenario)
    other = load_scenario(scenario, norms=contrary(scenario))
    assert first_moments(other) == first_moments(scenario)


def test_the_population_leaves_first_observations_byte_identical(shipped_scenario):
    scenario = load_scenario(shipped_scenario, heterogeneity=0.8)
    other = load_scenario(scenario, population={"seed": 99, "clusters": 2})
    assert first_moments(other) == first_moments(scenario)


def test_tastes_that_will_change_leave_first_observations_byte_identical(
    shipped_scenario,
):
    scenario = load_scenario(shipped_scenario)
    changes = [{"at": 5.0, "over": 9.0, "norms": contrary(scenario)}]
    assert first_moments(load_scenario(scenario, changes=changes)) == first_moments(
        scenario
    )


def test_the_turned_norms_show_only_in_touches(household_of):
    """The contrary household is another one: the test above is not empty."""
    taps = []
    for scenario in (household_of(), household_of(norms=contrary(household_of()))):
        env = household_v0.parallel_env(scenario)
        env.reset(seed=1)
        taps.append(0)
        while env.agents:
            *_, infos = env.step({"robot_0": 0})
            taps[-1] += infos["robot_0"]["taps"]
    assert taps[0] > 0
    assert taps[1] == 0


def test_only_open_things_can_be_reached_from_what_a_learner_gets(
    shipped_scenario, random_actions
):
    felt = 0
    for encoding in ("features", "situation"):
        env = household_v0.parallel_env(shipped_scenario, encoding, max_cycles=120)
        answers = env.reset(seed=2)
        actions = random_actions(env, 1)
        while True:
            agents = env.possible_agents
            asked = [(env.situation(agent), env.feedback(agent)) for agent in agents]
            for thing in things_in((answers, *asked)):
                assert is_open(thing), thing
                felt += isinstance(thing, Feedback)
            if not env.agents:
                break
            answers = env.step(next(actions))
    assert felt > 0


def test_a_touch_tells_only_what_can_be_felt_and_seen():
    assert {field.name for field in dataclasses.fields(Feedback)} == FELT


def test_no_robot_reads_a_mood_exactly(shipped_scenario):
    env = household_v0.parallel_env(shipped_scenario, max_cycles=60)
    place = layout(env.scenario)["person_mood"]
    observations, _ = env.reset(seed=2)
    while env.agents:
        moods = env.simulation.people.feelings.mood.copy()
        for agent in env.agents:
            read = observations[agent][place][: len(moods)]
            exact = read == moods.astype(np.float32)
            # At the end of the scale a misreading is cut.
            assert not (exact & (np.abs(moods) < 1.0)).any()
        observations, *_ = env.step(dict.fromkeys(env.agents, 0))


def test_every_touch_has_a_true_cause_for_evaluation(shipped_scenario, random_actions):
    env = household_v0.parallel_env(shipped_scenario, max_cycles=120)
    env.reset(seed=2)
    actions = random_actions(env, 1)
    began = {}
    touches = 0
    while env.agents:
        env.step(next(actions))
        for agent in env.possible_agents:
            bout = env.behavior(agent)
            began[agent, bout.decision] = (bout.behavior, bout.began)
            felt, causes = env.feedback(agent), env.causes(agent)
            assert len(felt) == len(causes)
            for touch, cause in zip(felt, causes, strict=True):
                touches += 1
                behavior, start = began[cause.robot, cause.decision]
                assert cause.behavior == behavior
                assert start <= cause.time <= touch.time
    assert touches > 0

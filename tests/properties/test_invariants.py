"""What holds at any time, whoever lives there and whatever the robots do."""

import itertools
import math

import numpy as np
from hypothesis import strategies as st

from household import household_v0
from household.config.toml import shipped
from household.feedback import reward
from household.home.floorplan import FloorPlan, Region, Wall
from household.home.geometry import crosses
from household.motion.bodies import BodyParams
from household.motion.crowd import Crowd
from household.perception.situation import Situation
from household.replay import RecordEpisodes
from household.replay.reading import read_replay
from household.scenario.family import draw
from household.simulation.simulation import PERSON_MASS, PERSON_RADIUS
from learners import Experience, Reward
from learners.components import COMPONENTS
from learners.credit.history import History
from learners.credit.transitions import SituationNetwork

from .living import OVERLAP

ROLES = ("playing", "reading", "calling")


@st.composite
def situations(draw):
    """Up to five actors and two robots, in all relations that there are."""
    names = ("ann", "bob", "cat", "dan", "eve")[: draw(st.integers(1, 5))]
    robots = ("robot_0", "robot_1")
    roles = {name: draw(st.sampled_from(ROLES)) for name in names}
    looks = st.sets(st.sampled_from([*itertools.permutations((*names, *robots), 2)]))
    pairs = st.sets(st.sampled_from([*itertools.product(names, robots)]))
    return Situation.of(roles, draw(looks), draw(pairs), draw(pairs))


def test_canonical_forms_do_not_depend_on_who_is_who_and_are_their_own(explore):
    def check(case):
        situation, swaps = case
        form, other = situation.canonical(), situation
        for one, two in swaps:
            names = situation.entities
            other = other.swapped(names[one % len(names)], names[two % len(names)])
        assert other.canonical() == form
        assert form.canonical() == form
        nameless = situation.without_names()
        assert other.without_names() == nameless
        assert nameless.without_names() == nameless
        return "checked"

    swaps = st.lists(st.tuples(st.integers(0, 4), st.integers(0, 4)), max_size=6)
    explore(st.tuples(situations(), swaps), check, few=40)


HOUSEHOLDS = st.tuples(
    st.sampled_from((*shipped("family"), *shipped("scenario"))),
    st.integers(0, 2**31),
)


def household(name, seed, decisions):
    """A shipped scenario, or a household of a family."""
    scenario = draw(name, seed) if name in shipped("family") else name
    return household_v0.parallel_env(scenario, max_cycles=decisions)


def test_rewards_are_the_touches_and_every_touch_has_a_cause_that_happened(explore):
    def check(case):
        env = household(*case, decisions=300)
        rng = np.random.default_rng(case[1])
        env.reset(seed=case[1])
        begun, felt = set(), 0
        while env.agents:
            actions = {a: int(rng.integers(len(env.behaviors))) for a in env.agents}
            _, rewards, *_ = env.step(actions)
            attention = env.simulation.senses.relations.attention
            assert (attention >= 0.0).all()
            assert (attention.sum(axis=1) <= 1.0).all()
            for agent in env.possible_agents:
                bout, touches = env.behavior(agent), env.feedback(agent)
                begun.add((agent, bout.decision, bout.behavior))
                assert rewards[agent] == reward(touches)
                for touch, cause in zip(touches, env.causes(agent), strict=True):
                    felt += 1
                    assert cause.time <= touch.time <= env.time
                    assert (cause.robot, cause.decision, cause.behavior) in begun
                    assert touch.giver in env.scenario.person_names
                    assert 0.0 < touch.strength <= 1.0
        return "with touches" if felt else "without touches"

    explore(HOUSEHOLDS, check, few=3)


def test_touches_are_the_events_of_the_replay(explore, tmp_path):
    def check(case):
        env = RecordEpisodes(household(*case, decisions=200), tmp_path)
        rng = np.random.default_rng(case[1])
        env.reset(seed=case[1])
        lived = []
        while env.agents:
            n = len(env.unwrapped.behaviors)
            _, rewards, *_ = env.step({a: int(rng.integers(n)) for a in env.agents})
            inner = env.unwrapped
            lived.append(
                (
                    list(rewards.values()),
                    [
                        (agent, touch, cause)
                        for agent in inner.possible_agents
                        for touch, cause in zip(
                            inner.feedback(agent), inner.causes(agent), strict=True
                        )
                    ],
                )
            )
        env.close()
        replay = read_replay(tmp_path / "episode_00000.rrd", tried=True)
        assert len(replay) == len(lived) + 1
        for moment, (rewards, touches) in enumerate(lived, start=1):
            shown = replay.snapshot(moment)
            told = [(t.robot, t.feedback, t.cause) for t in shown.touches]
            assert told == touches
            assert shown.reward.tolist() == rewards
        return "with touches" if any(t for _, t in lived) else "without touches"

    explore(HOUSEHOLDS, check, few=2)


RULES = st.sampled_from(list(COMPONENTS["credit"]))

SPANS = st.lists(
    st.tuples(
        st.sampled_from("abc"), st.integers(0, 2), st.floats(0.0, 20.0), st.booleans()
    ),
    min_size=1,
    max_size=30,
)

TOUCHES = st.tuples(st.floats(-1.0, 1.0), *[st.floats(0.0, 1.0)] * 3)


def test_eligibility_is_a_share_whatever_the_rule(explore):
    """Of an accumulating trace it is a sum of shares, one for each time of a pair."""

    def check(case):
        name, spans, (value, felt, approached, turned) = case
        rule, history = COMPONENTS["credit"][name](), History()
        network, time = SituationNetwork(), 0.0
        for state, action, length, exploratory in spans:
            entry = Experience(
                state=state,
                action=action,
                next_state="a",
                time=time,
                next_time=time + length,
            )
            history.append(entry, exploratory=exploratory)
            network.count(state, action, "a")
            time += length
        at = history.entries[-1].time + felt * (time - history.entries[-1].time)
        touch = Reward(
            value=value,
            time=at,
            giver="ann",
            attending=turned > 0.5,
            approach_began=at * approached,
            attention_began=at * turned,
        )
        weights, designated = rule.weigh(touch, history, network)
        assert set(weights) <= set(range(len(history)))
        assert designated is None or designated in range(len(history))
        most = 1.0 / (1.0 - rule.decay) if name == "trace" else 1.0
        assert all(0.0 < weight <= most for weight in weights.values())
        return name

    explore(st.tuples(RULES, SPANS, TOUCHES), check, few=60)


class Corner:
    """A home turned about the origin and shifted."""

    def __init__(self, turn, shift):
        self.turn, self.shift = turn, shift

    def __call__(self, x, y):
        cos, sin = math.cos(self.turn), math.sin(self.turn)
        return (x * cos - y * sin + self.shift[0], x * sin + y * cos + self.shift[1])


BOTTLENECK = [
    *((0, 0, 8, 0), (8, 0, 8, 5), (8, 5, 0, 5), (0, 5, 0, 0)),
    *((4, 0, 4, 2), (4, 3, 4, 5)),
]
"""RiMEA's bottleneck (test 12), as small as a home: two rooms and a door of 1 m."""

AROUND_A_CORNER = [
    *((0, 0, 8, 0), (8, 0, 8, 5), (8, 5, 6, 5), (6, 5, 6, 2), (6, 2, 0, 2)),
    (0, 2, 0, 0),
]
"""RiMEA's corner (test 6): a corridor of 2 m that turns left."""

COUNTERFLOW = [(0, 0, 8, 0), (8, 0, 8, 2), (8, 2, 0, 2), (0, 2, 0, 0)]
"""RiMEA's counterflow (test 8), in a corridor of 2 m."""

WAYS = {
    "bottleneck": (
        BOTTLENECK,
        [(1.0, 1.0), (1.0, 2.5), (1.0, 4.0), (2.5, 2.5)],
        [(6.5, 1.0), (6.5, 2.5), (6.5, 4.0), (5.5, 2.5)],
    ),
    "corner": (
        AROUND_A_CORNER,
        [(0.7, 0.6), (0.7, 1.4), (1.9, 1.0)],
        [(7.0, 4.2), (7.0, 3.4), (7.0, 2.6)],
    ),
    "counterflow": (
        COUNTERFLOW,
        [(0.8, 0.6), (0.8, 1.4), (7.2, 0.6), (7.2, 1.4)],
        [(7.2, 0.6), (7.2, 1.4), (0.8, 0.6), (0.8, 1.4)],
    ),
}
"""Walls, where everybody starts and where everybody goes."""


def laid_out(name, place):
    """The plan, where everybody starts, and where everybody goes."""
    segments, starts, goals = WAYS[name]
    walls = tuple(Wall(start=place(*s[:2]), end=place(*s[2:])) for s in segments)
    spot, look = place(*starts[0]), place(starts[0][0] + 1.0, starts[0][1])
    plan = FloorPlan(
        name=name,
        walls=walls,
        regions=(Region(name="a", activity="playing", center=spot, facing=look),),
    )
    return plan, [place(*s) for s in starts], [place(*g) for g in goals]


def test_walks_never_cross_walls_however_the_home_is_turned_and_shifted(
    explore, deepest
):
    def check(case):
        name, turn, shift, speed = case
        plan, starts, goals = laid_out(name, Corner(turn, shift))
        n = len(starts)
        radius, mass = np.full(n, PERSON_RADIUS), np.full(n, PERSON_MASS)
        crowd = Crowd(plan, BodyParams(radius, mass, np.full(n, speed)), 0.2, 0.1)
        crowd.place(np.array(starts), np.zeros(n))
        for i, goal in enumerate(goals):
            crowd.send(i, goal)
        walls, before = plan.wall_segments, crowd.position.copy()
        for _ in range(200):
            crowd.advance()
            after = crowd.position.copy()
            for here, there in zip(before, after, strict=True):
                assert not any(crosses(*here, *there, wall) for wall in walls)
            assert deepest(plan, after, radius) <= OVERLAP
            before = after
        arrived = not any(crowd.walks(i) for i in range(n))
        return f"{name}: all arrived" if arrived else f"{name}: some on the way"

    ways = st.tuples(
        st.sampled_from(list(WAYS)),
        st.floats(0.0, 2 * math.pi) | st.sampled_from((0.0, math.pi / 2, math.pi / 4)),
        st.tuples(st.floats(-500.0, 500.0), st.floats(-500.0, 500.0)),
        st.floats(0.3, 3.0),
    )
    explore(ways, check, few=6)

"""Learners: made, taught, saved and loaded, from whatever somebody gives them."""

import dataclasses
import functools
import hashlib
import json
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import strategies as st

from household.perception.situation import Situation
from learners import CATALOG, Experience, LearnerError, Reward, load, make_learner
from learners.components import COMPONENTS, made
from learners.saving import files
from policies.learning import LearningRobot  # registers situations

from .plain_data import ODD, changed

BEHAVIORS, ENTRIES = 3, 50

EXTREME = (0.0, 1e-12, 1e-9, 1e-6, 0.5, 0.500001, 0.999999, 1.0, 2.0, 40.0, 1e9)

NUMBERS = st.one_of(
    st.floats(0.0, 1.0), st.floats(0.0, 10.0), st.integers(0, 9), st.just(0.3)
)

GENTLE, WILD = NUMBERS, st.one_of(NUMBERS, st.sampled_from(EXTREME), ODD)

assert LearningRobot


def _fields(make):
    kind = make.func if isinstance(make, functools.partial) else make
    if not dataclasses.is_dataclass(kind):
        return []
    return [field.name for field in dataclasses.fields(kind) if field.init]


@st.composite
def components(draw, setting, values):
    """A component of a setting, with some parameters of its own."""
    name = draw(st.sampled_from(list(COMPONENTS[setting])))
    names = _fields(COMPONENTS[setting][name])
    own = draw(st.dictionaries(st.sampled_from(names), values)) if names else {}
    return own | {"name": name}


@st.composite
def recipes(draw):
    """Name and settings of a learner."""
    values = draw(st.sampled_from((GENTLE, WILD)))
    name = draw(st.sampled_from(list(CATALOG)))
    needs = CATALOG[name].needs
    free = sorted(CATALOG[name].settings - set(needs))
    settings = {}
    for setting in draw(st.lists(st.sampled_from(free), max_size=3, unique=True)):
        known = setting in COMPONENTS
        settings[setting] = draw(components(setting, values) if known else values)
    return name, settings


def world(name):
    """What a learner of the catalog needs of the world."""
    every = {
        "ask": lambda reward, candidates: 0,
        "appropriateness": lambda state: np.linspace(-1.0, 1.0, BEHAVIORS),
        "cause": lambda reward: reward.time - 1.0,
    }
    return {need: every[need] for need in CATALOG[name].needs}


@st.composite
def situations(draw):
    """Up to three people and what they do."""
    names = draw(st.sampled_from((("ann",), ("ann", "ben"), ("ann", "ben", "cleo"))))
    roles = {each: draw(st.sampled_from(("playing", "reading"))) for each in names}
    pairs = [(each, "robot_0") for each in names]
    some = st.sets(st.sampled_from(pairs))
    return Situation.of(roles, draw(some), hears=draw(some))


LENGTHS = st.one_of(
    st.floats(0.0, 5.0), st.sampled_from((0.0, 5e-324, 1e-9, 59.0, 1e3, 1e9))
)


@st.composite
def entries(draw):
    """What somebody lives through: time, situation, touch, all as it may happen."""
    value = st.one_of(st.floats(-1.0, 1.0), st.sampled_from((1.0, -1.0, 5e-324)))
    share = st.floats(0.0, 1.0)
    touch = st.tuples(value, st.sampled_from(("ann", "ben")), share, share, share)
    return [
        (draw(situations()), draw(LENGTHS), draw(st.none() | touch))
        for _ in range(draw(st.integers(1, 8)))
    ]


def experiences(learner, lived):
    """Fifty entries of a life that repeats itself."""
    time, spans = 0.0, [(lived * (ENTRIES + 1))[i] for i in range(ENTRIES + 1)]
    for (state, length, touch), (following, *_) in pairwise(spans):
        end = time + length
        rewards = ()
        if touch is not None:
            value, giver, *shares = touch
            felt, approached, turned = (time + length * share for share in shares)
            felt = min(felt, end)
            rewards = (
                Reward(
                    value=value,
                    time=felt,
                    giver=giver,
                    attending=value > 0.5,
                    approach_began=min(approached, felt),
                    attention_began=min(turned, felt),
                ),
            )
        yield Experience(
            state=state,
            action=learner.act(state),
            next_state=following,
            time=time,
            next_time=end,
            rewards=rewards,
            attended=touch is not None,
        )
        time = end


def lives(learner, lived, others=()):
    """Lives through fifty entries; other learners must live the same."""
    for experience in experiences(learner, lived):
        learner.learn(experience)
        values = learner.q_values(experience.state)
        assert values.shape == (BEHAVIORS,)
        assert np.isfinite(values).all()
        assert all(w > 0.0 for credit in learner.credits for _, w in credit.shares)
        for other in others:
            assert other.act(experience.state) == experience.action
            other.learn(experience)
            assert other.q_values(experience.state).tobytes() == values.tobytes()


def one_line(error):
    said = str(error)
    assert said.isprintable(), said
    assert 0 < len(said) < 2500
    return said


def test_a_learner_is_refused_in_one_line_or_learns_and_goes_on_from_its_file(
    explore, tmp_path
):
    path = tmp_path / "learner.json"

    def check(data):
        (name, settings), lived = data
        try:
            learner = make_learner(
                name,
                BEHAVIORS,
                np.random.default_rng(1),
                **made(settings),
                **world(name),
            )
        except LearnerError as error:
            one_line(error)
            return "refused"
        lives(learner, lived)
        learner.save(path)
        again = load(path, **world(name))
        learner.start_episode()
        again.start_episode()
        lives(learner, lived, [again])
        return "accepted"

    explore(st.tuples(recipes(), entries()), check, few=60)


ODD_FIELDS = st.dictionaries(
    st.sampled_from([f.name for f in dataclasses.fields(Experience)]),
    ODD | st.lists(ODD, max_size=2).map(tuple),
    min_size=1,
    max_size=2,
)


def test_what_cannot_be_lived_through_is_refused_and_teaches_nothing(explore, tmp_path):
    usual = {
        "state": "s",
        "action": 0,
        "next_state": "t",
        "time": 1.0,
        "next_time": 2.0,
    }

    def check(data):
        name, fields = data
        learner = make_learner(name, BEHAVIORS, np.random.default_rng(1), **world(name))
        learner.save(tmp_path / "before.json")
        try:
            learner.learn(Experience(**(usual | fields)))
        except LearnerError as error:
            one_line(error)
            learner.save(tmp_path / "after.json")
            before, after = (tmp_path / f"{n}.json" for n in ("before", "after"))
            assert after.read_bytes() == before.read_bytes()
            return "refused"
        assert np.isfinite(learner.q_values("s")).all()
        return "accepted"

    explore(
        st.tuples(st.sampled_from(("q_social", "designated")), ODD_FIELDS),
        check,
        few=40,
    )


ODD_TOUCHES = st.dictionaries(
    st.sampled_from([f.name for f in dataclasses.fields(Reward)]),
    ODD,
    min_size=1,
    max_size=2,
)


def test_a_touch_that_cannot_be_is_refused_in_one_line(explore):
    usual = {"value": 1.0, "time": 1.0, "giver": "ann", "attending": True}

    def check(fields):
        try:
            Reward(**(usual | fields))
        except LearnerError as error:
            one_line(error)
            return "refused"
        return "accepted"

    explore(ODD_TOUCHES, check, few=60)


@pytest.fixture(scope="module")
def saved(tmp_path_factory):
    """The content of a file of each learner that has lived."""
    folder, contents = tmp_path_factory.mktemp("saved"), {}
    lived = [
        (
            Situation.of({"ann": "playing"}, [("ann", "robot_0")]),
            2.0,
            (1.0, "ann", 0.5, 0.2, 0.1),
        ),
        (Situation.of({"ann": "reading", "ben": "playing"}), 3.0, None),
        (Situation.of({"ben": "reading"}), 1.0, (-0.5, "ben", 0.9, 0.5, 0.5)),
    ]
    for name in CATALOG:
        learner = make_learner(name, BEHAVIORS, np.random.default_rng(1), **world(name))
        lives(learner, lived)
        learner.save(folder / f"{name}.json")
        text = (folder / f"{name}.json").read_text(encoding="utf-8")
        contents[name] = json.loads(text.splitlines()[1])
    return contents


def test_a_strangers_learner_is_refused_in_one_line_or_learns(explore, saved, tmp_path):
    path = tmp_path / "stranger.json"
    lived = [
        (
            Situation.of({"ann": "playing"}, [("ann", "robot_0")]),
            2.0,
            (1.0, "ann", 0.5, 0.2, 0.1),
        ),
        (
            Situation.of({"ann": "reading", "ben": "reading"}),
            3.0,
            (-1.0, "ben", 0.5, 0.2, 0.1),
        ),
    ]

    def check(case):
        name, data = case
        try:
            payload = json.dumps(data)
            digest = hashlib.sha256(payload.encode()).hexdigest()
        except (TypeError, ValueError):
            return "not JSON"
        header = {"format": files.FORMAT, "version": files.VERSION, "sha256": digest}
        path.write_text(f"{json.dumps(header)}\n{payload}\n", encoding="utf-8")
        try:
            learner = load(path, **world(name))
        except LearnerError as error:
            said = one_line(error)
            assert str(path) in said
            return "refused"
        if not (hasattr(learner, "learn") and learner.n_behaviors == BEHAVIORS):
            return "something else"
        learner.start_episode()
        lives(learner, lived)
        return "accepted"

    cases = st.sampled_from(list(saved)).flatmap(
        lambda name: st.tuples(st.just(name), changed(saved[name], None))
    )
    explore(cases, check, few=25)

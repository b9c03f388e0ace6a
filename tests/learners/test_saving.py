import json
from pathlib import Path

import numpy as np
import pytest

from learners import CATALOG, QLearner, load, make_learner, saved
from learners.analogy.carrying import Propagation
from learners.errors import SavedFileError
from learners.saving import VERSION, codec, encode


@pytest.mark.parametrize("name", CATALOG)
def test_a_loaded_learner_goes_on_exactly_as_the_saved_one(
    name, live, attached, tmp_path
):
    world = attached(name)
    learner = make_learner(name, 3, np.random.default_rng(1), **world)
    live(learner, 100, np.random.default_rng(2))
    learner.save(tmp_path / "learner.json")
    twin = load(tmp_path / "learner.json", **world)
    assert twin.credits == learner.credits
    ends = learner.history.entries[-1].next_time
    ways = [
        live(each, 500, np.random.default_rng(3), start=ends)
        for each in (learner, twin)
    ]
    assert ways[0] == ways[1]
    assert encode(learner) == encode(twin)


@pytest.fixture
def path(rng, live, tmp_path):
    learner = QLearner(3, rng)
    live(learner, 20, np.random.default_rng(1))
    learner.save(tmp_path / "learner.json")
    return tmp_path / "learner.json"


def test_equal_learners_give_equal_files(path, rng, live, tmp_path):
    learner = QLearner(3, np.random.default_rng(0))
    live(learner, 20, np.random.default_rng(1))
    learner.save(tmp_path / "again.json")
    assert (tmp_path / "again.json").read_bytes() == path.read_bytes()


def test_nothing_but_the_file_is_left_behind(path):
    assert [each.name for each in path.parent.iterdir()] == ["learner.json"]


def test_a_save_that_fails_keeps_what_was_there(path, entry, rng):
    class Secret:
        pass

    before = path.read_bytes()
    learner = QLearner(2, rng)
    learner.learn(entry(Secret()))
    with pytest.raises(SavedFileError, match="cannot save a Secret"):
        learner.save(path)
    assert path.read_bytes() == before
    assert len(list(path.parent.iterdir())) == 1


@pytest.mark.parametrize("keep", [0, 10, 60, 200, -2])
def test_a_file_cut_short_is_refused(path, keep):
    path.write_bytes(path.read_bytes()[:keep])
    with pytest.raises(SavedFileError, match=r"cut short|damaged"):
        load(path)


def test_a_damaged_file_is_refused(path):
    text = path.read_text("utf-8")
    path.write_text(text.replace('"gamma":0.1', '"gamma":0.7'), "utf-8")
    with pytest.raises(SavedFileError, match="damaged"):
        load(path)


def test_a_file_of_another_version_is_refused_with_both_versions(path):
    header, payload, _ = path.read_text("utf-8").split("\n")
    header = json.dumps(json.loads(header) | {"version": VERSION + 1})
    path.write_text(f"{header}\n{payload}\n", "utf-8")
    with pytest.raises(
        SavedFileError, match=f"version {VERSION + 1}.*this is {VERSION}"
    ):
        load(path)


@pytest.mark.parametrize("content", [b"\xff\xfe", b"[]\n{}\n", b'{"a": 1}\n{}\n'])
def test_what_is_not_a_saved_learner_is_refused(path, content):
    path.write_bytes(content)
    with pytest.raises(SavedFileError, match="not a saved learner"):
        load(path)


def test_a_learner_of_another_kind_is_refused(path):
    random_kind = CATALOG["random"].kind
    with pytest.raises(SavedFileError, match="holds a QLearner, not a RandomChoice"):
        random_kind.load(path)


def test_a_callable_into_the_world_must_be_given_again(rng, attached, tmp_path):
    learner = make_learner("advice", 2, rng, **attached("advice"))
    learner.save(tmp_path / "advice.json")
    with pytest.raises(SavedFileError, match="needs its 'ask' again"):
        load(tmp_path / "advice.json")


def test_states_may_be_nested_and_of_many_kinds(entry, rng, tmp_path):
    states = [
        ("a", (1, 2.5)),
        frozenset({("x", None), ("y", True)}),
        None,
        3,
        np.int64(7),
    ]
    learner = QLearner(2, rng)
    for time, state in enumerate(states):
        learner.learn(entry(state, 1, float(time), attended=True))
    learner.save(tmp_path / "learner.json")
    twin = QLearner.load(tmp_path / "learner.json")
    assert list(twin.table) == states
    assert twin.network.counts == learner.network.counts


class Spoken:
    """A state that says itself how it is saved."""

    def __init__(self, words):
        self.words = words

    def __hash__(self):
        return hash(self.words)

    def __eq__(self, other):
        return self.words == other.words

    def to_data(self):
        return {"words": self.words}

    @classmethod
    def from_data(cls, data):
        return cls(data["words"])


def test_a_state_can_provide_its_own_form(entry, rng, tmp_path):
    saved(Spoken)
    learner = QLearner(2, rng)
    learner.learn(entry(Spoken(("be", "quiet")), 1, 0.0))
    learner.save(tmp_path / "learner.json")
    assert list(load(tmp_path / "learner.json").table) == [Spoken(("be", "quiet"))]


def test_two_things_of_one_name_are_refused():
    impostor = type("QLearner", (), {"__module__": "elsewhere"})
    with pytest.raises(ValueError, match="two saved things"):
        saved(impostor)


@pytest.mark.parametrize("bits", [np.random.MT19937, np.random.Philox, np.random.SFC64])
def test_any_generator_of_numpy_is_saved(bits, live, tmp_path):
    learner = QLearner(3, np.random.Generator(bits(5)))
    learner.save(tmp_path / "learner.json")
    twin = load(tmp_path / "learner.json")
    ways = [live(each, 50, np.random.default_rng(1)) for each in (learner, twin)]
    assert ways[0] == ways[1]


def test_another_programs_file_is_refused_by_its_format(path):
    header, payload, _ = path.read_text("utf-8").split("\n")
    header = json.dumps(json.loads(header) | {"format": "recipe"})
    path.write_text(f"{header}\n{payload}\n", "utf-8")
    with pytest.raises(SavedFileError, match="its format is 'recipe'"):
        load(path)


def test_a_class_that_is_not_registered_on_loading_is_named(
    entry, rng, tmp_path, monkeypatch
):
    saved(Spoken)
    learner = QLearner(2, rng)
    learner.learn(entry(Spoken("hush"), 1, 0.0))
    learner.save(tmp_path / "learner.json")
    monkeypatch.delitem(codec._registry, "Spoken")
    with pytest.raises(SavedFileError, match="needs 'Spoken': import it"):
        load(tmp_path / "learner.json")


@saved
def as_the_other(state):
    return [state.swapped("ann", "bob")]


def test_an_operator_of_ones_own_is_saved_by_its_name(rng, live, tmp_path):
    analogy = Propagation(operators=(as_the_other,))
    learner = QLearner(3, rng, analogy=analogy)
    live(learner, 20, np.random.default_rng(1))
    learner.save(tmp_path / "learner.json")
    assert load(tmp_path / "learner.json").analogy.operators == (as_the_other,)


OLDER = Path(__file__).parent / "older"
"""Learners saved in version 1 of the format, and what they chose from there on."""

CHOSEN = json.loads((OLDER / "expected.json").read_text("utf-8"))


@pytest.mark.parametrize("name", CHOSEN)
def test_a_learner_saved_in_an_older_version_goes_on_as_it_would_have(name, live):
    learner = load(OLDER / f"{name}.json")
    ends = learner.history.entries[-1].next_time
    rng, n = np.random.default_rng(3), len(CHOSEN[name])
    # People did not take any time to react then.
    chosen = live(learner, n, rng, start=ends, late=0.0)
    assert chosen == CHOSEN[name]
    assert type(learner) is CATALOG[name].kind

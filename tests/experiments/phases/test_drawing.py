"""Which households a trial is about."""

import pytest

from experiments.phases import splits
from experiments.phases.drawing import probed_in, trained_in
from experiments.phases.records import Phases, Probing, Training
from experiments.phases.splits import read
from experiments.phases.world import World

DAYS = World(people=2, days=True)


def condition(world=DAYS, **probing):
    training = Training(world=world, households=3)
    return Phases(
        name="a",
        learner="random",
        training=training,
        probing=Probing(world=world, households=3, **probing),
    )


def test_nothing_new_means_the_households_of_training():
    one = condition()
    assert probed_in(one, 4) == trained_in(one.training, 4)


@pytest.mark.parametrize("new", ["people", "home", "roles"])
def test_what_is_new_is_from_the_test_and_all_else_from_training(new):
    one = condition(new=(new,))
    before, after = trained_in(one.training, 4), probed_in(one, 4)
    known = {
        "people": {each for r in before for each in r.people},
        "home": {r.home for r in before},
        "roles": {each for r in before for each in r.roles},
    }
    tested = read("test", final=True)
    for old, other in zip(before, after, strict=True):
        for factor in ("people", "home", "roles"):
            same = getattr(old, factor) == getattr(other, factor)
            assert same == (factor != new)
    values = {getattr(r, new) for r in after}
    values = values if new == "home" else {each for v in values for each in v}
    lists = {"people": tested.people, "home": tested.homes, "roles": tested.roles}
    assert values <= set(lists[new])
    assert not values & known[new]


def test_a_swap_exchanges_days_two_by_two():
    one = condition(new=("swap",))
    (before, *_), (after, *_) = trained_in(one.training, 4), probed_in(one, 4)
    assert after.people == before.people
    assert after.roles[0] == before.roles[0][::-1]


def test_acquaintances_stay():
    four = World(people=4)
    one = condition(four, new=("people",), acquaintances=2)
    for before, after in zip(
        trained_in(one.training, 0), probed_in(one, 0), strict=True
    ):
        assert after.people[:2] == before.people[:2]
        assert not set(after.people[2:]) & set(before.people)


def test_conditions_with_the_same_seed_meet_the_same_strangers():
    one, other = condition(new=("people",)), condition(new=("people", "home"))
    assert [r.people for r in probed_in(one, 7)] == [
        r.people for r in probed_in(other, 7)
    ]


def test_people_of_the_test_live_in_groups_that_are_the_same_for_all_seeds():
    groups = {
        r.people for s in range(40) for r in probed_in(condition(new=("people",)), s)
    }
    assert len(groups) == 16  # 32 people, two by two


def test_validation_does_not_read_the_test(monkeypatch):
    asked = []
    original = splits._read

    def watched(split):
        asked.append(split)
        return original(split)

    monkeypatch.setattr(splits, "_read", watched)
    one = condition(new=("people", "home", "roles"), split="validation")
    trained_in(one.training, 1)
    probed_in(one, 1)
    assert set(asked) == {"train", "validation"}

"""Teachers change what people give, and nothing else of an experiment."""

import pytest

from experiments.paper import EXPERIMENTS
from experiments.running.trial import describe_condition
from experiments.studies import teachers
from household.scenario.persona import load_persona


@pytest.fixture(params=[1, 5])
def base(request):
    return EXPERIMENTS[request.param].conditions[0]


def test_the_own_people_are_the_experiments_own(base):
    own = describe_condition(teachers.taught(base, teachers.OWN))
    assert own | {"factors": {}} == describe_condition(base)


def test_a_teacher_gives_feedback_like_its_persona_and_looks_as_before(base):
    before = describe_condition(base)["personas"]
    after = describe_condition(teachers.taught(base, "praising"))["personas"]
    like = load_persona("praising")
    for one, other in zip(before, after, strict=True):
        changed = {name for name in one if one[name] != other[name]}
        assert changed <= set(teachers.FEEDBACK)
        assert "sanction" in changed
        assert all(other[name] == getattr(like, name) for name in teachers.FEEDBACK)


def test_conditions_that_no_claim_is_about_are_not_run():
    names = [one.name for one in teachers.study(4, (0,)).conditions]
    assert names == [f"{teacher}+designated" for teacher in teachers.TEACHERS]


def test_claims_without_trials_are_left_out():
    assert {claim.id for claim in teachers.mapped(EXPERIMENTS[4])} == {"4a", "4b"}

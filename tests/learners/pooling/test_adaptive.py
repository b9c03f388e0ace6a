import numpy as np
import pytest

from learners.errors import ParameterError
from learners.expectation import ExpectedTouch
from learners.pooling import AdaptivePooling, FullPooling, NoPooling
from learners.representation import Views


@pytest.fixture
def pooling():
    return AdaptivePooling(prior_trust=0.5, prior_weight=1.0, noise=1.0)


def test_a_stranger_is_trusted_as_people_at_large(pooling):
    assert pooling.terms(0.0, "eve")[0] == 0.5
    pooling.compare("ann", 1.0, 1.0, 1.0)
    assert pooling.trust_in("eve") == pytest.approx((0.5 + 1) / (1 + 1))
    assert pooling.terms(0.0, "eve")[0] == pytest.approx(0.75)


def test_agreement_draws_people_together_and_disagreement_apart(pooling):
    pooling.compare("ann", 1.0, 1.0, 1.0)
    agreed = pooling.terms(1.0, "ann")[0]
    for _ in range(3):
        pooling.compare("ann", -1.0, 1.0, 1.0)
    assert pooling.terms(1.0, "ann")[0] == 0.0 < agreed


def test_silence_where_others_touch_is_doubt(pooling):
    pooling.compare("ann", 0.0, 1.0, 1.0)
    assert pooling.trust_in("ann") < 0.5


def lived(pooling, tastes, toy, entry, touch):
    """A learner of a home where each person judges two behaviors by its taste.

    Everybody reads, in turn and often.
    """
    learner = ExpectedTouch(
        2,
        np.random.default_rng(0),
        representation=Views(),
        pooling=pooling,
        counts="exposures",
    )
    for time in range(120):
        name, action = ("ann", "bob", "joe")[time % 3], time // 3 % 2
        felt = touch(value=tastes[name][action], time=time + 1.0, giver=name)
        learner.learn(entry(toy(f"{name} reads"), action, float(time), felt))
    return learner


def test_adaptive_pooling_carries_over_where_people_agree_and_not_where_they_differ(
    toy, entry, touch
):
    alike = dict.fromkeys(("ann", "bob", "joe"), (1.0, -1.0))
    apart = {"ann": (1.0, -1.0), "bob": (-1.0, 1.0), "joe": (1.0, -1.0)}
    eve, bob = toy("eve reads"), toy("bob reads")
    values = {}
    for kind in (NoPooling, FullPooling, AdaptivePooling):
        values[kind] = [
            lived(kind(), tastes, toy, entry, touch).q_values(state)
            for tastes, state in ((alike, eve), (apart, bob))
        ]
    # a stranger is taken to be like all others; NoPooling knows nothing of her
    assert values[NoPooling][0].tolist() == [0.0, 0.0]
    np.testing.assert_allclose(values[AdaptivePooling][0], [1.0, -1.0], atol=0.1)
    # bob is left what he is, while FullPooling outvotes him
    assert values[FullPooling][1].argmax() == 0
    np.testing.assert_allclose(values[AdaptivePooling][1], [-1.0, 1.0], atol=0.05)


@pytest.mark.parametrize(
    "make",
    [
        lambda: AdaptivePooling(prior_trust=1.1),
        lambda: AdaptivePooling(prior_weight=0.0),
        lambda: AdaptivePooling(noise=0.0),
    ],
)
def test_an_adaptive_pooling_out_of_range_is_refused(make):
    with pytest.raises(ParameterError):
        make()

import numpy as np
import pytest

from learners import QLearner
from learners.analogy.adaptive import AdaptiveAnalogy
from learners.analogy.carrying import Analogy
from learners.credit.rules import Immediate
from learners.errors import ParameterError
from learners.exploration import Softmax
from learners.representation.situations import Canonical


@pytest.fixture
def phone(toy):
    return toy("ann reads, bob calls")


@pytest.fixture
def swapped(phone):
    return phone.swapped("ann", "bob")


@pytest.fixture
def analogy():
    return AdaptiveAnalogy(prior_trust=0.5, prior_weight=2.0, noise=0.5)


@pytest.fixture
def learner(rng, analogy):
    return QLearner(2, rng, gamma=0.0, analogy=analogy)


def test_trust_begins_at_the_prior(analogy, phone):
    assert analogy.trust(phone) == 0.5


def test_agreement_raises_the_trust_in_both_all_and_the_giver(
    analogy, phone, swapped, entry, touch
):
    analogy.observe(entry(phone, 0), touch(value=-1.0, giver="bob"), 1.0)
    assert analogy.trust(phone) == 0.5  # nothing to compare with yet
    analogy.observe(entry(swapped, 0), touch(value=-1.0, giver="ann"), 1.0)
    everybody = (2 * 0.5 + 1) / (2 + 1)
    assert analogy.trust_in("bob") == pytest.approx(everybody)
    assert analogy.trust_in("ann") == pytest.approx((2 * everybody + 1) / 3)


def test_disagreement_takes_all_trust_but_no_more(
    analogy, phone, swapped, entry, touch
):
    analogy.observe(entry(phone, 0), touch(value=-1.0, giver="bob"), 1.0)
    for _ in range(2):
        analogy.observe(entry(swapped, 0), touch(value=1.0, giver="ann"), 1.0)
    assert analogy.trust_in("ann") == 0.0
    assert analogy.trust_in("bob") == 0.0
    assert analogy.trust(phone) == 0.0


def test_what_the_same_state_was_told_is_no_agreement(analogy, phone, entry, touch):
    for _ in range(5):
        analogy.observe(entry(phone, 0), touch(value=-1.0, giver="bob"), 1.0)
    assert analogy.trust(phone) == 0.5


def test_silence_under_attention_where_others_tapped_is_weak_doubt(
    analogy, phone, swapped, entry, touch
):
    analogy.observe(entry(phone, 0), touch(value=-1.0, giver="bob"), 1.0)
    analogy.observe(entry(swapped, 0), None, 1.0)
    assert analogy.trust(phone) == 0.5  # nobody attended
    analogy.observe(entry(swapped, 0, attended=True), None, 1.0)
    assert analogy.trust(phone) == pytest.approx(1.0 / 2.1)


def test_a_state_is_trusted_as_far_as_its_least_typical_person(
    analogy, toy, phone, swapped, entry, touch
):
    analogy.observe(entry(phone, 0), touch(value=-1.0, giver="bob"), 1.0)
    analogy.observe(entry(swapped, 0), touch(value=0.5, giver="ann"), 1.0)
    everybody, ann = (1.0 - 0.5) / 3, (2 * (0.5 / 3) - 0.5) / 3
    assert analogy.trust_in("eve") == pytest.approx(everybody)
    assert ann < 0 < everybody
    assert analogy.trust(toy("bob reads, eve calls")) == pytest.approx(everybody)
    assert analogy.trust(toy("ann reads, eve calls")) == 0.0


def test_an_unvisited_analog_reads_the_class_as_far_as_it_is_trusted(
    learner, phone, swapped, entry, touch
):
    learner.learn(entry(phone, 0, 0.0, touch(value=-1.0, time=1.0, giver="bob")))
    np.testing.assert_allclose(learner.q_values(swapped), [-0.5, 0.0])


def test_ones_own_touches_count_for_more_than_the_others(
    learner, phone, swapped, entry, touch
):
    learner.learn(entry(phone, 0, 0.0, touch(value=-1.0, time=1.0, giver="bob")))
    learner.learn(entry(swapped, 0, 1.0, touch(value=1.0, time=2.0, giver="ann")))
    # ann contradicts: trust (1 - 1) / 3 = 0 for all, so each reads its own row
    np.testing.assert_allclose(learner.q_values(swapped), [1.0, 0.0])
    np.testing.assert_allclose(learner.q_values(phone), [-1.0, 0.0])


def people(taste_of_ann, taste_of_bob):
    """What the one on the phone thinks of behaviors 0, 1 and 2, per state."""
    return {"ann": taste_of_ann, "bob": taste_of_bob}


def taps_and_caresses(component, tastes, toy, entry, touch, seed):
    """Value of what was done in phase 2, after bob's calls came ann's."""
    rng = np.random.default_rng(seed)
    learner = QLearner(
        3,
        rng,
        gamma=0.0,
        **component,
        credit=Immediate(),
        exploration=Softmax(temperature=0.1),
    )
    time, total = 0.0, 0.0
    for caller, reader, steps in (("bob", "ann", 40), ("ann", "bob", 20)):
        for step in range(steps):
            place = step % 5  # five places the caller can be at: five situations
            state = toy(f"{reader} reads, {caller} calls{place}")
            action = learner.act(state)
            value = tastes[caller](place, action)
            felt = touch(value=value, time=time + 1.0, giver=caller)
            learner.learn(entry(state, action, time, felt))
            total += value if caller == "ann" else 0.0
            time += 1.0
    return total / 20


def right(place, action):
    return 1.0 if action == place % 3 else -1.0


def contrary(place, action):
    return 1.0 if action == (place + 1) % 3 else -1.0


@pytest.fixture
def phase_2(toy, entry, touch):
    def mean(kind, tastes):
        setting = "representation" if kind is Canonical else "analogy"
        runs = [
            taps_and_caresses({setting: kind()}, tastes, toy, entry, touch, seed)
            for seed in range(20)
        ]
        return float(np.mean(runs))

    return mean


def test_adaptive_analogy_gains_where_people_agree(phase_2):
    agree = people(right, right)
    assert phase_2(AdaptiveAnalogy, agree) > phase_2(Analogy, agree) + 0.3
    assert phase_2(AdaptiveAnalogy, agree) > phase_2(Canonical, agree) - 0.15


def test_adaptive_analogy_does_less_harm_than_a_blind_one_where_people_differ(phase_2):
    differ = people(contrary, right)
    assert phase_2(AdaptiveAnalogy, differ) > phase_2(Canonical, differ) + 0.6
    assert phase_2(AdaptiveAnalogy, differ) > phase_2(Analogy, differ) - 0.15


@pytest.mark.parametrize(
    "make",
    [
        lambda: AdaptiveAnalogy(prior_trust=1.1),
        lambda: AdaptiveAnalogy(prior_weight=0.0),
        lambda: AdaptiveAnalogy(noise=0.0),
        lambda: AdaptiveAnalogy(silence=-0.1),
    ],
)
def test_an_adaptive_analogy_out_of_range_is_refused(make):
    with pytest.raises(ParameterError):
        make()

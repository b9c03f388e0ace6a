import math

import numpy as np
import pytest

from learners.baselines.advise import Advise
from learners.baselines.coach import Coach, DelayedTrace
from learners.baselines.delay_density import DelayDensity
from learners.baselines.e_coach import ECoach
from learners.baselines.fixed_shift import FixedShift
from learners.baselines.hysteretic import Hysteretic
from learners.baselines.i_sabl import ISabl
from learners.baselines.sign_asymmetric import SignAsymmetric
from learners.baselines.skip_silence import SkipSilence
from learners.baselines.symmetric import SymmetricQ
from learners.baselines.tamer import Tamer
from learners.baselines.travel_posterior import TravelPosterior
from learners.baselines.uniform_window import UniformWindow
from learners.credit.history import History
from learners.credit.rules import Immediate
from learners.credit.transitions import SituationNetwork
from learners.errors import ParameterError
from learners.representation.situations import Canonical
from learners.tabular.rates import ConstantRate

HALF = {"gamma": 0.0, "rate": ConstantRate(alpha=0.5)}


@pytest.fixture
def history(entry):
    """Entries of one second each: a, b, c, d."""
    history = History()
    for time, state in enumerate("abcd"):
        history.append(entry(state, 0, float(time)))
    return history


def weigh(rule, reward, history):
    return rule.weigh(reward, history, SituationNetwork())


def test_skipping_silence_forgets_nothing(entry, touch, rng):
    learner = SkipSilence(2, rng, **HALF)
    learner.learn(entry("s", 0, 0.0, touch(time=1.0)))
    for time in range(1, 9):
        learner.learn(entry("s", 0, float(time)))
    assert learner.q_values("s")[0] == 0.5
    assert learner.table.visits("s") == [1.0, 0.0]


def test_hysteresis_is_slow_to_believe_a_tap(entry, touch, rng):
    learner = Hysteretic(2, rng, decrease=0.1, **HALF)
    learner.learn(entry("s", 0, 0.0, touch(value=1.0, time=1.0)))
    learner.learn(entry("s", 0, 1.0, touch(value=-1.0, time=2.0)))
    # 0.5, then 0.5 + 0.5 * 0.1 * (-1 - 0.5)
    assert learner.q_values("s")[0] == pytest.approx(0.425)


def test_each_sign_has_its_own_factor(entry, touch, rng):
    learner = SignAsymmetric(2, rng, caress=0.5, tap=1.0, silence=0.1, **HALF)
    learner.learn(entry("s", 0, 0.0, touch(value=1.0, time=1.0)))
    assert learner.q_values("s")[0] == pytest.approx(0.25)
    learner.learn(entry("s", 0, 1.0))
    assert learner.q_values("s")[0] == pytest.approx(0.25 * 0.95)
    learner.learn(entry("t", 0, 2.0, touch(value=-1.0, time=3.0)))
    assert learner.q_values("t")[0] == pytest.approx(-0.5)


def test_a_fixed_shift_credits_what_was_in_force_then(history, touch):
    assert weigh(FixedShift(delay=2.0), touch(time=3.5), history) == ({1: 1.0}, 1)


def test_a_uniform_window_credits_by_the_share_of_its_time(history, touch):
    rule = UniformWindow(nearest=0.5, furthest=2.5)  # 1.0 to 3.0
    weights, _ = weigh(rule, touch(time=3.5), history)
    assert weights == {1: 0.5, 2: 0.5}
    rule = UniformWindow(nearest=0.25, furthest=1.25)  # 2.25 to 3.25
    weights, designated = weigh(rule, touch(time=3.5), history)
    assert weights == {2: 0.75, 3: 0.25}
    assert designated == 2


def test_a_window_before_the_history_credits_nothing(history, touch):
    rule = UniformWindow(nearest=4.0, furthest=6.0)
    assert weigh(rule, touch(time=3.5), history) == ({}, None)


def test_a_uniform_window_credits_nothing_that_took_no_time_to_speak_of(entry, touch):
    history = History()
    history.append(entry("s", 1, 0.0, next_time=5e-324))  # 5e-324 / 4 is 0.
    history.append(entry("s", 0, 5e-324, next_time=1.0))
    rule = UniformWindow(nearest=0.0, furthest=4.0)
    assert weigh(rule, touch(time=1.0), history) == ({1: 0.25}, 1)


def test_the_delay_density_is_an_erlang_distribution():
    # shape 2, scale 1: 1 - exp(-x) * (1 + x)
    density = DelayDensity(shape=2, scale=1.0)
    assert density.cumulative(1.0) == pytest.approx(1 - 2 / math.e)
    assert density.cumulative(-1.0) == 0.0


def test_the_delay_density_credits_each_entry_by_its_probability(entry, touch):
    history = History()
    history.append(entry("a", 0, 0.0))
    history.append(entry("b", 0, 1.0))
    weights, designated = weigh(
        DelayDensity(shape=1, scale=1.0), touch(time=2.0), history
    )
    near, far = 1 - math.exp(-1), math.exp(-1) - math.exp(-2)
    assert weights == {
        0: pytest.approx(far / (near + far)),
        1: pytest.approx(near / (near + far)),
    }
    assert designated == 1


def test_of_entries_too_short_for_floating_point_none_is_meant_by_more_than_itself(
    entry, touch
):
    rng = np.random.default_rng(0)
    for _ in range(2000):
        history, time = History(), 0.0
        for length in 1e-8 * rng.random(rng.integers(1, 5)):
            history.append(entry("a", 0, time, next_time=time + length))
            time += length
        weights, _ = weigh(DelayDensity(), touch(time=time), history)
        assert all(0.0 < weight <= 1.0 for weight in weights.values())


@pytest.fixture
def phone_history(entry):
    """A bark from 0 to 2 s, then sleep: the giver walks from 3 to 8 s."""
    history = History()
    history.append(entry("phone", 1, 0.0, next_time=2.0))
    history.append(entry("phone", 0, 2.0, next_time=3.0))
    history.append(entry("walk", 0, 3.0, next_time=8.0))
    return history


def test_the_travel_posterior_looks_before_the_giver_set_out(phone_history, touch):
    tap = touch(value=-1.0, time=7.5, approach_began=3.5, attention_began=0.5)
    weights, designated = weigh(TravelPosterior(), tap, phone_history)
    assert designated in (0, 1)
    assert weights.get(2, 0.0) < 0.25
    assert sum(weights.values()) == pytest.approx(1.0)
    exact, _ = weigh(TravelPosterior(noise=0.0), tap, phone_history)
    assert 2 not in exact


def test_the_travel_posterior_worked_by_hand(phone_history, touch):
    tap = touch(value=-1.0, time=7.5, approach_began=3.0, attention_began=0.0)
    rule = TravelPosterior(reaction=1.0, spread=1.0, late=0.0, noise=0.0)
    # mode exp(-1) = 0.368 s: 2 to 3 s holds it; of 0 to 2 s the likeliest delay is 1 s
    near = math.exp(-0.5) / math.exp(-1)  # density at the mode, times sqrt(2 pi)
    far = 1.0
    weights, _ = weigh(rule, tap, phone_history)
    assert weights[1] == pytest.approx(near / (near + far))
    assert weights[0] == pytest.approx(far / (near + far))


def test_a_giver_noticed_late_is_judged_as_if_it_had_been_noticed_at_once(
    phone_history, touch
):
    at_once = touch(value=-1.0, time=7.5, approach_began=3.0, attention_began=0.0)
    late = touch(value=-1.0, time=7.5, approach_began=3.7, attention_began=0.7)
    keen, slow = (TravelPosterior(late=t, noise=0.0) for t in (0.0, 0.7))
    expected = weigh(keen, at_once, phone_history)
    found = weigh(slow, late, phone_history)
    assert found.weights == pytest.approx(expected.weights)
    assert found.designated == expected.designated


def test_who_notices_inexactly_averages_over_when_the_giver_set_out(
    phone_history, touch
):
    """By hand: 20,000 draws of when it set out, in place of seven nodes."""
    tap = touch(value=-1.0, time=7.5, approach_began=3.5, attention_began=0.5)
    rule = TravelPosterior(noise=0.4)
    exact = TravelPosterior(noise=0.0, late=0.0)
    drawn = np.random.default_rng(1).normal(3.0, 0.4, 20_000)
    mode = math.exp(-(rule.spread**2))
    likely = np.zeros(3)
    for index, entry in enumerate(phone_history.entries):
        for set_out in drawn[drawn > entry.time]:
            likely[index] += exact._likelihood(entry, set_out, 0.0, mode)
    weights, _ = weigh(rule, tap, phone_history)
    found = [weights.get(index, 0.0) for index in range(3)]
    assert found == pytest.approx(likely / likely.sum(), abs=0.04)


def test_what_was_only_heard_counts_for_less(phone_history, touch):
    seen = touch(time=7.5, approach_began=3.0, attention_began=0.0)
    late = touch(time=7.5, approach_began=3.0, attention_began=2.5)
    rule = TravelPosterior(unseen=0.1)
    first = weigh(rule, seen, phone_history).weights[0]
    assert weigh(rule, late, phone_history).weights.get(0, 0.0) < first


def test_a_giver_at_hand_judges_what_just_went_on(phone_history, touch):
    tap = touch(value=-1.0, time=7.5, attention_began=3.0)
    assert weigh(TravelPosterior(), tap, phone_history).designated == 2


def test_tamer_predicts_the_touch_from_all_that_it_may_be_about(entry, touch, rng):
    learner = Tamer(2, rng, credit=Immediate(), step=0.5)
    learner.learn(entry("s", 1, 0.0, touch(value=-1.0, time=1.0)))
    learner.learn(entry("s", 1, 1.0, touch(value=-1.0, time=2.0)))
    assert learner.q_values("s").tolist() == [0.0, pytest.approx(-0.75)]


def test_tamer_shares_the_error_among_entries(entry, touch, rng):
    learner = Tamer(2, rng, credit=UniformWindow(nearest=0.0, furthest=2.0), step=0.5)
    learner.learn(entry("a", 0, 0.0))
    learner.learn(entry("b", 0, 1.0, touch(value=1.0, time=2.0)))
    # half the touch is about each: both move by 0.5 * 0.5 * (1 - 0)
    assert learner.q_values("a")[0] == pytest.approx(0.25)
    # now 0.5 * 0 + 0.5 * 0.25 is predicted for c and b
    learner.learn(entry("c", 0, 2.0, touch(value=1.0, time=3.0)))
    assert learner.q_values("b")[0] == pytest.approx(0.25 + 0.25 * 0.875)


def test_tamer_does_not_learn_from_silence(entry, rng):
    learner = Tamer(2, rng)
    learner.learn(entry("s", 0, 0.0))
    assert len(learner.table) == 0


def test_coach_moves_along_the_gradient_of_the_policy(entry, touch, rng):
    learner = Coach(2, rng, step=0.4)
    learner.learn(entry("s", 1, 0.0, touch(value=0.5, time=1.0)))
    # 0.4 * 0.5 * (0 - 1/2) and 0.4 * 0.5 * (1 - 1/2)
    assert learner.q_values("s") == pytest.approx([-0.1, 0.1])


def test_the_trace_of_coach_fades_from_the_delay_on(history, touch):
    weights, designated = weigh(
        DelayedTrace(delay=1.0, decay=0.5), touch(time=3.5), history
    )
    assert weights == {2: 1.0, 1: 0.5, 0: 0.25}
    assert designated == 2


def test_e_coach_credits_the_whole_episode_and_discounts_by_its_steps(
    entry, touch, rng
):
    learner = ECoach(2, rng, step=0.4, gamma=0.5, episode=2)
    learner.learn(entry("a", 1, 0.0))
    learner.learn(entry("b", 1, 1.0, touch(value=1.0, time=2.0)))
    # one step since the episode began: 0.4 * 0.5^1 * (1 - 1/2), in a and b alike
    assert learner.q_values("a") == pytest.approx([-0.1, 0.1])
    assert learner.q_values("b") == pytest.approx([-0.1, 0.1])
    learner.learn(entry("c", 1, 2.0, touch(value=1.0, time=3.0)))  # a new episode
    assert learner.q_values("c") == pytest.approx([-0.2, 0.2])
    assert learner.q_values("a") == pytest.approx([-0.1, 0.1])


def test_advise_counts_votes(entry, touch, rng):
    learner = Advise(2, rng, consistency=0.8)
    learner.learn(entry("s", 1, 0.0, touch(value=1.0, time=1.0)))
    # 0.8^1 : 0.2^1, then 0.8^2 : 0.2^2
    assert learner.q_values("s") == pytest.approx([0.2, 0.8])
    learner.learn(entry("s", 1, 1.0, touch(value=1.0, time=2.0)))
    assert learner.q_values("s") == pytest.approx([0.04 / 0.68, 0.64 / 0.68])


def test_advise_draws_from_its_policy(entry, touch, rng):
    learner = Advise(2, rng, consistency=0.8)
    learner.learn(entry("s", 1, 0.0, touch(value=1.0, time=1.0)))
    share = np.mean([learner.act("s") for _ in range(2000)])
    assert share == pytest.approx(0.8, abs=0.03)


def test_i_sabl_worked_by_hand(entry, touch, rng):
    learner = ISabl(2, rng, error=0.2)
    learner.learn(entry("s", 0, 0.0, touch(value=1.0, time=1.0)))
    # silence at 1/2 each: right 0.8 * 0.5, wrong 0.2 * 0.5; ratio 4 to 1
    assert learner.q_values("s") == pytest.approx([0.8, 0.2])
    learner.learn(entry("s", 0, 1.0, attended=True))  # says nothing yet
    assert learner.q_values("s") == pytest.approx([0.8, 0.2])


def test_i_sabl_learns_that_those_who_only_punish_approve_by_silence(entry, touch, rng):
    learner = ISabl(2, rng)
    for step in range(60):
        action = step % 2  # behavior 1 is tapped, behavior 0 passes in silence
        felt = (touch(value=-1.0, time=step + 1.0),) if action else ()
        learner.learn(entry(step % 3, action, float(step), *felt, attended=True))
    assert learner.silence_right > 0.8
    assert learner.silence_wrong < 0.2
    learner.learn(entry("new", 0, 60.0, attended=True))
    assert learner.q_values("new")[0] > 0.7  # silence alone tells it


def test_i_sabl_makes_nothing_of_silence_when_nobody_attends(entry, rng):
    learner = ISabl(2, rng)
    learner.learn(entry("s", 0, 0.0))
    assert len(learner.table) == 0


def test_symmetric_q_ties_the_orbit(toy, entry, touch, rng):
    learner = SymmetricQ(2, rng, **HALF)
    assert learner.representation == Canonical()
    state = toy("ann reads, bob calls")
    learner.learn(entry(state, 1, 0.0, touch(value=-1.0, time=1.0)))
    assert learner.q_values(state.swapped("ann", "bob"))[1] == -0.5


@pytest.mark.parametrize(
    "make",
    [
        lambda rng: Hysteretic(2, rng, decrease=1.1),
        lambda rng: SignAsymmetric(2, rng, tap=-0.1),
        lambda rng: Tamer(2, rng, step=2.0),
        lambda rng: Coach(2, rng, step=0.0),
        lambda rng: ECoach(2, rng, episode=0),
        lambda rng: Advise(2, rng, consistency=0.5),
        lambda rng: ISabl(2, rng, error=0.5),
        lambda _: FixedShift(delay=-1.0),
        lambda _: UniformWindow(nearest=2.0, furthest=1.0),
        lambda _: DelayDensity(shape=0),
        lambda _: TravelPosterior(unseen=1.1),
    ],
)
def test_a_baseline_out_of_range_is_refused(make, rng):
    with pytest.raises(ParameterError):
        make(rng)


@pytest.mark.parametrize("rule", [TravelPosterior(), DelayDensity()])
def test_a_touch_no_later_than_all_entries_is_about_the_latest(rule, entry, touch):
    history = History()
    history.append(entry("a", 0, 0.0))
    assert weigh(rule, touch(time=0.0), history) == ({0: 1.0}, 0)

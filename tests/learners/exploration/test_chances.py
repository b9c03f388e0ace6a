import numpy as np
import pytest

from learners.exploration import (
    EpsilonGreedy,
    Estimates,
    Greedy,
    SeekCompany,
    Softmax,
    Thompson,
    UpperConfidence,
    chances,
)

KNOWN = Estimates([0.3, -0.2, 0.3, 0.1], [4.0, 1.0, 2.0, 9.0], [0.3, 0.5, 0.2, 0.1])
RULES = (Greedy(), EpsilonGreedy(epsilon=0.3), Softmax(), UpperConfidence(), Thompson())


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: type(rule).__name__)
def test_chances_are_the_shares_of_many_choices(rule, rng):
    chosen = [rule.choose(KNOWN, rng) for _ in range(6000)]
    shares = np.bincount(chosen, minlength=4) / 6000
    assert chances(rule, KNOWN) == pytest.approx(shares, abs=0.025)
    assert chances(rule, KNOWN).sum() == pytest.approx(1.0)


def test_a_behavior_never_tried_comes_first_under_upper_confidence():
    untried = Estimates([0.3, 0.0], [4.0, 0.0])
    assert chances(UpperConfidence(), untried).tolist() == [0.0, 1.0]


def test_the_chances_of_a_users_own_rule_are_not_known_until_it_is_registered():
    class Mine:
        pass

    assert chances(Mine(), KNOWN) is None
    chances.register(Mine, lambda rule, estimates: np.full(4, 0.25))
    assert chances(Mine(), KNOWN).tolist() == [0.25] * 4


def known_company():
    rule = SeekCompany(among=Greedy())
    for action, found, times in ((0, True, 6), (0, False, 3), (1, False, 4)):
        for _ in range(times):
            rule.note(action, found=found)
    return rule


def test_chances_of_seeking_company_are_the_shares_of_many_choices(rng):
    rule, alone = known_company(), KNOWN._replace(alone=True)
    chosen = [rule.choose(alone, rng) for _ in range(6000)]
    shares = np.bincount(chosen, minlength=4) / 6000
    assert chances(rule, alone) == pytest.approx(shares, abs=0.025)
    assert chances(rule, alone).sum() == pytest.approx(1.0)


def test_among_people_they_are_those_of_the_other_rule():
    assert chances(known_company(), KNOWN).tolist() == [0.5, 0.0, 0.5, 0.0]

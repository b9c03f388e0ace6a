import numpy as np
import pytest
from scipy.stats import mannwhitneyu, trim_mean

from experiments.analysis import crossed
from experiments.analysis.statistics import holm, probability_of_improvement

# Efron and Tibshirani, "An Introduction to the Bootstrap", 1993, table 2.1.
TREATED_MICE = np.array([94.0, 197, 16, 38, 99, 141, 23])


def test_with_one_factor_it_is_the_usual_bootstrap_of_the_mice():
    weights = crossed.draws({"mouse": range(7)}, 20_000)
    means = weights @ TREATED_MICE / weights.sum(axis=1)
    # Their table 2.2: standard error of the mean 23.36 with infinitely many resamples.
    assert means.std() == pytest.approx(23.36, rel=0.02)


def test_variances_of_crossed_factors_add_up_as_owen_shows():
    # x_ij = a_i + b_j: the resampled mean is mean(a*) + mean(b*), so its variance is
    # var(a) / n_a + var(b) / n_b exactly, far from var(x) / n of all scores.
    rng = np.random.default_rng(0)
    people, homes = rng.normal(0, 1, 12), rng.normal(0, 2, 8)
    values = (people[:, None] + homes[None, :]).ravel()
    person, home = (each.ravel() for each in np.indices((12, 8)))
    weights = crossed.draws({"people": person, "home": home}, 20_000)
    means = weights @ values / weights.sum(axis=1)
    expected = people.var() / 12 + homes.var() / 8
    assert means.var() == pytest.approx(expected, rel=0.04)
    assert means.var() > 5 * values.var() / len(values)


def test_people_at_hand_are_not_taken_for_all_there_are():
    rng = np.random.default_rng(1)
    seeds, people = (each.ravel() for each in np.indices((30, 5)))
    values = rng.normal(0, 1, 5)[people] + rng.normal(0, 0.1, len(people))
    alone = crossed.crossed(values, {"seed": seeds}, crossed.weighted_mean)
    both = crossed.crossed(
        values, {"seed": seeds, "people": people}, crossed.weighted_mean
    )
    assert both.high - both.low > 5 * (alone.high - alone.low)
    assert both.method == "crossed bootstrap over seed, people"
    assert (alone.n, both.n) == (30, 5)


def test_crossed_intervals_cover_the_true_mean_about_as_often_as_they_say():
    rng = np.random.default_rng(2)
    person, home = (each.ravel() for each in np.indices((20, 12)))
    covered = 0
    for _ in range(40):
        values = rng.normal(size=20)[person] + rng.normal(size=12)[home]
        found = crossed.crossed(
            values, {"people": person, "home": home}, crossed.weighted_mean
        )
        covered += found.low <= 0.0 <= found.high
    assert covered >= 33


@pytest.mark.parametrize("n", [8, 20, 100])
def test_the_interquartile_mean_is_scipys(n):
    values = np.random.default_rng(n).normal(size=n)
    assert crossed.weighted_iqm(values, np.ones(n)) == pytest.approx(
        trim_mean(values, 0.25)
    )


def test_a_score_that_counts_thrice_is_three_scores():
    values, weights = np.array([1.0, 5.0, 2.0, 9.0]), np.array([3.0, 2.0, 1.0, 2.0])
    repeated = np.repeat(values, weights.astype(int))
    assert crossed.weighted_iqm(values, weights) == pytest.approx(
        trim_mean(repeated, 0.25)
    )


def test_a_profile_says_which_share_is_above():
    assert crossed.profile([0.1, 0.4, 0.4, 0.9], [0.0, 0.4, 0.5, 1.0]).tolist() == [
        1.0,
        0.25,
        0.25,
        0.0,
    ]


def test_the_band_of_a_profile_holds_the_profile():
    values = np.random.default_rng(3).random(50)
    low, high = crossed.profile_band(values, [0.3, 0.6], {"seed": range(50)})
    share = crossed.profile(values, [0.3, 0.6])
    assert ((low <= share) & (share <= high)).all()
    assert (high > low).all()


def test_cvar_is_the_mean_of_the_worst_tenth_of_people():
    scores = np.arange(40.0)  # people 0 to 19, two scores each
    people = np.repeat(np.arange(20), 2)
    # The two worst of twenty people have means 0.5 and 2.5.
    assert crossed.cvar(scores, people) == pytest.approx(1.5)


def test_a_tenth_that_ends_within_a_person_counts_that_person_in_part():
    # Rockafellar and Uryasev's splitting of an atom: 15 people, a tenth is 1.5 of them.
    scores = np.arange(15.0)
    assert crossed.cvar(scores, range(15)) == pytest.approx((0 + 0.5 * 1) / 1.5)


def test_the_probability_of_improvement_is_mann_and_whitneys_u():
    # The example of SciPy's manual: ages of males and females; U = 17 of 20 pairs.
    males, females = [19, 22, 16, 29, 24], [20, 11, 17, 12]
    found = probability_of_improvement(males, females)
    assert found.value == pytest.approx(mannwhitneyu(males, females).statistic / 20)
    assert found.value == pytest.approx(0.85)


def test_holm_corrects_a_published_example():
    # Wikipedia, "Holm-Bonferroni method": .01, .04, .03, .005 at level .05; the first
    # and the last hypothesis are rejected.
    assert holm([0.01, 0.04, 0.03, 0.005]) == pytest.approx([0.03, 0.06, 0.06, 0.02])


def test_a_difference_of_nothing_is_compatible_with_0_and_a_large_one_is_not():
    rng = np.random.default_rng(4)
    seeds = {"seed": np.arange(30)}
    assert crossed.p_value(rng.normal(0, 1, 30), seeds) > 0.05
    assert crossed.p_value(rng.normal(2, 1, 30), seeds) < 0.002


def test_one_level_of_everything_gives_no_interval():
    found = crossed.crossed([1.0, 2.0], {"seed": [7, 7], "home": ["a", "a"]})
    assert np.isnan(found.low)
    assert found.method == "too few levels"


def test_a_score_that_is_no_number_is_refused():
    with pytest.raises(ValueError, match="finite"):
        crossed.crossed([1.0, float("nan")], {"seed": [1, 2]})
    with pytest.raises(ValueError, match="at least one factor"):
        crossed.draws({})

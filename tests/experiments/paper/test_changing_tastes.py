"""Experiment 6: choices are told apart by whether tastes have changed."""

import numpy as np
import polars as pl
import pytest

from experiments.paper import EXPERIMENTS, OF_PAPER, e6
from experiments.running.trial import describe_condition, make_home

SIX = EXPERIMENTS[6]


@pytest.fixture
def trial():
    """Makes a table of choices in PLAY, one every 10 s: whether each was right."""

    def make(choices, begin=0.0, **columns):
        n = len(choices)
        return pl.DataFrame(
            {
                "time": begin + 10.0 * np.arange(n),
                "chosen": [True] * n,
                "situation": ["play"] * n,
                "roles": [[{"actor": "actor", "role": "playing"}]] * n,
                "attention": [[{"observer": "actor", "target": "robot_0"}]] * n,
                "behavior": ["play" if right else "sleep" for right in choices],
                "appropriateness": [{"play": 1.0, "sleep": -1.0}] * n,
                **{name: [value] * n for name, value in columns.items()},
            }
        )

    return make


def test_it_is_not_the_papers():
    assert 6 not in OF_PAPER
    assert {claim.id for claim in SIX.claims} == {"6a", "6b", "6c", "6d"}


def test_the_last_quarter_is_that_before_or_after_the_change(trial):
    # 120 choices before the change at 1200 s, 40 after it.
    told = trial(
        [*[False] * 90, *[True] * 15, *[False] * 15, *[False] * 35, *[True] * 5]
    )
    assert e6.before(told) == 0.5
    assert e6.after(told) == 0.5
    assert np.isnan(e6.after(trial([True] * 10)))


def test_the_first_choices_are_counted_from_a_moment_on(trial):
    told = trial([*[True] * 120, *[False] * 7, *[True] * 20])
    assert e6.wrong_at_first(told, begin=e6.CHANGE) == 7.0
    assert e6.wrong_at_first(told, begin=0.0) == 0.0
    assert np.isnan(e6.wrong_at_first(trial([True] * 9), begin=0.0))


def test_remembering_costs_what_goes_wrong_more_than_in_beginning_anew(trial):
    remembers = trial([*[True] * 120, *[False] * 9, *[True] * 20])
    begins = trial([*[False] * 4, *[True] * 20])
    frame = pl.concat(
        one.with_columns(condition=pl.lit(name), seed=pl.lit(0))
        for name, one in (("social", remembers), ("social_anew", begins))
    )
    assert e6.cost("social").values(frame).tolist() == [5.0]


def test_beginning_anew_is_the_same_home_with_the_later_taste_from_the_start():
    changing = describe_condition(SIX.condition("social"))
    anew = describe_condition(SIX.condition("social_anew"))
    assert changing["settings"] == anew["settings"]
    assert changing["personas"] == anew["personas"]
    (change,) = make_home(SIX.condition("social")).scenario.changes
    assert change.at == e6.CHANGE
    later = make_home(SIX.condition("social_anew")).scenario
    assert later.changes == ()
    assert later.norms["playing"] == change.norms["playing"]


def test_in_the_other_reading_what_is_not_wanted_is_tapped():
    opposite = make_home(SIX.condition("social_opposite")).scenario
    (change,) = opposite.changes
    for norms in (opposite.norms, change.norms):
        assert sorted(norms["playing"].attending.values()) == [-1.0, 1.0]


def test_the_actor_wants_something_else_after_the_change():
    home = make_home(SIX.condition("social"))
    home.reset(seed=0)
    best = {"before": set(), "after": set()}
    while home.agents:
        home.step({"robot_0": 0})
        if home.attended("robot_0"):
            wanted = home.behaviors[int(home.appropriateness("robot_0").argmax())]
            best["before" if home.time < e6.CHANGE else "after"].add(wanted)
    assert best == {"before": {"play"}, "after": {"sleep"}}

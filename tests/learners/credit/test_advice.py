import pytest

from learners.credit.advice import Advice
from learners.credit.heuristics import AttentionShift, BeforeApproach, MostRecent
from learners.credit.history import History
from learners.errors import ExperienceError, ParameterError


@pytest.fixture
def history(entry):
    history = History()
    for time, state in enumerate("abcd"):
        history.append(entry(state, 0, float(time)))
    return history


def pointing_at(state):
    def ask(reward, candidates):
        return [entry.state for entry in candidates].index(state)

    return ask


@pytest.fixture
def split(touch):
    """A touch that says b by the approach and c by the attention."""
    return touch(time=4.5, approach_began=3.0, attention_began=4.0)


@pytest.mark.parametrize(("state", "index"), [("b", 1), ("c", 2)])
def test_a_split_vote_is_put_before_the_giver(history, split, state, index):
    advice = Advice(ask=pointing_at(state))
    assert advice(split, history) == index
    assert advice.asked == 1


def test_an_undivided_vote_needs_no_question(history, touch):
    advice = Advice(ask=pointing_at("never asked"))
    assert (
        advice(touch(time=4.5, approach_began=3.0, attention_began=3.0), history) == 1
    )
    assert advice.asked == 0


def test_a_clear_majority_needs_no_question(history, split):
    votes = ((BeforeApproach(), 2.0), (AttentionShift(), 1.0))  # 2/3 to 1/3
    advice = Advice(ask=pointing_at("never asked"), heuristics=votes, margin=0.3)
    assert advice(split, history) == 1


def test_only_what_is_about_as_likely_is_asked_about(history, split):
    votes = ((BeforeApproach(), 4.0), (AttentionShift(), 4.0), (MostRecent(), 1.0))
    advice = Advice(ask=lambda f, candidates: len(candidates) - 1, heuristics=votes)
    assert advice(split, history) == 2


def test_a_giver_who_points_at_nothing_leaves_the_first_guess(history, split):
    assert Advice(ask=lambda f, c: None)(split, history) == 1


def test_a_giver_who_points_past_the_candidates_is_an_error(history, split):
    with pytest.raises(ExperienceError, match="candidate 2 of 2"):
        Advice(ask=lambda f, c: 2)(split, history)


def test_advice_without_heuristics_is_refused():
    with pytest.raises(ParameterError, match="heuristics"):
        Advice(ask=lambda f, c: 0, heuristics=())

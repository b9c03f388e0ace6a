from dataclasses import replace

import numpy as np
import pytest

from household.replay.choices import Choice
from household.replay.why import page

BEHAVIORS = ("bark", "play", "sleep")


@pytest.fixture
def choice():
    return Choice(
        robot="robot_0",
        behavior=1,
        chosen=True,
        situation="ann reading",
        represented="ann (reading)",
        values=np.array([-0.5, 0.25, 0.0]),
        probabilities=np.array([0.1, 0.7, 0.2]),
        touches=np.array([4.0, 2.0, 0.0]),
        updates=np.array([9.0, 3.0, 0.0]),
        reference=np.array([-0.3, -0.1, 0.4]),
        taught="tap by ann at 8 s (-0.50), credited to bark 1.2 s before",
        is_first=False,
        before=-1,
    )


def row(text, behavior):
    (line,) = (line for line in text.splitlines() if f"{behavior} " in line[:9])
    return line


def test_each_behavior_has_a_bar_with_value_probability_and_touches(choice):
    text = page(choice, choice, BEHAVIORS)
    assert row(text, "bark").split() == ["bark", "■■■■|", "-0.50", "10", "%", "4", "9"]
    assert row(text, "play").split()[-5:] == ["+0.25", "70", "%", "2", "3"]
    assert row(text, "play").count("■") == 2
    assert row(text, "sleep").count("■") == 0


def test_what_it_does_and_what_the_reference_would_do_are_marked(choice):
    text = page(choice, choice, BEHAVIORS)
    assert row(text, "play").startswith("▶ ")
    assert row(text, "sleep").startswith(" ◆")
    assert row(text, "bark").startswith("  ")
    assert "**Reference** ◆ sleep (+0.40); what it does: -0.10" in text


def test_a_choice_is_greedy_or_explored_and_has_its_probability(choice):
    assert page(choice, choice, BEHAVIORS).startswith(
        "**play**, greedy, probability 70%"
    )
    odd = replace(choice, behavior=0)
    assert page(odd, odd, BEHAVIORS).startswith("**bark**, explored, probability 10%")
    untold = replace(choice, probabilities=None)
    assert page(untold, untold, BEHAVIORS).startswith("**play**, greedy\n")


def test_a_behavior_that_goes_on_tells_how_it_was_chosen(choice):
    later = replace(choice, chosen=False, values=np.array([0.9, 0.1, 0.2]))
    text = page(later, choice, BEHAVIORS)
    assert text.startswith("**play** goes on (chosen before: greedy, probability 70%)")


def test_what_it_sees_what_that_means_to_it_and_what_taught_it_are_told(choice):
    text = page(choice, choice, BEHAVIORS)
    assert "**Sees** ann reading" in text
    assert "**Takes it for** ann (reading)" in text
    assert "**Last taught by** tap by ann at 8 s (-0.50), credited to bark" in text
    untaught = page(replace(choice, taught=""), choice, BEHAVIORS)
    assert "**Last taught by** nothing yet" in untaught

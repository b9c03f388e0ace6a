"""Changes of tastes in files: what is wrong with them is said in one line each."""

import pytest

from household.errors import HouseholdError
from household.scenario.validation import load_scenario, problems

PEOPLE = [{"name": "ann"}, {"name": "bob"}]
LIKES = {"calling": {"absorbed": {"bark": 0.5}}}


def load(*changes, **more):
    given = {"people": PEOPLE, "heterogeneity": 0.3} | more
    return load_scenario("experiment_1", changes=list(changes), **given)


@pytest.mark.parametrize(
    "changes",
    [
        [],
        [{"at": 0.0, "norms": LIKES}],
        [{"at": 5.0, "over": 60.0, "people": ["bob"], "preferences": LIKES}],
        [{"at": 5.0, "population_seed": 3}],
        # One after the other, or at the same time for different people.
        [{"at": 5.0, "over": 5.0, "norms": LIKES}, {"at": 10.0, "norms": LIKES}],
        [
            {"at": 5.0, "over": 9.0, "people": ["ann"], "norms": LIKES},
            {"at": 7.0, "over": 9.0, "people": ["bob"], "norms": LIKES},
        ],
    ],
)
def test_changes_that_make_sense_are_read(changes):
    scenario = load(*changes)
    assert [change.at for change in scenario.changes] == [c["at"] for c in changes]
    assert list(problems(scenario)) == []


@pytest.mark.parametrize(
    ("changes", "more", "where", "what"),
    [
        ([{"norms": LIKES}], {}, "changes[0]", "at"),
        ([{"at": -1.0, "norms": LIKES}], {}, "changes[0].at", ">= 0"),
        ([{"at": 1e300, "norms": LIKES}], {}, "changes[0].at", "100000000"),
        ([{"at": 1.0, "over": -1.0, "norms": LIKES}], {}, "changes[0].over", ">= 0"),
        ([{"at": 1.0, "when": 2.0}], {}, "changes[0]", "'when' (allowed: at,"),
        ([{"at": 1.0}], {}, "changes[0]", "needs norms, preferences or"),
        (
            [{"at": 1.0, "people": ["bob", "anne"], "norms": LIKES}],
            {},
            "changes[0].people[1]",
            "'ann'",
        ),
        (
            [{"at": 1.0, "norms": {"calling": {"absorbed": {"brak": 1.0}}}}],
            {},
            "changes[0].norms.calling.absorbed",
            "'bark'",
        ),
        (
            [{"at": 1.0, "preferences": {"calling": {"attending": {"bark": 2.0}}}}],
            {},
            "changes[0].preferences.calling.attending.bark",
            "<= 1",
        ),
        (
            [{"at": 1.0, "preferences": LIKES}],
            {"heterogeneity": 0.0},
            "changes[0].preferences",
            "heterogeneity is 0",
        ),
        (
            [{"at": 1.0, "population_seed": 1}],
            {"heterogeneity": 0.0},
            "changes[0].population_seed",
            "heterogeneity is 0",
        ),
        (
            [{"at": 1.0, "norms": LIKES}],
            {"heterogeneity": 1.0},
            "changes[0].norms",
            "heterogeneity is 1",
        ),
        (
            [
                {"at": 9.0, "people": ["bob"], "norms": LIKES},
                {"at": 5.0, "over": 8.0, "norms": LIKES},
            ],
            {},
            "changes[0].at",
            "at least 13, when changes[1] is over",
        ),
    ],
)
def test_a_change_that_makes_no_sense_is_refused_in_one_line(
    changes, more, where, what
):
    with pytest.raises(HouseholdError) as caught:
        load(*changes, **more)
    text = str(caught.value)
    assert "\n" not in text
    assert f"{where}:" in text
    assert what in text

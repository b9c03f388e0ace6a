"""The households of studies, whose people may have come to want something else."""

import msgspec
import numpy as np
import pytest

from experiments.phases.norms import own_norms
from experiments.phases.world import Residence, World, scenario
from household.people.person import everyone_of
from household.people.preferences import Preferences
from household.scenario.norms import Norms
from household.scenario.validation import load_scenario


def lived_in(**world):
    residence = Residence(world=World(people=2, **world), home=3, people=(4, 9))
    return scenario(residence)


def wanted(one):
    return Preferences(one, everyone_of(one)).values


def test_where_tastes_have_changed_everything_else_is_as_before():
    before, after = lived_in(), lived_in(turned=2)
    assert before.changes == ()
    assert msgspec.structs.replace(after, changes=()) == before
    assert not np.array_equal(wanted(before), wanted(after))


def test_tastes_that_have_changed_are_those_of_a_household_with_the_other_norms():
    before, after = lived_in(), lived_in(turned=2)
    norms = msgspec.convert(own_norms(2), Norms)
    other = msgspec.structs.replace(before, norms=norms)
    np.testing.assert_array_equal(wanted(after), wanted(other))


def test_people_who_disagree_go_on_to_disagree_when_they_change():
    """What the second wants at first is three places on; then so is the first's."""
    before, after = lived_in(opposed=True), lived_in(opposed=True, turned=3)
    one, other = wanted(before)
    changed_one, changed_other = wanted(after)
    assert not np.array_equal(one, other)
    np.testing.assert_array_equal(changed_one, other)
    np.testing.assert_array_equal(changed_other, one)


@pytest.mark.parametrize("opposed", [False, True])
def test_a_household_that_has_changed_is_without_faults(opposed):
    load_scenario(lived_in(opposed=opposed, turned=2))

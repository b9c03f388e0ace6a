"""Homes and families of households."""

import numpy as np

from household.errors import HouseholdError
from household.home.check import checked, problems
from household.home.floorplan import load_floorplan
from household.home.standing import standing_room
from household.scenario.family import draw, load_family
from household.scenario.files import check_file
from household.scenario.validation import load_scenario

from .inputs import families, homes, told, written
from .living import live


def test_a_home_is_refused_in_one_line_or_lived_in(explore, deepest, tmp_path):
    path = tmp_path / "home.toml"

    def check(data):
        if not written(data, path):
            return "not TOML"
        lines = check_file(path)
        try:
            plan = checked(load_floorplan(str(path)), str(path))
        except HouseholdError as error:
            told(error)
            assert lines
            return "refused"
        if lines:  # It looks like a file of another kind.
            return "refused"
        assert problems(plan) == ()
        scenario = load_scenario("evening", home=plan, **residents(plan))
        longest = live(scenario, explore.counts.total(), deepest)
        assert longest < explore.slowest
        return "accepted"

    explore(homes(), check, few=15)


def residents(plan):
    """Three people who go about the home, and a robot in the open."""
    spots = standing_room(plan, 1, np.random.default_rng(0))
    people = [{"name": f"p{i}"} for i in range(3)]
    return {"people": people, "robots": [{"position": list(spots[0])}]}


def test_a_family_is_refused_in_one_line_or_its_households_lived_in(
    explore, deepest, tmp_path
):
    path = tmp_path / "family.toml"

    def check(data):
        if not written(data, path):
            return "not TOML"
        seed = explore.counts.total()
        try:
            family = load_family(str(path))
        except HouseholdError as error:
            told(error)
            assert check_file(path)
            return "refused"
        try:
            scenario = draw(family, seed)
        except HouseholdError as error:  # No home of the family has room for them.
            told(error)
            return "too many for its homes"
        assert live(load_scenario(scenario), seed, deepest) < explore.slowest
        return "accepted"

    explore(families(), check, few=8)

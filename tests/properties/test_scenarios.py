"""Scenarios, with the people and the norms in them."""

import numpy as np
import pytest

from household.errors import HouseholdError
from household.scenario.files import check_file
from household.scenario.validation import load_scenario

from .inputs import norms, personas, scenarios, told, written
from .living import live
from .plain_data import nested


@pytest.fixture
def lived_in(explore, deepest):
    """Loads a scenario and lives in it for a while, or sees it refused."""

    def live_in(scenario, **overrides):
        try:
            accepted = load_scenario(scenario, **overrides)
        except HouseholdError as error:
            said = told(error)
            assert said.startswith(str(scenario))
            return "refused"
        longest = live(accepted, explore.counts.total(), deepest)
        assert longest < explore.slowest
        return "accepted"

    return live_in


def test_a_scenario_is_refused_in_one_line_or_lived_in(explore, lived_in):
    def check(data):
        if not isinstance(data, dict) or not all(isinstance(k, str) for k in data):
            return "no fields"
        fields = {name: value for name, value in data.items() if name != "scenario"}
        return lived_in("experiment_1", **fields)

    explore(scenarios(), check, few=25)


def test_a_file_has_faults_if_and_only_if_it_cannot_be_loaded(explore, tmp_path):
    path = tmp_path / "scenario.toml"

    def check(data):
        if not written(data, path):
            return "not TOML"
        lines = check_file(path)
        assert all(line.isprintable() for line in lines)
        try:
            load_scenario(path)
        except HouseholdError as error:
            told(error)
            assert lines
            return "refused"
        assert not lines
        return "accepted"

    explore(scenarios(), check, few=20)


def test_a_persona_is_refused_in_one_line_or_lived_with(explore, lived_in):
    def check(data):
        people = [{"name": "ann", "persona": data}, {"name": "ben"}]
        return lived_in("evening", people=people, heterogeneity=0.5)

    explore(personas(), check, few=10)


def test_norms_are_refused_in_one_line_or_lived_by(explore, lived_in):
    explore(norms(), lambda data: lived_in("party", norms=data), few=8)


@pytest.mark.slow
def test_a_household_of_the_most_of_everything_is_lived_in(deepest):
    """As many people, robots and behaviors as are allowed, at the finest clock."""
    from household.home.sources.generator import generate
    from household.home.standing import standing_room

    plan = generate(5, rooms=16, room_area=25.0)
    scenario = load_scenario(
        "evening",
        home=plan,
        people=[{"name": f"p{i}"} for i in range(64)],
        robots=[
            {"position": spot}
            for spot in standing_room(plan, 16, np.random.default_rng(0))
        ],
        decision_period=1.0,
        steering_period=0.01,
        physics_period=0.001,
    )
    live(scenario, 1, deepest)


def test_data_nested_without_end_are_refused_in_one_line():
    for field in ("home", "people", "norms", "name"):
        with pytest.raises(HouseholdError) as caught:
            load_scenario("experiment_1", **{field: nested(5000)})
        told(caught.value)

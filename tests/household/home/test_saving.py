"""A home written as TOML reads back unchanged."""

import msgspec
import pytest

from household.config.toml import shipped
from household.errors import HouseholdError
from household.home.floorplan import load_floorplan
from household.home.saving import save_floorplan
from household.home.sources.generator import generate

PLANS = [
    *(load_floorplan(name) for name in shipped("home")),
    *(generate(seed, rooms=1 + seed) for seed in range(4)),
]


@pytest.mark.parametrize("plan", PLANS, ids=lambda plan: plan.name)
def test_a_saved_home_is_loaded_again_unchanged(plan, tmp_path):
    path = tmp_path / "home.toml"
    save_floorplan(plan, path)
    assert load_floorplan(str(path)) == plan


def test_descriptions_may_hold_any_character_that_can_be_printed(tmp_path):
    odd = 'grand-mère\'s "den" \\ \n\t 🛋'
    plan = msgspec.structs.replace(load_floorplan("studio"), description=odd)
    save_floorplan(plan, tmp_path / "odd.toml")
    assert load_floorplan(str(tmp_path / "odd.toml")).description == odd


def test_a_file_that_could_not_be_loaded_by_path_is_not_written(tmp_path):
    with pytest.raises(HouseholdError, match=r"allowed: a name in \.toml"):
        save_floorplan(load_floorplan("studio"), tmp_path / "home.json")
    assert not list(tmp_path.iterdir())


def test_a_folder_that_does_not_exist_is_named(tmp_path):
    with pytest.raises(HouseholdError, match=r"nowhere.*: No such file"):
        save_floorplan(load_floorplan("studio"), tmp_path / "nowhere" / "home.toml")

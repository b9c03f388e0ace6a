"""Files from strangers: read as they are now, refused in one line, soon."""

import pytest

from household.config.toml import LARGEST, load, read_toml, shipped
from household.errors import HouseholdError
from household.home.floorplan import FloorPlan, load_floorplan
from household.scenario.persona import load_persona
from household.scenario.reading import read_scenario

MONSTERS = {
    "an integer of 5,000 digits": ("a = " + "4" * 5000, "thousands of digits"),
    "5,000 nested brackets": ("a = " + "[" * 5000 + "]" * 5000, "nested too deeply"),
    "3,000 nested tables": ("a = " + "{a = " * 3000 + "1" + "}" * 3000, "nested too"),
    "brackets just too deep": ("a = " + "[" * 40 + "]" * 40, "nested too deeply"),
    # Python's reader would take gigabytes for the first, half a minute for the second.
    "a key of 100,000 parts": (".".join("a" * 100_000) + " = 1", "too many dots"),
    "long keys under a long header": (
        "["
        + ".".join("a" * 2900)
        + "]\n"
        + "".join(f"k{i} = 1\n" for i in range(20_000)),
        "too many dots",
    ),
    "a comment of a megabyte": ("#" * 2**20, f"larger than {LARGEST} bytes"),
    "no end of a text": ('a = "', "not valid TOML"),
    "a null": ('a = "\0"', "not valid TOML"),
}


@pytest.mark.parametrize("monster", MONSTERS)
def test_a_monstrous_file_is_refused_in_one_line(tmp_path, monster):
    text, why = MONSTERS[monster]
    path = tmp_path / "monster.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(HouseholdError) as caught:
        read_toml(path)
    assert str(caught.value).startswith(f"{path}: ")
    assert why in str(caught.value)
    assert str(caught.value).isprintable()
    assert len(str(caught.value)) < len(str(path)) + 120


@pytest.mark.parametrize("name", ["a" * 5000 + ".toml", "a\0.toml", "a\n.toml"])
@pytest.mark.parametrize("read", [load_floorplan, load_persona, read_scenario])
def test_a_path_that_no_file_can_have_is_refused_in_one_line(read, name):
    with pytest.raises(HouseholdError, match="no such") as caught:
        read(name)
    assert str(caught.value).isprintable()
    assert len(str(caught.value)) < 300


def test_a_file_that_begins_with_a_byte_order_mark_is_read(tmp_path):
    path = tmp_path / "bom.toml"
    path.write_text("a = 1", encoding="utf-8-sig")
    assert read_toml(path) == {"a": 1}


def test_an_edited_home_loaded_again_is_the_new_one(tmp_path):
    path = tmp_path / "mine.toml"
    text = shipped("home")["studio"].read_text(encoding="utf-8")
    path.write_text(text, encoding="utf-8")
    assert load_floorplan(str(path)).name == "studio"
    # Of the same length, within the same moment: nothing but what it holds tells.
    path.write_text(text.replace('"studio"', '"stooge"'), encoding="utf-8")
    assert load_floorplan(str(path)).name == "stooge"


def test_an_edited_persona_loaded_again_is_the_new_one(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text('name = "her"\npraise = 0.25\n', encoding="utf-8")
    assert load_persona(str(path)).praise == 0.25
    path.write_text('name = "her"\npraise = 0.75\n', encoding="utf-8")
    assert load_persona(str(path)).praise == 0.75


def test_what_has_not_changed_is_not_read_into_another_record():
    path = shipped("home")["villa"]
    assert load(path, FloorPlan) is load(path, FloorPlan)

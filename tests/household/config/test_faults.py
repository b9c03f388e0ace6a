from typing import Annotated, Literal

import msgspec
import pytest

from household.config.faults import faults
from household.config.toml import Record, convert, locate, read_toml
from household.errors import HouseholdError


class Lamp(Record, frozen=True, kw_only=True):
    color: Literal["red", "green", "blue"] = "red"
    watts: Annotated[float, msgspec.Meta(gt=0.0)]
    place: tuple[float, float] = (0.0, 0.0)


class Room(Record, frozen=True, kw_only=True):
    name: str
    lamps: tuple[Lamp, ...] = ()
    switches: dict[str, Lamp] | None = None


@pytest.mark.parametrize(
    ("data", "told"),
    [
        ({"name": "hall", "lamps": [{"watts": 5.0}]}, []),
        ({}, ["missing required field `name`"]),
        (
            {"name": "hall", "lamps": [{"watts": 5.0}, {"wats": 5.0}]},
            [
                "lamps[1]: unknown field 'wats'; did you mean 'watts'? "
                "(allowed: color, place, watts)"
            ],
        ),
        (
            {"name": "hall", "switches": {"left": {"watts": 1.0, "color": "gren"}}},
            [
                "switches.left.color: unknown value 'gren'; did you mean 'green'? "
                "(allowed: blue, green, red)"
            ],
        ),
        (
            {"name": "hall", "lamps": [{"watts": float("nan")}]},
            ["lamps[0].watts: nan; allowed: finite numbers"],
        ),
        (
            {"name": "\ud800", "lamps": [{"watts": "\ud800", "color": "\ud800"}]},
            [
                "name: '\\ud800'; allowed: characters of Unicode",
                "lamps[0].watts: '\\ud800'; allowed: characters of Unicode",
                "lamps[0].color: '\\ud800'; allowed: characters of Unicode",
            ],
        ),
        (
            {"name": "hall", "switches": {"\ud800": {"watts": 1.0}}},
            ["switches: '\\ud800'; allowed: characters of Unicode"],
        ),
        (
            {"name": "hall", "lamps": [{"watts": 1.0, "place": [0.0, "left"]}]},
            ["lamps[0].place[1]: Expected `float`, got `str`"],
        ),
        (
            {"name": 7, "lamps": [{"watts": -1.0}, {}]},
            [
                "name: Expected `str`, got `int`",
                "lamps[0].watts: Expected `float` > 0.0",
                "lamps[1]: missing required field `watts`",
            ],
        ),
        ({"name": "hall", "lamps": "many"}, ["lamps: Expected `array`, got `str`"]),
        ("hall", ["Expected `object`, got `str`"]),
    ],
)
def test_every_fault_is_told_with_its_path_and_what_is_allowed(data, told):
    assert list(map(str, faults(data, Room))) == told


def test_data_without_faults_becomes_a_record():
    data = {"name": "hall", "lamps": [{"watts": 5, "place": [1, 2.5]}]}
    assert convert(data, Room, "hall.toml") == Room(
        name="hall", lamps=(Lamp(watts=5.0, place=(1.0, 2.5)),)
    )


def test_the_first_fault_names_the_file():
    with pytest.raises(HouseholdError, match=r"^hall\.toml: missing required field"):
        convert({}, Room, "hall.toml")


@pytest.mark.parametrize(
    ("content", "said"), [(b"name = ", "not valid TOML"), (b"\xff", "not valid TOML")]
)
def test_what_is_not_toml_is_told_with_the_file(tmp_path, content, said):
    path = tmp_path / "hall.toml"
    path.write_bytes(content)
    with pytest.raises(HouseholdError) as caught:
        read_toml(path)
    assert str(caught.value).startswith(f"{path}: {said}")


def test_a_missing_file_is_told_with_its_name(tmp_path):
    with pytest.raises(HouseholdError, match=r"hall\.toml: No such file"):
        read_toml(tmp_path / "hall.toml")


def test_a_name_that_is_not_shipped_is_answered_with_the_nearest():
    with pytest.raises(HouseholdError, match="did you mean 'evening'"):
        locate("evning", "scenario")
    assert locate("evening", "scenario").name == "evening.toml"

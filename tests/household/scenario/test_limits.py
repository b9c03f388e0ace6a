"""Numbers that are merely absurd are refused: they would overflow or hang later."""

import pytest

from household.config.faults import MOST_UNKNOWN, faults
from household.config.toml import shipped
from household.errors import HouseholdError
from household.home.floorplan import MOST_WALLS, FloorPlan, load_floorplan
from household.scenario.files import check_file
from household.scenario.validation import load_scenario

PEOPLE = [{"name": "ann"}]

ABSURD = [
    *(
        (period, {period: value})
        for period in ("decision_period", "steering_period", "physics_period")
        for value in (1e6, 1e9, 1e300, 1e-9, 0.0, -1.0, float("nan"))
    ),
    ("decision_period", {"decision_period": 60.0, "physics_period": 0.05}),
    ("max_cycles", {"max_cycles": 10**400}),
    ("max_cycles", {"max_cycles": 2**63}),
    ("population.clusters", {"population": {"clusters": 2**63}}),
    ("population.seed", {"population": {"seed": 2**64}}),
    ("perception.focus", {"perception": {"focus": 1e-200}}),
    ("perception.distance", {"perception": {"distance": 1e-200}}),
    ("perception.wall_loss", {"perception": {"wall_loss": 1e308}}),
    ("perception.mood_noise", {"perception": {"mood_noise": 1e308}}),
    ("robots[0].heading", {"robots": [{"position": [2.6, 2.6], "heading": 1e300}]}),
    ("robots[0].position[0]", {"robots": [{"position": [1e300, 2.6]}]}),
    ("people[0].start[1]", {"people": [{"name": "ann", "start": [2.6, -1e300]}]}),
    (
        "people[0].schedule.reading.then.desk",
        {
            "people": [
                {
                    "name": "ann",
                    "schedule": {
                        "reading": {"duration": [1.0, 2.0], "then": {"desk": 1e308}},
                        "desk": {"duration": [1.0, 2.0], "then": {"reading": 1.0}},
                    },
                }
            ]
        },
    ),
    *(
        (
            f"people[0].persona.{trait}",
            {"people": [{"name": "ann", "persona": {"name": "odd", trait: value}}]},
        )
        for trait, value in {
            "walking_speed": 1e300,
            "head_speed": 1e300,
            "patience": 1e300,
            "absorption": 1e-300,
            "wakes_at": 1e300,
        }.items()
    ),
    (
        "behavior.hum.duration",
        {"behavior": {"hum": {"description": "", "duration": 1e300}}},
    ),
    ("behaviors", {"behaviors": ["bark"] * 10_000}),
    (
        "norms.working.attending",
        {"norms": {"working": {"attending": {f"b{i}": 0.5 for i in range(20_000)}}}},
    ),
    ("norms", {"norms": {f"a{i}": {} for i in range(20_000)}}),
    ("people", {"people": [{"name": f"p{i}"} for i in range(65)]}),
    ("name", {"name": "two\nlines"}),
    ("name", {"name": "ends with one\n"}),
    ("name", {"name": "n" * 101}),
    ("name", {"name": ""}),
    ("description", {"description": "\x1b[31mred"}),
    ("people[0].name", {"people": [{"name": "ann\n"}]}),
]


@pytest.mark.parametrize(("where", "overrides"), ABSURD)
def test_an_absurd_value_is_refused_in_one_line_with_its_path(where, overrides):
    with pytest.raises(HouseholdError) as caught:
        load_scenario("experiment_1", **overrides)
    assert str(caught.value).startswith(f"experiment_1: {where}: ")
    assert str(caught.value).isprintable()
    assert len(str(caught.value)) < 400


WALL = "  { from = [0.0, 0.0], to = [1.0, 0.0] },\n"


def test_a_home_of_10_000_equal_walls_is_refused(tmp_path):
    (line,) = check_file(home_with(tmp_path, WALL * 5000))
    assert f"walls: Expected `array` of length <= {MOST_WALLS}" in line
    (line,) = check_file(home_with(tmp_path, WALL * 10_000))
    assert "larger than" in line


def test_a_home_of_the_most_walls_is_checked(tmp_path):
    path = home_with(tmp_path, WALL * (MOST_WALLS - 9))
    assert check_file(path) == ()
    assert len(load_floorplan(str(path)).walls) == MOST_WALLS


def test_a_home_with_walls_without_end_is_refused(tmp_path):
    oblique = "  { from = [0.0, 0.0], to = [70.0, 70.0] },\n"
    (line,) = check_file(home_with(tmp_path, oblique * (MOST_WALLS - 9)))
    assert "walls: 9.813e+04 m in all; allowed: up to 5000 m" in line


def home_with(folder, walls):
    """The studio with some more walls."""
    text = shipped("home")["studio"].read_text(encoding="utf-8")
    text = text.replace("walls = [\n", f"walls = [\n{walls}")
    path = folder / "home.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_of_thousands_of_unknown_fields_the_first_are_told(tmp_path):
    """Each is compared with all that there are, which took minutes."""
    path = home_with(tmp_path, "")
    with path.open("a", encoding="utf-8") as file:
        file.write("[more]\n" + "".join(f"a{i} = 1\n" for i in range(20_000)))
    assert len(check_file(path)) <= 101
    data = {f"field_{i}": 1 for i in range(20_000)}
    with pytest.raises(HouseholdError, match="unknown field 'field_0'"):
        load_scenario("experiment_1", home=data)
    lines = list(faults(data, FloorPlan))
    assert len(lines) == MOST_UNKNOWN + 1
    assert str(lines[-1]) == "19900 more unknown fields"


def test_names_that_cannot_be_printed_are_told_on_one_line():
    with pytest.raises(HouseholdError) as caught:
        load_scenario(
            "experiment_1",
            behaviors=["bark", "no such"],
            behavior={"\u202e\U000f5904": {"description": "", "duration": 1.0}},
        )
    assert str(caught.value).isprintable()

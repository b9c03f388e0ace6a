"""`check_file` tells all that is wrong at once, in files of every kind."""

import pytest

from household.config.toml import shipped
from household.scenario.files import MOST, check_file, size_of_file

SCENARIO = """
name = "mine"
home = "smart_room"
behaviors = ["brak", "play", "play", 7]
decision_period = 0.3

[[people]]
name = "ann"

[[people.script]]
place = "plying"
duration = [nan, 20.0]

[[people.script]]
place = "reading"
duration = [20.0, 10.0]

[[people]]
nmae = "bob"
start = [9.5, 3.7]

[[people]]
name = "ann"
persona = "stritc"

[[people]]
name = "cleo"
[people.schedule.reading]
duration = [10.0, 20.0]
then = { desk = -1.0 }
[people.schedule.desk]
duration = [10.0, 20.0]
then = { reading = 0.0, attic = 1.0 }

[[robots]]
position = [0.0, 2.6]
heading = "north"

[[robots]]
position = [2.6, 2.6]

[[robots]]
position = [2.6, 2.7]

[perception]
focus = nan

[slots]
people = 2
"""

OF_SCENARIO = [
    # By themselves ...
    "behaviors[3]",
    "people[0].script[0].duration[0]",
    "people[1]",
    "people[3].schedule.reading.then.desk",
    "robots[0].heading",
    "perception.focus",
    # ... and together.
    "people[2].persona",
    "decision_period",
    "behaviors[0]",
    "behaviors[2]",
    "people[2].name",
    "slots.people",
    "people[0].script[0].place",
    "people[0].script[1].duration",
    "people[3].schedule.desk.then",
    "people[1].start",
    "robots[0].position",
    "robots[2].position",
]

HOME = """
name = "hut"
walls = [
  { from = [0.0, 0.0], to = [6.0, 0.0] },
  { from = [6.0, 0.0], to = [6.0, 4.0] },
  { from = [6.0, 4.0], to = [0.0, 4.0] },
  { from = [0.0, 4.0], to = [0.0, 0.0] },
  { from = [4.0, 0.0], to = [4.0, 1.0] },
  { from = [4.0, 1.4], to = [4.0, 4.0] },
  { from = [1.0, 1.0], to = [1.0, 1.0] },
]
doors = [{ from = [4.0, 1.0], to = [4.0, 1.4] }]
rooms = [
  { name = "hall", corners = [[0.0, 0.0], [6.0, 0.0]] },
  { name = "den", corners = [[0.0, 0.0], [6.0, 0.0], [0.0, 4.0]] },
  { name = "den", corners = [[0.0, 0.0], [6.0, 0.0], [0.0, 4.0]] },
]

[[furniture]]
name = "table"
center = [3.3, 3.3]
size = [0.6, 0.6]

[[regions]]
name = "corner"
activity = "playing"
center = [1.0, 2.0]
facing = [1.0, 2.0]

[[regions]]
name = "chair"
activity = "reading"
center = [3.3, 3.3]
facing = [0.0, 3.3]

[[regions]]
name = "bed"
activity = "sleping"
center = [1.0, 3.0]
facing = [0.0, 3.3]

[[regions]]
name = "desk"
activity = "working"
center = [5.0, 3.0]
facing = [6.0, 3.0]
radius = 2.0
"""

OF_HOME = [
    "rooms[0].corners",
    "regions[2].activity",
    "rooms[2].name",
    "walls[6]",
    "regions[0].facing",
    "regions[1].center",
    "doors[0]",
    "regions[3].center",
    "regions[3].radius",
]


@pytest.fixture
def paths_in(tmp_path):
    """Where the faults of a file are, each told in one line."""

    def read(text):
        path = tmp_path / "mine.toml"
        path.write_text(text, encoding="utf-8")
        lines = check_file(path)
        assert all(line.isprintable() for line in lines)
        assert all(line.startswith(f"{path}: ") for line in lines)
        return [line.split(": ")[1] for line in lines]

    return read


def test_all_faults_of_a_scenario_are_told_at_once_whatever_their_stage(paths_in):
    assert paths_in(SCENARIO) == OF_SCENARIO


def test_all_faults_of_a_home_are_told_at_once_whatever_their_stage(paths_in):
    assert paths_in(HOME) == OF_HOME


def test_all_faults_of_a_home_inside_a_scenario_are_told_with_its_own(paths_in):
    lines = HOME.replace("\n[[", "\n[[home.").splitlines()
    inline = SCENARIO.replace('home = "smart_room"\n', "")
    found = paths_in("\n".join([inline, "[home]", *lines]))
    assert [path for path in found if path.startswith("home.")] == [
        f"home.{path}" for path in OF_HOME
    ]
    # Nobody can say where people are to be in a home that is not right.
    assert "people[1].start" not in found
    assert {"behaviors[0]", "people[2].name", "slots.people"} <= set(found)


def test_all_faults_of_a_persona_are_told_at_once(paths_in):
    text = 'name = "two\\nlines"\npraise = 1.5\nmistakes = nan\nsanktion = 0.5\n'
    assert paths_in(text)[:3] == ["name", "praise", "mistakes"]
    assert "'sanction'" in check_one(paths_in, text)


def check_one(paths_in, text):
    """What is said of the whole file, behind its name."""
    return paths_in(text)[-1]


def test_a_faulty_file_of_a_home_is_told_with_all_its_faults(paths_in, tmp_path):
    (tmp_path / "hut.toml").write_text(HOME, encoding="utf-8")
    found = paths_in(SCENARIO.replace("smart_room", "hut.toml"))
    assert found.count("home") == len(OF_HOME)


def test_nothing_is_made_up_about_what_a_misspelt_name_may_stand_for(paths_in):
    """Which home it is, and so which places it has, is not known."""
    found = paths_in(SCENARIO.replace("home =", "hme ="))
    assert not {"home", "people[0].script[0].place", "people[1].start"} & set(found)
    assert "slots.people" in found


def test_a_scenario_of_which_nothing_is_right_is_told_of_field_by_field(paths_in):
    text = "name = 1\nhome = 2\nbehaviors = 3\npeople = 4\nrobots = 5\nslots = 6\n"
    assert paths_in(text) == ["name", "home", "behaviors", "people", "robots", "slots"]


@pytest.mark.parametrize(
    ("name", "size"),
    [
        ("evening", "4 people, 2 robots"),
        ("experiment_1", "1 person, 1 robot"),
        ("villa", "a home: 12 rooms, 14 regions"),
        ("phone", "a family: 2 to 5 people, up to 1 robot"),
        ("strict", "a persona: strict"),
    ],
)
def test_whatever_is_shipped_can_be_checked_by_its_name(name, size):
    assert check_file(name) == ()
    assert size_of_file(name) == size


@pytest.mark.parametrize("kind", ["scenario", "home", "family", "persona"])
def test_what_a_file_is_can_be_seen_from_its_fields(tmp_path, kind):
    for name, shipped_path in shipped(kind).items():
        path = tmp_path / f"other_than_{name}.toml"
        path.write_text(shipped_path.read_text(encoding="utf-8"), encoding="utf-8")
        assert check_file(path) == ()
        assert size_of_file(path)


@pytest.mark.parametrize("text", ["", "[tool.ruff]\nselect = []\n"])
def test_a_file_of_no_kind_is_told_what_there_is(tmp_path, text):
    path = tmp_path / "other.toml"
    path.write_text(text, encoding="utf-8")
    assert check_file(path) == (
        f"{path}: no file of ours; allowed: scenario, home, family, persona",
    )


LONG = "x" * 5000


@pytest.mark.parametrize(
    "text",
    [
        SCENARIO.replace("smart_room", LONG),
        SCENARIO.replace("smart_room", LONG[:4000]),
        SCENARIO.replace("smart_room", f"{LONG[:4000]}.toml"),
        SCENARIO.replace('"brak"', f'"{LONG}"'),
        SCENARIO.replace('"brak"', f'"{LONG[:100]}"'),
        SCENARIO.replace("stritc", LONG[:4000]),
        SCENARIO.replace('"plying"', f'"{LONG}"'),
        SCENARIO.replace("focus", LONG),
        SCENARIO.replace('"north"', f'"{LONG}"'),
        SCENARIO.replace("schedule.reading", f"schedule.{LONG}"),
        SCENARIO.replace("= nan", f"= {'7' * 4000}"),
        SCENARIO + f'\n[situation]\nattention = "{LONG}"\n',
        f"{LONG} = 1\n{SCENARIO}",
        HOME.replace('"table"', f'"{LONG}"'),
        HOME.replace("sleping", LONG),
    ],
)
def test_messages_cut_long_values(tmp_path, text):
    path = tmp_path / "long.toml"
    path.write_text(text, encoding="utf-8")
    lines = check_file(path)
    assert lines
    assert max(map(len, lines)) < len(str(path)) + 900


def test_of_countless_faults_the_first_are_told(tmp_path):
    path = tmp_path / "many.toml"
    path.write_text(
        SCENARIO.replace(
            "behaviors =", "".join(f"k{i} = 1\n" for i in range(3000)) + "behaviors ="
        ),
        encoding="utf-8",
    )
    lines = check_file(path)
    assert len(lines) == MOST + 1
    assert lines[-1].endswith("and more; mend these first")


FAMILY = """
name = "quiet"
demand = "Be quiet"
people = [5, 2]
robots = [1, 99]
personas = ["easygoing", "stritc"]
behaviors = ["sleep", "brak"]

[home]
rooms = [6, 4]
room_area = [12.0, 1e9]

[[residents]]

[residents.schedule.reading]
duration = [20.0, 10.0]
then = { calling = 1.0 }

[residents.schedule.unknown]
duration = [10.0, 20.0]
then = { reading = 0.0 }

[norms.reading.attending]
bark = -1.5
"""


def test_all_faults_of_a_family_are_told_at_once(paths_in):
    assert paths_in(FAMILY) == [
        "robots[1]",
        "home.room_area[1]",
        "norms.reading.attending.bark",
        "home.rooms",
        "people",
        "personas[1]",
        "behaviors[1]",
        "residents[0].schedule.reading.then",
        "residents[0].schedule.reading.duration",
        "residents[0].schedule.unknown",
        "residents[0].schedule.unknown.then",
    ]

"""Bad input: one line that names the file, the path in it and what is allowed."""

import re
import textwrap

import pytest

from household.config.toml import shipped
from household.errors import HouseholdError
from household.scenario.files import check_file
from household.scenario.validation import load_scenario

GOOD = """
name = "mine"
home = "smart_room"
behaviors = ["bark", "play"]

[[people]]
name = "ann"

[[people.script]]
place = "playing"
duration = [10.0, 20.0]
look_at = "robot_0"

[[people]]
name = "bob"
persona = "strict"
start = [4.3, 3.7]

[people.schedule.reading]
duration = [10.0, 20.0]
then = { desk = 1.0 }

[people.schedule.desk]
duration = [10.0, 20.0]
then = { reading = 1.0 }

[[robots]]
position = [2.6, 2.6]

[norms.playing.attending]
bark = -1.0

[behavior.juggle]
description = "Throws balls"
duration = 4.0

[perception]
focus = 30.0

[slots]
people = 4
"""

HOME = """
[home]
name = "hut"
walls = [
  { from = [0.0, 0.0], to = [4.0, 0.0] },
  { from = [4.0, 0.0], to = [4.0, 4.0] },
  { from = [4.0, 4.0], to = [0.0, 4.0] },
  { from = [0.0, 4.0], to = [0.0, 0.0] },
]

[[home.furniture]]
name = "table"
center = [3.3, 3.3]
size = [0.6, 0.6]

[[home.regions]]
name = "corner"
activity = "playing"
center = [2.0, 2.0]
facing = [2.0, 0.0]

[[home.regions]]
name = "chair"
activity = "reading"
center = [0.7, 3.3]
facing = [0.0, 3.3]
radius = 0.4
"""

INLINE = """
name = "mine"
behaviors = ["bark", "play"]

[[people]]
name = "ann"

[[people.script]]
place = "corner"
duration = [10.0, 20.0]

[[robots]]
position = [2.6, 2.6]
"""

FAULTS = {
    # What stands there, what stands there instead, the path, what the line says.
    "misspelt field": ('home = "', 'hme = "', "", "did you mean 'home'"),
    "misspelt nested field": ("look_at", "lok_at", "people[0].script[0]", "'look_at'"),
    "misspelt robot field": ("position", "positoin", "robots[0]", "'position'"),
    "misspelt table": ("[perception]", "[perceptoin]", "", "'perception'"),
    "missing field": ('name = "ann"', "", "people[0]", "name"),
    "unknown home": ('"smart_room"', '"smart_rom"', "home", "'smart_room'"),
    "unknown behavior": ('["bark"', '["brak"', "behaviors[0]", "'bark'"),
    "one behavior": ('["bark", "play"]', '["bark"]', "behaviors", "2"),
    "the same behavior twice": ('"play"]', '"bark"]', "behaviors", "once"),
    "unknown persona": ('"strict"', '"stritc"', "people[1].persona", "'strict'"),
    "persona file missing": (
        '"strict"',
        '"no/such.toml"',
        "people[1].persona",
        "no/such.toml",
    ),
    "duplicate name": ('"bob"', '"ann"', "people[1].name", "allowed"),
    "name of a robot": ('"bob"', '"robot_0"', "people[1].name", "allowed"),
    "ill-formed name": ('"bob"', '"Bob B."', "people[1].name", "a-z"),
    "unknown place": (
        'place = "playing"',
        'place = "plying"',
        "people[0].script[0].place",
        "'playing'",
    ),
    "unknown target": (
        'look_at = "robot_0"',
        'look_at = "robot_1"',
        "people[0].script[0].look_at",
        "'robot_0'",
    ),
    "looking at oneself": (
        'look_at = "robot_0"',
        'look_at = "ann"',
        "people[0].script[0].look_at",
        "bob",
    ),
    "neither duration nor until": (
        "duration = [10.0, 20.0]\nlook",
        "look",
        "people[0].script[0]",
        "until",
    ),
    "both duration and until": (
        "look_at",
        "until = 9.0\nlook_at",
        "people[0].script[0]",
        "until",
    ),
    "longest time first": (
        "[10.0, 20.0]\nlook",
        "[20.0, 10.0]\nlook",
        "people[0].script[0].duration",
        "shortest",
    ),
    "negative time": (
        "[10.0, 20.0]\nlook",
        "[-1.0, 20.0]\nlook",
        "people[0].script[0].duration[0]",
        "> 0",
    ),
    "script and schedule": (
        "[people.schedule.reading]",
        '[[people.script]]\nplace = "reading"\nuntil = 5.0\n[people.schedule.reading]',
        "people[1]",
        "allowed",
    ),
    "unknown place in a schedule": (
        "reading",
        "redaing",
        "people[1].schedule.redaing",
        "'reading'",
    ),
    "unknown place that cannot be printed": (
        "reading",
        r'"\uD7FC"',
        r"people[1].schedule.'\ud7fc'",
        "place",
    ),
    "unknown next place": (
        "desk = 1.0",
        "dsek = 1.0",
        "people[1].schedule.reading.then",
        "'desk'",
    ),
    "no way out of a place": (
        "desk = 1.0",
        "desk = 0.0",
        "people[1].schedule.reading.then",
        "above 0",
    ),
    "start in a wall": ("[4.3, 3.7]", "[8.0, 3.7]", "people[1].start", "allowed"),
    "start outdoors": ("[4.3, 3.7]", "[9.5, 3.7]", "people[1].start", "allowed"),
    "start in furniture": ("[4.3, 3.7]", "[5.0, 2.1]", "people[1].start", "allowed"),
    "robot in a wall": ("[2.6, 2.6]", "[0.0, 2.6]", "robots[0].position", "allowed"),
    "robot on a person": (
        "[2.6, 2.6]",
        "[4.3, 3.6]",
        "robots[0].position",
        "people[1].start",
    ),
    "robot on a person who begins in a region": (
        "[2.6, 2.6]",
        "[2.6, 1.9]",
        "robots[0].position",
        "people[0]",
    ),
    "norm out of range": (
        "bark = -1.0",
        "bark = -1.5",
        "norms.playing.attending.bark",
        ">= -1",
    ),
    "norm that is no number": (
        "bark = -1.0",
        "bark = nan",
        "norms.playing.attending.bark",
        "finite",
    ),
    "norm of an unknown behavior": (
        "bark = -1.0",
        "brak = -1.0",
        "norms.playing.attending",
        "'bark'",
    ),
    "norm of an unknown activity": (
        "norms.playing",
        "norms.plying",
        "norms",
        "'playing'",
    ),
    "norm with an unknown part": (
        "playing.attending",
        "playing.attendin",
        "norms.playing",
        "'attending'",
    ),
    "periods that are no multiples": (
        "behaviors =",
        "steering_period = 0.3\nbehaviors =",
        "decision_period",
        "steering_period",
    ),
    "tick longer than the period": (
        "behaviors =",
        "physics_period = 0.5\nbehaviors =",
        "steering_period",
        "physics_period",
    ),
    "infinite period": (
        "behaviors =",
        "decision_period = inf\nbehaviors =",
        "decision_period",
        "finite",
    ),
    "period that is no number": (
        "behaviors =",
        "decision_period = nan\nbehaviors =",
        "decision_period",
        "finite",
    ),
    "no decisions": (
        "behaviors =",
        "max_cycles = 0\nbehaviors =",
        "max_cycles",
        ">= 1",
    ),
    "decisions of the wrong type": (
        "behaviors =",
        'max_cycles = "many"\nbehaviors =',
        "max_cycles",
        "int",
    ),
    "place of the wrong type": ("[2.6, 2.6]", '"here"', "robots[0].position", "array"),
    "place with one number": ("[2.6, 2.6]", "[2.6]", "robots[0].position", "2"),
    "place that is no number": (
        "[2.6, 2.6]",
        "[nan, 2.6]",
        "robots[0].position",
        "finite",
    ),
    "place at infinity": ("[2.6, 2.6]", "[2.6, inf]", "robots[0].position", "finite"),
    "heading that is no number": (
        "[2.6, 2.6]",
        "[2.6, 2.6]\nheading = nan",
        "robots[0].heading",
        "finite",
    ),
    "time that is no number": (
        "[10.0, 20.0]\nlook",
        "[nan, 20.0]\nlook",
        "people[0].script[0].duration",
        "finite",
    ),
    "constant that is no number": (
        "focus = 30.0",
        "focus = nan",
        "perception.focus",
        "finite",
    ),
    "constant out of range": (
        "focus = 30.0",
        "focus = 200.0",
        "perception.focus",
        "180",
    ),
    "thresholds the wrong way round": (
        "focus = 30.0",
        "attend_above = 0.2\nattend_below = 0.3",
        "perception.attend_below",
        "attend_above",
    ),
    "unknown choice": (
        "[perception]",
        '[situation]\nattention = "robto"\n[perception]',
        "situation.attention",
        "'robot'",
    ),
    "unknown motion": (
        "duration = 4.0",
        'duration = 4.0\nmotion = "spinn"',
        "behavior.juggle.motion",
        "'spin'",
    ),
    "bout without length": (
        "duration = 4.0",
        "duration = 0.0",
        "behavior.juggle.duration",
        "> 0",
    ),
    "endless bout": (
        "duration = 4.0",
        "duration = inf",
        "behavior.juggle.duration",
        "finite",
    ),
    "too few slots": ("people = 4", "people = 1", "slots.people", "at least 2"),
    "too many slots": ("people = 4", "people = 65", "slots.people", "64"),
    "no robots": ("[[robots]]\nposition = [2.6, 2.6]", "", "", "`robots`"),
}

PERSONA_FAULTS = {
    "praise = 1.5": "praise",
    "praise = nan": "praise",
    "walking_speed = 0.0": "walking_speed",
    "walking_speed = nan": "walking_speed",
    "patience = -1.0": "patience",
    "field_of_view = 400.0": "field_of_view",
    "prase = 0.5": "'praise'",
    "[people.persona.preferences.playing.attending]\nbrak = 0.5": "'bark'",
}

HOME_FAULTS = {
    "region outside the plan": ("center = [2.0, 2.0]", "center = [9.0, 2.0]", "[0]"),
    "region in furniture": ("center = [2.0, 2.0]", "center = [3.3, 3.3]", "[0]"),
    "region that is no number": ("center = [2.0, 2.0]", "center = [nan, 2.0]", "[0]"),
    "unreachable region": (
        'furniture]]\nname = "table"\ncenter = [3.3, 3.3]\nsize = [0.6, 0.6]',
        'furniture]]\nname = "bar"\ncenter = [2.0, 2.7]\nsize = [4.0, 0.3]',
        "[1]",
    ),
    "gap in the wall": ("to = [0.0, 0.0]", "to = [0.0, 2.0]", "[0]"),
    "misspelt activity": ('activity = "playing"', 'activity = "plying"', "'playing'"),
    "misspelt field of a wall": ("from = [4.0, 4.0]", "form = [4.0, 4.0]", "'from'"),
    "furniture without size": ("size = [0.6, 0.6]", "size = [0.6, 0.0]", ">= 0.01"),
}


@pytest.fixture
def write(tmp_path):
    """Writes a scenario, one part of it changed, and gives its path."""

    def to_file(text: str, old: str = "", new: str = ""):
        assert old in text
        path = tmp_path / "mine.toml"
        path.write_text(text.replace(old, new) if old else text, encoding="utf-8")
        return path

    return to_file


def says(path, *parts):
    """The one line about a file; it names the file first, and holds these parts."""
    lines = check_file(path)
    assert len(lines) == 1, lines
    assert lines[0].isprintable()
    assert lines[0].startswith(f"{path}: ")
    for part in parts:
        assert part in lines[0]
    with pytest.raises(HouseholdError) as caught:
        load_scenario(str(path))
    assert str(caught.value) == lines[0]
    return lines[0]


def test_the_scenarios_that_the_faults_are_put_into_are_faultless(write):
    assert check_file(write(GOOD)) == ()
    assert check_file(write(INLINE + HOME)) == ()


def test_every_shipped_scenario_is_faultless(shipped_scenario):
    assert check_file(shipped("scenario")[shipped_scenario]) == ()
    assert check_file(shipped_scenario) == ()


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_is_told_in_one_line_with_file_and_path(write, fault):
    old, new, where, hint = FAULTS[fault]
    path = write(GOOD, old, new)
    line = says(path, hint)
    assert line.startswith(f"{path}: {where}")


@pytest.mark.parametrize("fault", PERSONA_FAULTS)
def test_a_fault_of_a_persona_in_the_file_is_told_with_its_path(write, fault):
    persona = f'start = [4.3, 3.7]\n\n[people.persona]\nname = "odd"\n{fault}\n'
    anonymous = GOOD.replace('persona = "strict"\n', "")
    path = write(anonymous, "start = [4.3, 3.7]\n", persona)
    line = says(path, PERSONA_FAULTS[fault])
    assert line.startswith(f"{path}: people[1].persona")


@pytest.mark.parametrize("fault", HOME_FAULTS)
def test_a_fault_of_a_home_in_the_file_is_told_with_its_path(write, fault):
    old, new, hint = HOME_FAULTS[fault]
    path = write(INLINE + HOME, old, new)
    # A gap in a wall puts both regions outdoors.
    lines = check_file(path)
    assert len(lines) == (2 if fault == "gap in the wall" else 1)
    assert all(line.startswith(f"{path}: home.") for line in lines)
    assert hint in lines[0]


def test_a_fault_in_a_file_that_the_scenario_names_is_told_with_that_file(
    write, tmp_path
):
    (tmp_path / "odd.toml").write_text('name = "odd"\nprase = 1.0\n', encoding="utf-8")
    path = write(GOOD, '"strict"', f'"{(tmp_path / "odd.toml").as_posix()}"')
    line = says(path, "odd.toml", "did you mean 'praise'")
    assert line.startswith(f"{path}: people[1].persona")


def test_several_faults_are_told_in_a_line_each(write):
    text = GOOD.replace('["bark"', '["brak"').replace('"bob"', '"ann"')
    lines = check_file(write(text, "[4.3, 3.7]", "[9.5, 3.7]"))
    paths = [re.split(r": ", line)[1] for line in lines]
    assert paths == ["behaviors[0]", "people[1].name", "people[1].start"]


def test_broken_toml_is_told_with_its_line(write):
    path = write(GOOD, 'home = "smart_room"', "home = ")
    assert re.search(r"line 3\b", says(path, "TOML"))


def test_what_is_not_text_is_not_toml(tmp_path):
    path = tmp_path / "picture.toml"
    path.write_bytes(b"\x89PNG\xff\xfe")
    says(path, "TOML")


@pytest.mark.parametrize("name", ["nowhere.toml", "folder.toml"])
def test_a_file_that_is_not_there_is_named(tmp_path, name):
    (tmp_path / "folder.toml").mkdir()
    says(tmp_path / name, "no such")


def test_an_unknown_scenario_is_answered_with_the_nearest_and_all_others():
    (line,) = check_file("evenin")
    assert "did you mean 'evening'" in line
    for name in shipped("scenario"):
        assert name in line
    assert "\n" not in line


@pytest.mark.parametrize(
    ("override", "value", "hint"),
    [
        ("max_cycle", 5, "did you mean 'max_cycles'"),
        ("max_cycles", -5, "max_cycles"),
        ("heterogeneity", 1.5, "heterogeneity"),
        ("home", "vila", "did you mean 'villa'"),
        ("behaviors", ["bark", "plya"], "behaviors[1]"),
        ("robots", [], "robots"),
        ("people", [], "people"),
    ],
)
def test_an_override_is_checked_like_what_stands_in_a_file(override, value, hint):
    with pytest.raises(HouseholdError) as caught:
        load_scenario("experiment_1", **{override: value})
    assert hint in str(caught.value)
    assert str(caught.value).isprintable()


def test_files_that_a_scenario_names_are_sought_from_its_own_folder(
    tmp_path, monkeypatch
):
    folder = tmp_path / "mine"
    folder.mkdir()
    (folder / "her.toml").write_text('name = "her"\npraise = 0.25\n')
    (folder / "here.toml").write_text(shipped("home")["studio"].read_text())
    scenario = """
        name = "mine"
        home = "here.toml"
        behaviors = ["play", "sleep"]
        people = [{ name = "ann", persona = "her.toml" }]
        robots = [{ position = [3.2, 2.4] }]
    """
    (folder / "mine.toml").write_text(textwrap.dedent(scenario))
    monkeypatch.chdir(tmp_path)
    loaded = load_scenario("mine/mine.toml")
    assert loaded.plan.name == "studio"
    assert loaded.personas[0].praise == 0.25

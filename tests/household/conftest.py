import pytest

from household import household_v0

BUSY_HOME = """
name = "busy"
home = "two_room_flat"
max_cycles = 300
behaviors = ["bark", "play", "say_hello", "sleep", "follow"]

[[people]]
name = "anna"
script = [
  { place = "working", duration = [20.0, 40.0] },
  { place = "playing", duration = [20.0, 40.0], look_at = "robot_0" },
]

[[people]]
name = "ben"
script = [
  { place = "reading", duration = [20.0, 40.0], look_at = "anna" },
  { place = "calling", duration = [20.0, 40.0] },
]

[[people]]
name = "cleo"
script = [
  { place = "sleeping", duration = [60.0, 80.0] },
  { place = "playing", duration = [20.0, 40.0] },
]

[[robots]]
position = [2.0, 2.0]

[[robots]]
position = [4.5, 1.5]
"""


@pytest.fixture
def make_busy_home(tmp_path_factory):
    """Makes a flat with three people and two robots that walk about."""
    path = tmp_path_factory.mktemp("scenario") / "busy.toml"
    path.write_text(BUSY_HOME, encoding="utf-8")

    def make(**options):
        return household_v0.parallel_env(path, **options)

    return make


@pytest.fixture
def busy_home(make_busy_home):
    return make_busy_home()

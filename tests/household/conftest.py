import numpy as np
import pytest

from household import household_v0
from household.motion.bodies import BodyParams
from household.motion.crowd import Crowd
from household.simulation.simulation import PERSON_MASS, PERSON_RADIUS

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


@pytest.fixture(scope="session")
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


@pytest.fixture(scope="session")
def people():
    """Makes the radii and the masses of so many people."""

    def make(n):
        return np.full(n, PERSON_RADIUS), np.full(n, PERSON_MASS)

    return make


@pytest.fixture(scope="session")
def crowd_in(people):
    """Puts people somewhere in a home."""

    def make(plan, position, speed=1.2):
        n = len(position)
        crowd = Crowd(plan, BodyParams(*people(n), np.full(n, speed)), 0.2, 0.1)
        crowd.place(np.array(position, dtype=float), np.zeros(n))
        return crowd

    return make


@pytest.fixture(scope="session")
def walk():
    """Sends everybody on its way; returns when each arrived [s] and all positions."""

    def send(crowd, goals, most):
        for i, goal in enumerate(goals):
            crowd.send(i, goal)
        arrived, track = {}, [crowd.position.copy()]
        for moment in range(round(most / 0.2)):
            crowd.advance()
            track.append(crowd.position.copy())
            for i in range(len(goals)):
                if i not in arrived and not crowd.walks(i):
                    arrived[i] = 0.2 * (moment + 1)
        return arrived, np.array(track)

    return send

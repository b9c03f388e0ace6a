"""What tests of several packages share: plain rooms, scenarios in them, episodes."""

import os

import msgspec
import numpy as np
import pytest

from household.activity import Activity
from household.compiled.jit import CHECKED
from household.config.toml import shipped
from household.feedback import Cause
from household.home.floorplan import Door, FloorPlan, Furniture, Region, Wall
from household.home.geometry import distance_to_box, distance_to_segments
from household.people.mind import Appraisals, Condition, Percepts, Surroundings
from household.scenario.scenario import PersonSpec, RobotSpec, Scenario, ScriptStep

os.environ[CHECKED] = "1"
"""Bound functions check what they are handed over, here and in all processes that tests
start."""

SHIPPED = tuple(shipped("scenario"))

FIRST = (
    "tests/household/test_environment_contract.py",
    "tests/learners/",
    "tests/experiments/running/engine/",
    "tests/test_smoke.py",
)
"""What begins. After a change nearly everything that is compiled is compiled in the
first of these; meanwhile other processes run tests that need nothing of it, instead of
compiling it too."""


def pytest_collection_modifyitems(items):
    """Puts `FIRST` first; what follows keeps its order."""
    items.sort(
        key=lambda item: [not item.nodeid.startswith(start) for start in FIRST],
    )


def pytest_generate_tests(metafunc):
    """A test that asks for ``shipped_scenario`` runs once for each of them."""
    if "shipped_scenario" in metafunc.fixturenames:
        metafunc.parametrize("shipped_scenario", SHIPPED, scope="module")


@pytest.fixture(scope="session")
def room():
    """Makes a bare room, 8 m x 5 m: a phone at (1, 2.5) and a rug at (7, 1)."""

    def make(
        walls: tuple[tuple[float, float, float, float], ...] = (),
        doors: tuple[Door, ...] = (),
        furniture: tuple[Furniture, ...] = (),
        regions: tuple[Region, ...] | None = None,
        size: tuple[float, float] = (8.0, 5.0),
    ) -> FloorPlan:
        x, y = size
        outer = ((0, 0, x, 0), (x, 0, x, y), (x, y, 0, y), (0, y, 0, 0))
        usual = (
            Region(
                name="phone", activity="calling", center=(1.0, 2.5), facing=(0.0, 2.5)
            ),
            Region(
                name="rug", activity="playing", center=(7.0, 1.0), facing=(7.0, 0.0)
            ),
        )
        return FloorPlan(
            name="bare_room",
            walls=tuple(
                Wall(start=(x1, y1), end=(x2, y2))
                for x1, y1, x2, y2 in (*outer, *walls)
            ),
            doors=doors,
            furniture=furniture,
            regions=usual if regions is None else regions,
        )

    return make


@pytest.fixture(scope="session")
def household_of(room):
    """Makes a scenario: one person on the phone, one robot, bark or sleep."""

    def make(**changes: object) -> Scenario:
        usual = Scenario(
            name="test_household",
            home=room(),
            max_cycles=60,
            behaviors=("bark", "sleep"),
            people=(
                PersonSpec(
                    name="ann",
                    script=(ScriptStep(place="phone", duration=(900.0, 900.0)),),
                ),
            ),
            robots=(RobotSpec(position=(6.0, 2.5)),),
        )
        return msgspec.structs.replace(usual, **changes)

    return make


@pytest.fixture(scope="session")
def percepts():
    """Makes what people perceive in a quiet moment, everybody the same.

    ``bouts`` are what each appraises now: (value, robot, whether it attended to it).
    """

    def make(
        n: int = 2,
        robots: int = 2,
        bouts: tuple[tuple[float, int, bool], ...] = (),
        **changes: object,
    ) -> Percepts:
        arrays = {
            "new": np.zeros((n, robots), dtype=bool),
            "value": np.zeros((n, robots)),
            "believed": np.zeros((n, robots), dtype=np.intp),
            "attending": np.zeros((n, robots), dtype=bool),
        }
        for place, bout in enumerate(bouts):
            for array, found in zip(arrays.values(), (True, *bout), strict=True):
                array[:, place] = found
        usual = {
            "activity": (int(Activity.PLAYING), np.intp, (n,)),
            "arrived": (True, bool, (n,)),
            "touched": (False, bool, (n,)),
            "mood": (0.0, float, (n,)),
            "pleasing": (False, bool, (n, robots)),
            "moving": (False, bool, (robots,)),
            "sees": (False, bool, (n, n + robots)),
            "level": (0.0, float, (n, n + robots)),
        }
        for name, (value, kind, shape) in usual.items():
            filled = np.asarray(changes.pop(name, value), dtype=kind)
            arrays[name] = np.broadcast_to(filled, shape).copy()
        records = {
            name: kind(**{field: arrays[field] for field in kind._fields})
            for name, kind in (
                ("condition", Condition),
                ("surroundings", Surroundings),
                ("appraisals", Appraisals),
            )
        }
        clock = {"time": 0.0, "period": 1.0}
        return Percepts(
            cause=lambda robot, now: Cause(f"robot_{robot}", 7, 0, now),
            **records,
            **(clock | changes),
        )

    return make


@pytest.fixture(scope="session")
def same():
    """Whether two nested structures hold the same values, arrays by their bytes."""

    def equal(one: object, other: object) -> bool:
        if isinstance(one, dict):
            return (
                isinstance(other, dict)
                and list(one) == list(other)
                and all(equal(one[key], other[key]) for key in one)
            )
        if isinstance(one, list | tuple):
            return (
                type(one) is type(other)
                and len(one) == len(other)
                and all(map(equal, one, other))
            )
        if isinstance(one, np.ndarray):
            return (
                isinstance(other, np.ndarray)
                and (one.dtype, one.shape) == (other.dtype, other.shape)
                and one.tobytes() == other.tobytes()
            )
        return type(one) is type(other) and one == other

    return equal


@pytest.fixture(scope="session")
def random_actions():
    """Makes an endless stream of random actions for an environment's agents."""

    def stream(env, seed: int):
        rng = np.random.default_rng(seed)
        n = len(env.behaviors)
        while True:
            yield {agent: int(rng.integers(n)) for agent in env.possible_agents}

    return stream


@pytest.fixture(scope="session")
def deepest():
    """Measures how far bodies overlap walls and furniture [m]; negative: clear."""

    def measure(plan, position, radius):
        gap = distance_to_segments(position, plan.wall_segments).min(axis=1)
        depth = plan.wall_thickness / 2 + radius - gap
        for box in plan.furniture:
            away = distance_to_box(position, box.center, box.size, box.angle)
            depth = np.maximum(depth, radius - away)
        return float(depth.max())

    return measure

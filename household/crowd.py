"""The crowd: everybody's body, where it is heading and where it looks.

People come first and robots after them, in every array. The crowd plans walks, steers
along them and turns heads; it knows nothing of why anyone goes anywhere.
"""

import math

import numpy as np
from numpy.typing import NDArray

from household.home.floorplan import FloorPlan
from household.home.routes import routes_of
from household.locomotion import steer
from household.world import World

Array = NDArray[np.float64]
Waypoints = list[tuple[float, float]]

PASSED = 0.15
"""Distance at which a waypoint on the way counts as passed [m]."""

ARRIVED = 0.05
"""Distance at which a walk ends [m]."""

PROGRESS = 0.05
"""How much nearer to its waypoint a walker must come not to be stuck [m]."""

STUCK = 2.0
"""Time without progress after which a walker tries another way [s]."""

DRIFT = 0.1
"""How far a body lets itself be pushed before it steps back to its place [m]."""

CROWDED = 1.0
"""Where others stand in its place, a walker settles for this near to it [m]."""

SIDESTEP = 0.7
"""How far a walker that is stuck steps aside before it goes on [m]."""

NECK = math.pi / 2
"""How far a head turns from the body [rad]."""

GOLDEN_ANGLE = math.pi * (3.0 - math.sqrt(5.0))
"""Between the directions of sidesteps, so that repeated ones try all sides [rad]."""


class Crowd:
    """Bodies on the move.

    Args:
        plan: The home.
        radius: Of each body, shape (n,) [m].
        mass: Of each body, shape (n,) [kg].
        speed: Of each body when it walks, shape (n,) [m/s].
        steering_period: Time between looks at where everybody walks [s].
        physics_period: Length of a physics tick [s].

    Attributes:
        position: Where every body is, shape (n, 2) [m].
        heading: Where every body faces, shape (n,) [rad].
        gaze: Where every head points, shape (n,) [rad].
        walk_began: Since when each body has been walking, NaN if it stands [s].
    """

    def __init__(
        self,
        plan: FloorPlan,
        radius: Array,
        mass: Array,
        speed: Array,
        steering_period: float,
        physics_period: float,
    ) -> None:
        n = len(radius)
        self._world = World(plan, radius, mass)
        self._routes = routes_of(plan)
        self._radius, self._speed = radius, speed
        self._period, self._tick = steering_period, physics_period
        self._ticks = round(steering_period / physics_period)
        self._ways: list[Waypoints] = [[] for _ in range(n)]
        self._waypoint = np.zeros((n, 2))
        self._pace = np.zeros(n)
        self._nearest = np.full(n, np.inf)
        self._stalled = np.zeros(n)
        self._sidesteps = 0
        self._settled: list[tuple[float, float] | None] = [None] * n
        self._moving = False
        self.position = np.zeros((n, 2))
        self.heading = np.zeros(n)
        self.gaze = np.zeros(n)
        self.walk_began = np.full(n, np.nan)

    def place(self, position: Array, heading: Array) -> None:
        """Puts everybody somewhere, at rest and looking ahead."""
        self._world.place(position)
        self.position = position.copy()
        self.heading = heading.copy()
        self.gaze = heading.copy()
        self._pace[:] = 0.0
        self._sidesteps = 0
        self._ways = [[] for _ in self._ways]
        self._settled = [None] * len(self._ways)
        self.walk_began[:] = np.nan
        self._moving = False

    def walks(self, i: int) -> bool:
        """Whether a body is on its way somewhere."""
        return bool(self._pace[i] > 0.0)

    def is_bound_for(self, i: int, goal: tuple[float, float]) -> bool:
        """Whether a body is at a point, on its way there, or as near as others let it.

        Args:
            i: Index of the body.
            goal: [m].
        """
        if self.walks(i):
            return math.dist(self._ways[i][-1], goal) <= DRIFT
        away = math.dist(self.position[i], goal)
        settled = self._settled[i]
        crowded = settled is not None and math.dist(settled, goal) <= DRIFT
        return away <= (CROWDED if crowded else DRIFT)

    def send(self, i: int, goal: tuple[float, float], now: float) -> bool:
        """Sends a body on a walk.

        Args:
            i: Index of the body.
            goal: Where to [m]; the nearest place where it fits is good enough.
            now: [s].

        Returns:
            Whether a way leads there.
        """
        way = self._routes.plan(self._where(i), goal)
        if not way:
            self.halt(i)
            return False
        if not self.walks(i):
            self.walk_began[i] = now
        self._take(i, way)
        self._pace[i] = self._speed[i]
        self._settled[i] = None
        return True

    def halt(self, i: int) -> None:
        """Ends a body's walk where it is."""
        self._ways[i] = []
        self._pace[i] = 0.0
        self.walk_began[i] = np.nan

    def advance(self) -> None:
        """Lets one steering period pass."""
        if not (self._moving or self._pace.any()):
            return
        velocity = steer(
            self.position, self._waypoint, self._pace, self._radius, self._period
        )
        before = self.position
        self.position = self._world.advance(velocity, self._tick, self._ticks)
        # Bodies that were pushed come to rest in the period after.
        self._moving = bool(np.abs(self.position - before).max() > 1e-6)
        for i in np.flatnonzero(self._pace):
            self.heading[i] = math.atan2(velocity[i, 1], velocity[i, 0])
            self._progress(int(i))

    def _progress(self, i: int) -> None:
        """Passes waypoints, ends the walk at the last, and notices when stuck."""
        way = self._ways[i]
        left = math.dist(self.position[i], way[0])
        if left <= (PASSED if len(way) > 1 else ARRIVED):
            self._pass_waypoint(i)
            return
        if left < self._nearest[i] - PROGRESS:
            self._nearest[i] = left
            self._stalled[i] = 0.0
            return
        self._stalled[i] += self._period
        if self._stalled[i] >= STUCK:
            self._try_another_way(i)

    def _pass_waypoint(self, i: int) -> None:
        if len(self._ways[i]) > 1:
            self._take(i, self._ways[i][1:])
        else:
            self.halt(i)

    def _take(self, i: int, way: Waypoints) -> None:
        """Heads for the first waypoint of a way."""
        self._ways[i] = way
        self._waypoint[i] = way[0]
        self._nearest[i] = math.inf
        self._stalled[i] = 0.0

    def _try_another_way(self, i: int) -> None:
        """Settles for a place near the goal, or steps aside and plans anew."""
        self._stalled[i] = 0.0
        goal = self._ways[i][-1]
        if math.dist(self.position[i], goal) <= CROWDED:
            self.halt(i)
            self._settled[i] = goal
            return
        self._sidesteps += 1
        angle, here = self._sidesteps * GOLDEN_ANGLE, self._where(i)
        aside = (
            here[0] + SIDESTEP * math.cos(angle),
            here[1] + SIDESTEP * math.sin(angle),
        )
        way = self._routes.plan(here, aside)
        way += self._routes.plan(way[-1], goal) if way else []
        if way:
            self._take(i, way)

    def _where(self, i: int) -> tuple[float, float]:
        x, y = self.position[i].tolist()
        return x, y

    def turn_heads(self, target: Array, most: Array) -> None:
        """Turns every head towards where it wants to look.

        Args:
            target: Wanted directions, shape (n,) [rad].
            most: How far each head can turn in this time, shape (n,) [rad].
        """
        turn = _wrapped(target - self.gaze)
        self.gaze = self.gaze + np.clip(turn, -most, most)
        # The body follows where the neck does not reach.
        strain = _wrapped(self.gaze - self.heading)
        self.heading = self.heading + strain - np.clip(strain, -NECK, NECK)


def _wrapped(angle: Array) -> Array:
    """An angle in [-pi, pi) [rad]."""
    return (angle + np.pi) % (2 * np.pi) - np.pi

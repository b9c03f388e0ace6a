"""The crowd: everybody's body, where it is heading and where it looks.

People come first and robots after them, in every array. The crowd plans walks, steers
along them and turns heads; it knows nothing of why anyone goes anywhere.
"""

import math
from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from household.compiled.arrays import NOBODY, Floats, Indices, Mask, Zeros, new_zeros
from household.compiled.jit import (
    FLOAT,
    FLOATS_2D,
    FLOATS_3D,
    INDEX,
    INDICES,
    MASK,
    TRUTH,
    bind,
)
from household.config.toml import Point
from household.home.floorplan import FloorPlan
from household.home.navigation.routes import routes_of
from household.motion.free_walking import walk_freely
from household.motion.paths import Paths, set_out
from household.motion.physics import Physics
from household.motion.progress import (
    CROWDED,
    STUCK,
    are_pressed,
    arrived,
    follow_up,
    is_bound_for,
    needs_replan,
    turn_heads,
)
from household.motion.steering import PUSHY
from household.state import Stateful

if TYPE_CHECKING:
    from pymunk import Space


SIDESTEP = 0.7
"""How far a walker that is stuck steps aside before it goes on [m]."""

GOLDEN_ANGLE = math.pi * (3.0 - math.sqrt(5.0))
"""Between the directions of sidesteps, so that repeated ones try all sides [rad]."""


NO_TARGET: Indices = np.zeros(0, np.intp)
"""Nobody is after anybody."""


class BodyParams(NamedTuple):
    """What bodies are like.

    Attributes:
        radius: Of each, shape (n,) [m].
        mass: Of each, shape (n,) [kg].
        speed: Of each when it walks, shape (n,) [m/s].
    """

    radius: Floats
    mass: Floats
    speed: Floats


class Crowd(Stateful):
    """Bodies on the move.

    Args:
        plan: The home.
        build: What the bodies are like.
        steering_period: Time between looks at where everybody walks [s].
        physics_period: Length of a physics tick [s].
        zeros: Makes the arrays that others see: `position`, `heading` and `gaze`.

    The arrays are the same from moment to moment, with new values in them.

    Attributes:
        position: Where every body is, shape (n, 2) [m].
        heading: Where every body faces, shape (n,) [rad].
        gaze: Where every head points, shape (n,) [rad].
        walking: Who is on its way somewhere, shape (n,).
        walk_began: When each began the walk that it is on, or was on last, (n,) [s].
    """

    STATE = (
        "position",
        "heading",
        "gaze",
        "walking",
        "walk_began",
        "_paths",
        "_nearest",
        "_stalled",
        "_settled",
        "_sidesteps",
        "_pressed",
        "_where",
    )

    def __init__(
        self,
        plan: FloorPlan,
        build: BodyParams,
        steering_period: float,
        physics_period: float,
        zeros: Zeros = new_zeros,
    ) -> None:
        radius, mass, speed = build
        n = len(radius)
        self._physics = physics = Physics(plan, radius, mass)
        self._routes = routes_of(plan)
        self._tick = physics_period
        self._ticks = round(steering_period / physics_period)
        self._paths = Paths(n)
        self._nearest = np.full(n, np.inf)
        self._stalled = np.zeros(n)
        self._sidesteps = 0
        self._settled = np.full((n, 2), np.nan)
        self._goals = np.zeros((n, 2))
        self._nobody = np.full(n, NOBODY)
        self._pressed = False
        self._where: list[Point] | None = None
        self.position: Floats = zeros("position", (n, 2))
        self.heading: Floats = zeros("heading", (n,))
        self.gaze: Floats = zeros("gaze", (n,))
        self.walking = np.zeros(n, np.bool_)
        self.walk_began = np.full(n, np.nan)
        # What the loops work on is always the same.
        self._needs_replan = np.zeros(n, np.bool_)
        bodies = self.position, self.walking
        progress = self._nearest, self._stalled
        walks = *bodies, *progress, self._settled, self.walk_began
        paths = FLOATS_3D, INDICES, INDICES
        self._are_pressed = bind(are_pressed, *bodies, radius)
        self._follow_up = bind(
            follow_up,
            self.walking,
            *progress,
            self._settled,
            radius,
            steering_period,
            self.position,
            then=paths,
        )
        self._walk_freely = bind(
            walk_freely,
            self.position,
            physics.velocity,
            self.heading,
            self.walking,
            *progress,
            self._settled,
            speed,
            radius,
            physics.solid,
            physics.thickness,
            physics.boxes,
            self._ticks,
            self._tick,
            then=(*paths, INDICES, FLOAT, INDEX, TRUTH),
        )
        self._set_out = bind(
            set_out,
            *self._routes.arrays,
            *walks,
            self._needs_replan,
            then=(*paths, FLOATS_2D, INDICES, FLOAT, TRUTH),
        )
        self._arrived = bind(arrived, *bodies, self._settled, then=(FLOATS_2D, MASK))
        self._is_bound_for = bind(
            is_bound_for,
            *bodies,
            self._settled,
            then=(FLOATS_3D, INDICES, INDEX, FLOAT, FLOAT),
        )
        self._astray = bind(
            needs_replan,
            *bodies,
            self._settled,
            self._needs_replan,
            then=(FLOATS_3D, INDICES, FLOATS_2D, INDICES),
        )
        # Looks come from minds, which anybody may write: not `bind`.
        self._turn_heads = partial(turn_heads, self.gaze, self.heading, *bodies)

    def place(self, position: Floats, heading: Floats) -> None:
        """Puts everybody somewhere, at rest and looking ahead."""
        self.position[:] = position
        self.heading[:] = self.gaze[:] = heading
        self._where = None
        self.walking[:] = False
        self._sidesteps = 0
        self._nearest[:], self._stalled[:] = np.inf, 0.0
        self._settled[:] = np.nan
        self._pressed = False

    @property
    def where(self) -> list[Point]:
        """`position` in Python's own numbers: a tenth of the time to read."""
        if self._where is None:
            xs, ys = self.position.T.tolist()
            self._where = list(zip(xs, ys, strict=True))
        return self._where

    @property
    def space(self) -> "Space":
        """The physics engine's, for those who measure it."""
        return self._physics.space

    def walks(self, i: int) -> bool:
        """Whether a body is on its way somewhere."""
        return bool(self.walking[i])

    def walks_since(self, i: int) -> float | None:
        """Since when a body has been on its way, None if it stands [s]."""
        return float(self.walk_began[i]) if self.walks(i) else None

    def is_bound_for(self, i: int, goal: Point) -> bool:
        """Whether a body is at a point, on its way there, or as near as others let it.

        Args:
            i: Index of the body.
            goal: [m].
        """
        return self._is_bound_for(self._paths.points, self._paths.count, i, *goal)

    def arrived(self, goals: Floats, there: Mask) -> None:
        """Who stands at its goal, or as near to it as others let it.

        Args:
            goals: One for each of the first bodies, shape (m, 2) [m].
            there: Shape (m,); filled in.
        """
        self._arrived(goals, there)

    def send(self, i: int, goal: Point, now: float) -> bool:
        """Sends a body on a walk.

        Args:
            i: Index of the body.
            goal: Where to [m]; the nearest place where it fits is good enough.
            now: [s].

        Returns:
            Whether a way leads there.
        """
        self._needs_replan[i] = True
        self._goals[i] = goal
        return self._replan(self._goals, self._nobody, now, places=False)

    def send_who_needs_replan(
        self, goals: Floats, target: Indices, now: float, but: Sequence[int] = ()
    ) -> None:
        """Sends everybody on a walk who is not bound for where it wants to be.

        Args:
            goals: One for each of the first bodies, shape (m, 2) [m].
            target: Whom each is after instead, `NOBODY` for none, shape (m,).
            now: [s].
            but: Who stays as it is.
        """
        paths = self._paths
        if not self._astray(paths.points, paths.count, goals, target):
            return
        for i in but:
            self._needs_replan[i] = False
        self._replan(goals, target, now, places=True)

    def _replan(
        self, goals: Floats, target: Indices, now: float, *, places: bool
    ) -> bool:
        """Sends all who are lost on a walk; returns whether a way leads anybody."""
        paths = self._paths
        arrays = paths.points, paths.at, paths.count
        most = self._set_out(*arrays, goals, target, now, places)
        if most > paths.points.shape[1]:
            paths.make_room(most)
            return self._replan(goals, target, now, places=places)
        self._needs_replan.fill(False)
        return most > 0

    def halt(self, i: int) -> None:
        """Ends a body's walk where it is."""
        self.walking[i] = False

    def advance(
        self, periods: int = 1, target: Indices = NO_TARGET, reach: float = 0.0
    ) -> int:
        """Lets some steering periods pass.

        Args:
            periods: How many at most.
            target: Whom each of the first bodies is after, `NOBODY` for none, (m,).
            reach: How near to its target it wants to get [m].

        Returns:
            How many have passed: fewer, if somebody has something to decide, such as
            who may be within reach of its target.
        """
        if not (self._pressed or True in self.walking.tolist()):
            return periods if set(target.tolist()) <= {NOBODY} else 1
        paths = self._paths.points, self._paths.at, self._paths.count
        passed, stuck = self._walk_freely(*paths, target, reach, periods, self._pressed)
        if passed == 0:
            passed, stuck = 1, self._push_on(*paths)
        self._where = None
        if stuck:
            self._free_the_stuck()
        return passed

    def _push_on(self, points: Floats, at: Indices, count: Indices) -> bool:
        """Walks for a period with the engine's help: bodies push each other."""
        self.position[:] = self._physics.advance(self.position, self._tick, self._ticks)
        stuck = self._follow_up(points, at, count)
        self._pressed = self._are_pressed()
        return stuck

    def _free_the_stuck(self) -> None:
        """Who is stuck tries another way."""
        for i in (self.walking & (self._stalled >= STUCK)).nonzero()[0].tolist():
            self._try_another_way(i)

    def _try_another_way(self, i: int) -> None:
        """Settles for a place near the goal, or steps aside and plans anew."""
        self._stalled[i] = PUSHY  # It goes on to push, until it comes nearer.
        goal = self._paths.goal(i)
        if math.dist(self.where[i], goal) <= CROWDED:
            self.halt(i)
            self._settled[i] = goal
            return
        self._sidesteps += 1
        angle, here = self._sidesteps * GOLDEN_ANGLE, self.where[i]
        aside = (
            here[0] + SIDESTEP * math.cos(angle),
            here[1] + SIDESTEP * math.sin(angle),
        )
        way = self._routes.plan(here, aside)
        way += self._routes.plan(way[-1], goal) if way else []
        if way:
            self._paths.take(i, way)
            self._nearest[i] = math.inf

    def turn_heads(self, look: Indices, focus: Floats, most: Floats) -> None:
        """Turns every head towards where it wants to look; robots look ahead.

        Args:
            look: Whom each of the first bodies looks at, `NOBODY` for none, (m,).
            focus: What each of them looks at then, unless it walks, NaN for nothing,
                shape (m, 2) [m].
            most: How far each head can turn in this time, shape (n,) [rad].
        """
        self._turn_heads(look, focus, most)

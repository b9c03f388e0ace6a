"""The crowd: everybody's body, where it is heading and where it looks.

People come first and robots after them, in every array. The crowd plans walks, steers
along them and turns heads; it knows nothing of why anyone goes anywhere.
"""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from household.compiled.arrays import NOBODY, Floats, Indices, Mask, Zeros, new_zeros
from household.compiled.jit import bind
from household.config.toml import Point
from household.home.floorplan import FloorPlan
from household.home.navigation.routes import routes_of
from household.motion.bodies import (
    NO_PURSUIT,
    BodyParams,
    Goals,
    Pursuit,
    bodies_at_rest,
    no_walks,
)
from household.motion.detours import detour
from household.motion.free_walking import Ticks, walk_freely
from household.motion.heads import turn_heads
from household.motion.paths import (
    end_of,
    find_paths,
    no_departures,
    no_paths,
    set_out,
    with_path,
    with_room,
)
from household.motion.physics import Physics
from household.motion.progress import (
    CROWDED,
    STUCK,
    arrived,
    find_who_needs_replan,
    follow_up_push,
    is_bound_for,
)
from household.motion.steering import PUSHY, steer
from household.state import Stateful

if TYPE_CHECKING:
    from pymunk import Space


class Crowd(Stateful):
    """Bodies on the move.

    Args:
        plan: The home.
        params: What the bodies are like.
        steering_period: Time between looks at where everybody walks [s].
        physics_period: Length of a physics tick [s].
        zeros: Makes the arrays that are recorded: `position`, `heading` and `gaze`.

    The arrays are the same from moment to moment, with new values in them.

    Attributes:
        position: Where every body is, shape (n, 2) [m].
        heading: Where every body faces, shape (n,) [rad].
        gaze: Where every head points, shape (n,) [rad].
        walking: Whether each body is on a walk, shape (n,).
    """

    STATE = (
        "position",
        "heading",
        "gaze",
        "_walks",
        "_paths",
        "_departures",
        "_unplanned",
        "_sidesteps",
        "_pressed",
        "_where",
    )

    def __init__(
        self,
        plan: FloorPlan,
        params: BodyParams,
        steering_period: float,
        physics_period: float,
        zeros: Zeros = new_zeros,
    ) -> None:
        n = len(params.radius)
        self._physics = physics = Physics(plan, params.radius, params.mass)
        self._routes = routes_of(plan)
        self._ticks = Ticks(round(steering_period / physics_period), physics_period)
        bodies = bodies_at_rest(params, physics.velocity, zeros)
        self._walks = walks = no_walks(n)
        self._paths = no_paths(n)
        self._departures = departures = no_departures(n)
        self._sidesteps = 0
        self._unplanned = self._pressed = False
        self._where: list[Point] | None = None
        self.position, self.heading, self.gaze = (
            bodies.position,
            bodies.heading,
            bodies.gaze,
        )
        self.walking = walks.walking
        period = self._ticks.number * self._ticks.duration
        self._steer = bind(steer, bodies, walks, period)
        self._walk_freely = bind(
            walk_freely, bodies, walks, physics.obstacles, self._ticks
        )
        self._follow_up_push = bind(follow_up_push, bodies, walks, steering_period)
        standing = self.position, walks.walking, walks.settled
        self._arrived = bind(arrived, *standing)
        self._is_bound_for = bind(is_bound_for, *standing)
        self._find_who_needs_replan = bind(
            find_who_needs_replan, *standing, departures.due
        )
        navigation = self._routes.navigation
        self._set_out = bind(
            set_out, navigation.grid, self.position, walks.walking, departures
        )
        self._find_paths = bind(
            find_paths, navigation, self.position, walks, departures
        )
        self._turn_heads = bind(turn_heads, bodies, walks.walking)

    def place(self, position: Floats, heading: Floats) -> None:
        """Puts everybody somewhere, at rest and looking ahead."""
        self.position[:] = position
        self.heading[:] = self.gaze[:] = heading
        self._where = None
        self.walking[:] = False
        self._sidesteps = 0
        self._walks.nearest[:], self._walks.stalled[:] = np.inf, 0.0
        self._walks.settled[:] = np.nan
        self._departures.unplanned[:] = False
        self._unplanned = self._pressed = False

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
        """Whether a body is on a walk."""
        return bool(self.walking[i])

    def is_bound_for(self, i: int, goal: Point) -> bool:
        """Whether a body is at a goal, on its way there, or as near as others let it.

        Args:
            i: Index of the body.
            goal: [m].
        """
        if self._departures.unplanned[i]:
            self.find_paths()
        return self._is_bound_for(self._paths, i, goal)

    def arrived(self, goals: Floats, there: Mask) -> None:
        """Finds out who stands at its goal, or as near to it as others let it.

        Args:
            goals: One for each of the first bodies, shape (m, 2) [m].
            there: Set to who does, shape (m,).
        """
        self._arrived(goals, there)

    def send(self, i: int, goal: Point) -> None:
        """Sends a body on a walk; if no path leads there, that ends where it begins.

        Args:
            i: Index of the body.
            goal: Where to [m]; the nearest place where it fits is good enough.
        """
        departures, paths = self._departures, self._paths
        if departures.unplanned[i]:
            self.find_paths()
        if not self.walking[i]:
            paths.length[i] = paths.at[i]  # Nothing of the last one is left.
        departures.goal[i], departures.shared[i] = goal, False
        self.walking[i] = departures.unplanned[i] = self._unplanned = True

    def send_who_needs_replan(self, goals: Goals, but: Sequence[int] = ()) -> None:
        """Sends everybody on a walk who is neither at its goal nor on its way there.

        Args:
            goals: Where the first bodies want to be.
            but: Who stays as it is.
        """
        self.find_paths()
        if not self._find_who_needs_replan(self._paths, goals):
            return
        for i in but:
            self._departures.due[i] = False
        self._unplanned = self._set_out(self._paths, goals)

    def find_paths(self) -> bool:
        """Finds the paths of all who have set out; done before anything needs them.

        Returns:
            Whether there were any to find.
        """
        if not self._unplanned:
            return False
        self._unplanned = False
        most = self._find_paths(self._paths)
        if most > self._paths.points.shape[1]:
            self._paths = with_room(self._paths, most)
            self._find_paths(self._paths)
        return True

    def halt(self, i: int) -> None:
        """Ends a body's walk where it is."""
        if self._departures.unplanned[i]:
            self.find_paths()
        self.walking[i] = False

    def advance(self, periods: int = 1, pursuit: Pursuit = NO_PURSUIT) -> int:
        """Lets some steering periods pass.

        Args:
            periods: How many at most.
            pursuit: Whom the first bodies follow.

        Returns:
            How many have passed: fewer, if somebody has something to decide, such as a
            body that may be within reach of its target.
        """
        self.find_paths()
        if not (self._pressed or True in self.walking.tolist()):
            return periods if set(pursuit.target.tolist()) <= {NOBODY} else 1
        passed, stuck = 0, False
        if self._pressed:
            self._steer(self._paths)
        else:
            passed, stuck = self._walk_freely(self._paths, pursuit, periods)
        if passed == 0:
            passed, stuck = 1, self._push_on()
        self._where = None
        if stuck:
            self._free_the_stuck()
        return passed

    def _push_on(self) -> bool:
        """Walks for a period with the engine's help: bodies push each other."""
        ticks = self._ticks
        self.position[:] = self._physics.advance(
            self.position, ticks.duration, ticks.number
        )
        stuck, self._pressed = self._follow_up_push(self._paths)
        return stuck

    def _free_the_stuck(self) -> None:
        """Each walker that is stuck tries another path."""
        stuck = self.walking & (self._walks.stalled >= STUCK)
        for i in stuck.nonzero()[0].tolist():
            self._try_another_path(i)

    def _try_another_path(self, i: int) -> None:
        """Settles for a place near the goal, or makes a detour."""
        walks = self._walks
        walks.stalled[i] = PUSHY  # It goes on to push, until it comes nearer.
        here, goal = self.where[i], end_of(self._paths, i)
        if math.dist(here, goal) <= CROWDED:
            self.halt(i)
            walks.settled[i] = goal
            return
        self._sidesteps += 1
        path = detour(self._routes, here, goal, attempt=self._sidesteps)
        if path:
            self._paths = with_path(self._paths, i, path)
            walks.nearest[i] = math.inf

    def turn_heads(self, look: Indices, focus: Floats, most: Floats) -> None:
        """Turns every head towards where it wants to look; the others look ahead.

        Args:
            look: Whom each of the first bodies looks at, `NOBODY` for none, (m,).
            focus: What each of them looks at then, unless it walks, NaN for nothing,
                shape (m, 2) [m].
            most: How far each head can turn in this time, shape (n,) [rad].
        """
        self._turn_heads(look, focus, most)

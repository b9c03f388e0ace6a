"""Physics: the only file that knows Pymunk.

Walls and furniture are static shapes, people and robots dynamic circles that are
steered by velocities and push each other. (Kinematic bodies would walk through
walls.) There is no gravity and no friction: the floor is seen from above.

Where bodies are and how fast they want to go is all that decides where they come to be.
Chipmunk, inside Pymunk, remembers more, which nobody can read or set: how it was about
to part bodies that overlap (`v_bias`), the impulses of contacts, and in which order it
came upon pairs of bodies. So it is made to forget all that before it is asked.
"""

import numpy as np
import pymunk
from pymunk.batch import BodyFields, Buffer, get_space_bodies, set_space_bodies

from household.compiled.arrays import Floats
from household.compiled.jit import bind
from household.home.floorplan import FloorPlan
from household.motion.collision import keep_out, obstacles_of

SLOP = 0.002
"""How deep touching bodies may overlap [m]; the engine's own 0.1 is made for pixels."""

LEFT_OF_OVERLAP = 0.9**120
"""Share of an overlap that is left after a second of parting bodies. The engine's own
is 0.9 ** 60, but here it parts them in one of the two ticks of a period."""

FAR_AWAY, APART = 1e4, 3.0
"""How far from the home bodies are put to be forgotten, and from each other [m]. They
must be much farther from the home than it is wide: then the engine's search tree for
pairs, into which they come back one by one, grows without regard to what it was."""

MOTION = BodyFields.POSITION | BodyFields.VELOCITY
"""What is handed to the engine and read from it."""


class Physics:
    """Bodies in a home.

    Args:
        plan: The home.
        radius: Of each body, shape (n,) [m].
        mass: Of each body, shape (n,) [kg].

    Attributes:
        velocity: Of each body when it next moves, shape (n, 2) [m/s]; set by others.
        obstacles: The walls and the furniture.
    """

    def __init__(self, plan: FloorPlan, radius: Floats, mass: Floats) -> None:
        self.space = pymunk.Space()
        self.space.collision_slop = SLOP
        self.space.collision_bias = LEFT_OF_OVERLAP
        # A contact is forgotten after a tick without it.
        self.space.collision_persistence = 1
        self._add_home(plan)
        traits = zip(radius.tolist(), mass.tolist(), strict=True)
        self._bodies = [self._add_body(*each) for each in traits]
        self.obstacles = obstacles_of(plan)
        self._keep_out = bind(
            keep_out, np.asarray(radius, dtype=np.float64), self.obstacles
        )
        rows = self._batch_rows()
        self._buffer, batch = self._batch()
        self._place, self.velocity = batch[rows, :2], batch[rows, 2:]
        self._far_away, batch = self._batch()
        batch[rows, 0] = plan.upper[0] + FAR_AWAY + APART * np.arange(len(radius))

    def _batch(self) -> tuple[Buffer, Floats]:
        """Memory for where all bodies are and how fast, as Pymunk and as NumPy see it.

        The last row is spare: Pymunk would move an array that becomes full elsewhere.
        """
        batch, buffer = np.zeros((len(self._bodies) + 2, 4)), Buffer()
        buffer.set_float_buf(batch)
        return buffer, batch

    def _add_home(self, plan: FloorPlan) -> None:
        ground = self.space.static_body
        for x1, y1, x2, y2 in plan.wall_segments:
            half = plan.wall_thickness / 2
            self.space.add(pymunk.Segment(ground, (x1, y1), (x2, y2), half))
        for box in plan.furniture:
            self.space.add(pymunk.Poly(ground, list(box.corners)))

    def _add_body(self, radius: float, mass: float) -> pymunk.Body:
        # An infinite moment: bodies do not spin, headings are the owners' own.
        body = pymunk.Body(mass, float("inf"))
        self.space.add(body, pymunk.Circle(body, radius))
        return body

    def _batch_rows(self) -> slice:
        """The rows of the bodies in Pymunk's batches, which hold the ground too."""
        buffer = Buffer()
        get_space_bodies(self.space, BodyFields.BODY_ID, buffer)
        ids = list(memoryview(buffer.int_buf()).cast("P"))
        first = ids.index(self._bodies[0].id)
        rows = slice(first, first + len(self._bodies))
        if ids[rows] != [body.id for body in self._bodies]:
            raise RuntimeError("Pymunk's batches hold bodies in an order of their own")
        return rows

    def advance(self, position: Floats, tick: float, ticks: int) -> Floats:
        """Moves every body for some ticks.

        Args:
            position: Where each sets out from, clear of all obstacles, (n, 2) [m].
            tick: Length of a tick [s].
            ticks: How many.

        Returns:
            Where every body is then, a new array of shape (n, 2) [m].
        """
        self._forget(tick)
        self._place[:] = position
        set_space_bodies(self.space, MOTION, self._buffer)
        for _ in range(ticks):
            self.space.step(tick)
        self._buffer.clear()
        get_space_bodies(self.space, MOTION, self._buffer)
        after = self._place.copy()
        self._keep_out(position, after)
        return after

    def _forget(self, tick: float) -> None:
        """Lets the engine forget all that it remembers, in a tick without contacts."""
        set_space_bodies(self.space, MOTION, self._far_away)
        self.space.step(tick)

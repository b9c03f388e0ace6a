"""Bodies and their walks, as records of arrays.

In every array people come first and robots after them.
"""

from typing import Annotated, NamedTuple

import numpy as np

from household.compiled.arrays import Floats, Indices, Mask, Zeros


class BodyParams(NamedTuple):
    """What bodies are like.

    Attributes:
        radius: Of each body, shape (n,) [m].
        mass: Of each body, shape (n,) [kg].
        speed: Of each body when it walks, shape (n,) [m/s].
    """

    radius: Annotated[Floats, "n"]
    mass: Annotated[Floats, "n"]
    speed: Annotated[Floats, "n"]


class Bodies(NamedTuple):
    """Where all bodies are and how they move.

    Attributes:
        radius: Of each body, shape (n,) [m].
        speed: Of each body when it walks, shape (n,) [m/s].
        position: Shape (n, 2) [m].
        velocity: Of the present steering period, shape (n, 2) [m/s].
        heading: Where each body faces, shape (n,) [rad].
        gaze: Where each head points, shape (n,) [rad].
    """

    radius: Annotated[Floats, "n"]
    speed: Annotated[Floats, "n"]
    position: Annotated[Floats, "n", 2]
    velocity: Annotated[Floats, "n", 2]
    heading: Annotated[Floats, "n"]
    gaze: Annotated[Floats, "n"]


class Walks(NamedTuple):
    """Who walks, and how it goes.

    Attributes:
        walking: Whether each body is on a walk, shape (n,).
        nearest: The least distance from its next waypoint that each has had, infinite
            before the first look, shape (n,) [m].
        stalled: For how long each has come no nearer to it, shape (n,) [s].
        settled: The goal that each stopped near because others stand on it, NaN for
            none, shape (n, 2) [m].
    """

    walking: Annotated[Mask, "n"]
    nearest: Annotated[Floats, "n"]
    stalled: Annotated[Floats, "n"]
    settled: Annotated[Floats, "n", 2]


class Goals(NamedTuple):
    """Where the first m bodies want to be.

    Attributes:
        point: Shape (m, 2) [m].
        target: Index of the body that each follows instead, `NOBODY` for none, (m,).
    """

    point: Annotated[Floats, "m", 2]
    target: Annotated[Indices, "m"]


class Pursuit(NamedTuple):
    """Whom the first m bodies follow.

    Attributes:
        target: Index of the body that each follows, `NOBODY` for none, shape (m,).
        reach: How near to it each wants to come [m].
    """

    target: Annotated[Indices, "m"]
    reach: float


NO_PURSUIT = Pursuit(np.zeros(0, np.intp), 0.0)
"""Nobody follows anybody."""


def bodies_at_rest(params: BodyParams, velocity: Floats, zeros: Zeros) -> Bodies:
    """Bodies that stand at the origin.

    Args:
        params: What they are like.
        velocity: The physics engine's own array, shape (n, 2) [m/s].
        zeros: Makes the arrays that are recorded: positions, headings and gazes.
    """
    n = len(params.radius)
    return Bodies(
        radius=params.radius,
        speed=params.speed,
        position=zeros("position", (n, 2)),
        velocity=velocity,
        heading=zeros("heading", (n,)),
        gaze=zeros("gaze", (n,)),
    )


def no_walks(n: int) -> Walks:
    """The walks of so many bodies before their first one."""
    return Walks(
        walking=np.zeros(n, np.bool_),
        nearest=np.full(n, np.inf),
        stalled=np.zeros(n),
        settled=np.full((n, 2), np.nan),
    )

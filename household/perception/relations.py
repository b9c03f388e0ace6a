"""What perception reads and what it finds out: entities, and relations between them.

Entities are people and robots, in arrays with people first and robots after them.
"""

from typing import Annotated, NamedTuple

from household.compiled.arrays import Floats, Mask


class Entities(NamedTuple):
    """How everybody appears to others, and how they look around themselves.

    Attributes:
        position: Shape (n, 2) [m].
        gaze: Where each head points, shape (n,) [rad].
        half_view: Half the field of view, (n,) [rad]; negative: eyes closed.
        salience: How strongly each draws the eye, shape (n,).
        absorption: How much attention each one's own activity holds back, shape (n,),
            above 0.
        source: Sound level of each at 1 m, shape (n,) [dB].
    """

    position: Annotated[Floats, "n", 2]
    gaze: Annotated[Floats, "n"]
    half_view: Annotated[Floats, "n"]
    salience: Annotated[Floats, "n"]
    absorption: Annotated[Floats, "n"]
    source: Annotated[Floats, "n"]


class Relations(NamedTuple):
    """How each perceives each; in all arrays, of shape (n, n), rows are observers.

    Attributes:
        sees: Whether i sees j.
        facing: Cosine of the angle between the gaze of i and the direction to j.
        attention: The attention matrix: which share of its attention i gives to j;
            rows sum to less than 1.
        attends: Whether i attends to j, with hysteresis.
        attention_began: Since when i attends to j [s], NaN if it does not.
        loss: What a sound loses on its way from j to i [dB]; infinite between those
            who never make one, and on the diagonal.
        level: How loud i hears j [dB], at least 0.
    """

    sees: Annotated[Mask, "n", "n"]
    facing: Annotated[Floats, "n", "n"]
    attention: Annotated[Floats, "n", "n"]
    attends: Annotated[Mask, "n", "n"]
    attention_began: Annotated[Floats, "n", "n"]
    loss: Annotated[Floats, "n", "n"]
    level: Annotated[Floats, "n", "n"]

"""No sharing: each person's opinion is learned from that person alone.

No pooling, in the terms of Gelman & Hill (2007), chapter 12.
"""

from dataclasses import dataclass, field

from learners.expectation import ExpectedTouch
from learners.representation.parts import Representation
from learners.representation.situations import MarkedSituations
from learners.saving import saved


@saved
@dataclass(eq=False)
class NoSharing(ExpectedTouch):
    """A person's expected touch is the mean of its own.

    Attributes:
        representation: the whole situation with the person marked.
    """

    representation: Representation = field(
        default_factory=MarkedSituations, kw_only=True
    )

"""Full sharing: one opinion for all, learned from everybody.

Complete pooling, in the terms of Gelman & Hill (2007), chapter 12.
"""

from dataclasses import dataclass, field

from learners.expectation import ExpectedTouch
from learners.pooling.rules import FullPooling, Pooling
from learners.representation.parts import Representation
from learners.representation.situations import MarkedSituations
from learners.saving import saved


@saved
@dataclass(eq=False)
class FullSharing(ExpectedTouch):
    """A person's expected touch is the mean of everybody's in the same place.

    Attributes:
        representation: the whole situation with the person marked.
        pooling: full.
    """

    representation: Representation = field(
        default_factory=MarkedSituations, kw_only=True
    )
    pooling: Pooling = field(default_factory=FullPooling, kw_only=True)

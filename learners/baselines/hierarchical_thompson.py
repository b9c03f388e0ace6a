"""Hierarchical Thompson sampling over actors.

Hong, Kveton, Zaheer & Ghavamzadeh (2022), "Hierarchical Bayesian bandits", AISTATS:
each person is a bandit whose means are drawn around those of the population, and one
draw from the posterior of both decides.
"""

from dataclasses import dataclass, field

from learners.expectation import ExpectedTouch
from learners.exploration import Exploration, Thompson
from learners.pooling.rules import HierarchicalPooling, Pooling
from learners.representation.parts import Representation
from learners.representation.situations import MarkedSituations
from learners.saving import saved


@saved
@dataclass(eq=False)
class HierarchicalThompson(ExpectedTouch):
    """Normal touches around a person's taste, normal tastes around the population's.

    Attributes:
        exploration: Thompson sampling.
        representation: the whole situation with the person marked.
        pooling: hierarchical.
    """

    exploration: Exploration = field(default_factory=Thompson, kw_only=True)
    representation: Representation = field(
        default_factory=MarkedSituations, kw_only=True
    )
    pooling: Pooling = field(default_factory=HierarchicalPooling, kw_only=True)

"""Analogy: operators along which experience is carried over (paper, section 3.2)."""

from learners.analogy.adaptive import AdaptiveAnalogy
from learners.analogy.carrying import Analogy, Propagation
from learners.analogy.operators import RemoveEntity, SwapRoles

__all__ = [
    "AdaptiveAnalogy",
    "Analogy",
    "Propagation",
    "RemoveEntity",
    "SwapRoles",
]

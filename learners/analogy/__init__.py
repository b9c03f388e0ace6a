"""Analogy: operators along which experience is carried over (paper, section 3.2)."""

from learners.analogy.adaptive import AdaptiveAnalogy
from learners.analogy.operators import (
    Analogy,
    Canonical,
    Propagation,
    RemoveEntity,
    SwapRoles,
)

__all__ = [
    "AdaptiveAnalogy",
    "Analogy",
    "Canonical",
    "Propagation",
    "RemoveEntity",
    "SwapRoles",
]

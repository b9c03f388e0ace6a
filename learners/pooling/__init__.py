"""Pooling: how far one person is read off all others."""

from learners.pooling.adaptive import AdaptivePooling
from learners.pooling.rules import (
    FullPooling,
    HierarchicalPooling,
    NoPooling,
    Pooling,
)

__all__ = [
    "AdaptivePooling",
    "FullPooling",
    "HierarchicalPooling",
    "NoPooling",
    "Pooling",
]

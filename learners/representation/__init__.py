"""Representation: which rows of a table a situation is kept in."""

from learners.representation.parts import Part, Representation
from learners.representation.situations import (
    Canonical,
    MarkedSituations,
    Named,
    Nameless,
)
from learners.representation.views import (
    AudibleViews,
    NestedViews,
    PersonViews,
    Views,
    ViewSet,
)

__all__ = [
    "AudibleViews",
    "Canonical",
    "MarkedSituations",
    "Named",
    "Nameless",
    "NestedViews",
    "Part",
    "PersonViews",
    "Representation",
    "ViewSet",
    "Views",
]

"""The catalog: learners by name."""

from learners.catalog.making import CATALOG, make_learner
from learners.catalog.recipe import Recipe

__all__ = ["CATALOG", "Recipe", "make_learner"]

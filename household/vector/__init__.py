"""Many homes at once: a Gymnasium vector environment whose slots are their robots."""

from household.vector.environment import VectorHousehold, make

__all__ = ["VectorHousehold", "make"]

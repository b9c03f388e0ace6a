"""Simulated people: what they do, where they look and when they touch a robot."""

from policies.people.minds import EverydayMinds, make_minds

__all__ = ["EverydayMinds", "make_minds"]

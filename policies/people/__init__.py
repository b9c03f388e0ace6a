"""Simulated people: what they do, where they look and when they touch a robot."""

from policies.people.minds import EverydayMind, make_minds

__all__ = ["EverydayMind", "make_minds"]

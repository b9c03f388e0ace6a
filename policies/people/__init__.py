"""Simulated people: what they do, where they look and when they touch a robot."""

from policies.people.minds import ScriptedMind, make_minds

__all__ = ["ScriptedMind", "make_minds"]

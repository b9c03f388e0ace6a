"""Norms that make a household worth learning in: every role wants something else."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

BEHAVIORS = ("sleep", "play", "say_hello", "follow", "ask", "retreat")

WANTED: Mapping[str, str] = {
    "working": "ask",
    "reading": "retreat",
    "sleeping": "sleep",
    "playing": "play",
    "entering": "say_hello",
    "calling": "sleep",
    "unknown": "follow",
}
"""Role -> the behavior that people want in it."""

LIKED, DISLIKED = 0.8, -0.6
"""What a norm gives to the behavior that is wanted, and to all others."""

HEARD = 75.0
"""Loudness of the sounds that situations say somebody would hear [dB at 1 m]: play."""


def own_norms(turned: int = 0) -> dict[str, Any]:
    """Every role wants a behavior of its own, whether people attend or not.

    Args:
        turned: By how many places in `BEHAVIORS` what is wanted is moved on: somebody
            with these norms agrees with nobody who has others.
    """
    norms = {}
    for role, wanted in WANTED.items():
        place = (BEHAVIORS.index(wanted) + turned) % len(BEHAVIORS)
        values = {
            each: LIKED if index == place else DISLIKED
            for index, each in enumerate(BEHAVIORS)
        }
        norms[role] = {"attending": values, "absorbed": values}
    return norms

"""What the paper says, word for word, where a claim restates it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple


class Quote(NamedTuple):
    """A passage of the paper.

    Attributes:
        words: Its own.
        section: Where they stand.
    """

    words: str
    section: str


QUOTES: Mapping[str, Quote] = {
    "1a": Quote(
        "the system did not learn the appropriate actions for the given situation",
        "5.1",
    ),
    "1b": Quote("continued to alternate between the two actions", "5.1"),
    "1c": Quote(
        "Without additional positive feedback, the value for play decreased, and the "
        "system forgot the lesson.",
        "5.1",
    ),
    "2a": Quote(
        "the system correctly learned which actions to perform in each situation", "5.2"
    ),
    "2b": Quote("the system learned faster in the second experiment", "5.2"),
    "2c": Quote("The cumulative reward did not become negative", "5.2"),
    "2d": Quote(
        "the system still forgets when no rewards are given, but does so less rapidly "
        "than in the first experiment",
        "5.2",
    ),
    "2e": Quote(
        "the influence of the reward (both negative and positive) grows weaker with "
        "time",
        "5.2",
    ),
    "3a": Quote("The system did not learn in either situation", "5.3"),
    "3b": Quote(
        "the delay in receiving feedback caused the reward to be improperly assigned",
        "5.3",
    ),
    "4a": Quote("Q-Values converge for both situations", "5.4"),
    "4b": Quote(
        "the learning algorithm was able to correctly find the situation to which the "
        "feedback should be assigned",
        "5.4",
    ),
    "5a": Quote("a slight majority of these rewards were negative", "Fifth Experiment"),
    "5b": Quote(
        "in the second phase, the system received many more positive rewards than "
        "negatives ones",
        "Fifth Experiment",
    ),
    "5c": Quote(
        "by using analogy in the second phase, the system has used its past experience",
        "Fifth Experiment",
    ),
    "5d": Quote("This corresponds to 28 situations.", "Fifth Experiment"),
}
"""By the id of the claim."""

"""Exploration: how a behavior is chosen from what is known of each."""

from learners.exploration.chances import chances
from learners.exploration.company import SeekCompany
from learners.exploration.rules import (
    EpsilonGreedy,
    Estimates,
    Exploration,
    Greedy,
    Softmax,
    Thompson,
    UpperConfidence,
    best,
    draw,
    softmax,
)

__all__ = [
    "EpsilonGreedy",
    "Estimates",
    "Exploration",
    "Greedy",
    "SeekCompany",
    "Softmax",
    "Thompson",
    "UpperConfidence",
    "best",
    "chances",
    "draw",
    "softmax",
]

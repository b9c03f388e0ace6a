"""Figures: the paper's, drawn anew from stored results, for print and for screens."""

from experiments.figures.canvas import Cell, Column, inline, save
from experiments.figures.rows import (
    BehaviorSequence,
    CumulativeReward,
    QValues,
    Row,
    TouchFrequency,
)
from experiments.figures.sequences import SituationSequence, TouchesByPhase

__all__ = [
    "BehaviorSequence",
    "Cell",
    "Column",
    "CumulativeReward",
    "QValues",
    "Row",
    "SituationSequence",
    "TouchFrequency",
    "TouchesByPhase",
    "inline",
    "save",
]

"""Figures: the paper's, drawn anew from stored results, for print and for screens."""

from experiments.figures.canvas import Column, Panel, inline, save
from experiments.figures.plots import (
    BehaviorSequence,
    CumulativeReward,
    Plot,
    QValues,
    TouchFrequency,
    legend_above,
)
from experiments.figures.sequences import SituationSequence, TouchesByPhase

__all__ = [
    "BehaviorSequence",
    "Column",
    "CumulativeReward",
    "Panel",
    "Plot",
    "QValues",
    "SituationSequence",
    "TouchFrequency",
    "TouchesByPhase",
    "inline",
    "legend_above",
    "save",
]

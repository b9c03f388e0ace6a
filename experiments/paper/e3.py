"""Experiment 3: delayed touches, credited without regard to the delay (5.3, figure 5).

The situations, figures and measures that experiment 4 shares are here.
"""

from __future__ import annotations

import polars as pl

from experiments.analysis import measures, social
from experiments.analysis.claims import Claim
from experiments.analysis.evaluation import BEYOND, Method
from experiments.analysis.statistics import mean
from experiments.analysis.target_situations import TargetSituation
from experiments.figures import (
    BehaviorSequence,
    CumulativeReward,
    QValues,
    SituationSequence,
)
from experiments.paper.experiment import Experiment, PaperFigure
from experiments.running.study import Condition

S11 = TargetSituation(name="S11", role="playing", attended=True)
S52 = TargetSituation(name="S52", role="calling", attended=False)
TARGET_SITUATIONS = (S11, S52)

IMMEDIATE, TRACE, SKIP = "immediate", "trace", "skip_silence"


def converged_in_both(trial: pl.DataFrame) -> float:
    """Returns 1 if S11 and S52 were both learned, else 0."""
    return all(measures.converged(trial, one.find(trial)) for one in TARGET_SITUATIONS)


def masters_both(trial: pl.DataFrame) -> float:
    """Returns 1 if the choices in S11 and in S52 became right, else 0."""
    return all(measures.masters(trial, one.find(trial)) for one in TARGET_SITUATIONS)


def astray(trial: pl.DataFrame) -> float:
    """Returns the share of the touches meant for S52 that another pair got."""
    return 1.0 - social.credit_accuracy(trial, S52.find(trial))


CREDIT = (
    Method(
        name=BEYOND,
        text="touches credited to the pair that they are about",
        measure=social.credit_accuracy,
        is_share=True,
    ),
    Method(
        name=BEYOND,
        text="touches meant for S52 that another pair got",
        measure=astray,
        is_share=True,
    ),
)
"""Whether touches were understood."""


def figure(name: str, condition: str, credit: str) -> PaperFigure:
    """Returns the counterpart of figure 5 or 6."""
    return PaperFigure(
        name=name,
        caption=(
            f"{credit}. The situation, which behavior the robot does, the Q-values of "
            "both behaviors in S11 (the actor plays and attends to the robot) and in "
            "S52 (on the phone, not attending), and the sum of all touches."
        ),
        condition=condition,
        plots=(
            SituationSequence(),
            BehaviorSequence(),
            QValues(situation=S11),
            QValues(situation=S52),
            CumulativeReward(),
        ),
    )


def silence_controls(scenario: str, **settings: str) -> tuple[Condition, ...]:
    """Returns the paper's learner with each other way to learn from silence.

    Args:
        scenario: Where they are run.
        **settings: Of the learner, beside that.
    """
    return tuple(
        Condition(
            name=f"silence_{how}",
            scenario=scenario,
            learner="q_social",
            learner_overrides={**settings, "silent_steps": how},
        )
        for how in ("apart", "held", "apart_held")
    )


SILENCE = ("silence_apart", "silence_held", "silence_apart_held")


def _claims(condition: str, compared: tuple[str, ...]) -> tuple[Claim, ...]:
    return (
        Claim(
            id="3a",
            text="Without regard to the delay, it does not learn both situations.",
            reading=(
                "Share of the seeds that converge both in S11 and in S52: at least "
                "90 % of the last quarter of the choices are right, and the right "
                "behavior's Q-value ends on top. Holds at 20 % or less."
            ),
            measure=measures.of(condition, converged_in_both),
            rule="at most",
            threshold=0.2,
            compared=measures.of_each(compared, converged_in_both),
            reference=measures.on_references(masters_both),
        ),
        Claim(
            id="3b",
            text="Feedback meant for the phone call lands elsewhere.",
            reading=(
                "Of the touches whose true cause is a behavior begun in S52, the share "
                "that the learner credits to another pair of situation and behavior; "
                "seeds without such touches are left out. Holds at 50 % or more."
            ),
            measure=measures.of(condition, astray),
            rule="at least",
            threshold=0.5,
            estimate=mean,
            unit="share of touches",
            compared=measures.of_each(compared, astray),
        ),
    )


EXPERIMENT = Experiment(
    number=3,
    title="Delayed touches",
    question=(
        "What becomes of learning if a person on the phone must walk over before it "
        "can tap the robot?"
    ),
    setup=(
        "One person plays on the rug beside the robot, then makes a call at the other "
        "end of the room, and so on.",
        "At play (S11) the person attends to the robot, caresses it for playing and "
        "taps it for sleeping. On the phone (S52) the person does not look, is "
        "bothered by playing, leaves the phone and walks over to tap. Sleep is not "
        "rewarded there.",
        "Q-learning with the social rate. A touch is credited to the pair of situation "
        "and behavior in which it is felt (immediate), or along a classic eligibility "
        "trace. Control: skip_silence, which does not learn from steps without "
        "feedback (immediate credit).",
    ),
    conditions=(
        Condition(name=IMMEDIATE, scenario="experiment_3", learner="q_social"),
        Condition(name=TRACE, scenario="experiment_3", learner="q_trace"),
        Condition(name=SKIP, scenario="experiment_3", learner="skip_silence"),
    ),
    claims=_claims(IMMEDIATE, (SKIP,)) + _claims(TRACE, ()),
    figures=(
        figure("figure_5", IMMEDIATE, "Immediate credit"),
        figure("figure_5_trace", TRACE, "Classic eligibility trace"),
    ),
    target_situations=TARGET_SITUATIONS,
    further=CREDIT,
)

"""Social reinforcement learning on any hashable state; knows nothing of a household."""

from learners.catalog import CATALOG, make_learner
from learners.errors import LearnerError
from learners.experience import Experience, Feedback
from learners.learner import Credit, Learner, Share
from learners.qlearner import QLearner
from learners.saving import load, saved
from learners.team import Team, make_team

__all__ = [
    "CATALOG",
    "Credit",
    "Experience",
    "Feedback",
    "Learner",
    "LearnerError",
    "QLearner",
    "Share",
    "Team",
    "load",
    "make_learner",
    "make_team",
    "saved",
]

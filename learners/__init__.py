"""Social reinforcement learning on any hashable state; knows nothing of a household."""

from learners.catalog import CATALOG, make_learner
from learners.errors import LearnerError
from learners.experience import Experience, Reward
from learners.learner import Credit, Learner
from learners.qlearner import QLearner
from learners.saving import load, saved
from learners.tabular.base import CreditedLearner
from learners.team import Team, make_team

__all__ = [
    "CATALOG",
    "Credit",
    "CreditedLearner",
    "Experience",
    "Learner",
    "LearnerError",
    "QLearner",
    "Reward",
    "Team",
    "load",
    "make_learner",
    "make_team",
    "saved",
]

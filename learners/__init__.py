"""Social reinforcement learning on any hashable state; knows nothing of a household."""

from learners.experience import Experience, Feedback
from learners.learner import Credit, Learner, Share

__all__ = ["Credit", "Experience", "Feedback", "Learner", "Share"]

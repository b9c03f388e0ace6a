"""A simulated household with people, homes and robots, as a PettingZoo environment."""

__version__ = "0.1.0"

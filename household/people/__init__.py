"""The people of a home: who they are, how they feel, what they think and intend.

What is needed to write a person's mind can be imported from here.
"""

from household.people.individuals import (
    Appraisal,
    Individuals,
    Intention,
    Mind,
    Percept,
)
from household.people.mind import Wish

__all__ = ["Appraisal", "Individuals", "Intention", "Mind", "Percept", "Wish"]

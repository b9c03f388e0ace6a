"""The parts that a representation takes a situation apart into."""

from abc import ABC, abstractmethod
from collections.abc import Hashable
from typing import ClassVar, NamedTuple


class Part(NamedTuple):
    """What is learned together; the value of a situation is the sum over its parts.

    Where there are several levels of detail, it is the mean of those sums.

    Attributes:
        key: what is to be told from other parts.
        person: whose part it is, by name; None for a part of no single person. What is
            learned of two people is kept apart, and a pooling brings it together.
        perceives: whether the person could have perceived the robot, so that its
            silence says something.
    """

    key: Hashable
    person: Hashable | None = None
    perceives: bool = True


class Representation(ABC):
    """Takes situations apart; users add their own by implementing `parts`."""

    by_person: ClassVar[bool] = False
    """Whether parts belong to people; then a touch teaches its giver's parts alone."""

    @property
    def n_levels(self) -> int:
        """How many parts a person has, each for another level of detail."""
        return 1

    @abstractmethod
    def parts(self, state: Hashable) -> tuple[Part, ...]:
        """The parts of a state, in a fixed order; none if there is nobody in it.

        Raises:
            StateError: if the state lacks what the representation asks of it.
        """

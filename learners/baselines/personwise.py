"""What three baselines share: a home's opinion is the sum of its people's opinions.

Each person judges a behavior from its own place in the situation. How much one person's
opinion says about another's is where they differ: nothing (`no_sharing`),
everything (`full_sharing`), or as much as they agree (`hierarchical_thompson`); Gelman
& Hill (2007), "Data analysis using regression and multilevel/hierarchical models",
chapter 12, call it no, complete and partial pooling.
"""

from abc import abstractmethod
from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field

from learners.analogy.operators import MEMO_SIZE, State, as_state, remember
from learners.experience import Reward
from learners.exploration import Estimates
from learners.learner import Credit
from learners.saving import DERIVED, saved
from learners.tabular.base import CreditedLearner

Touches = tuple[float, float]
"""How many touches (by eligibility), and their mean value."""


@saved
@dataclass(eq=False)
class Personwise(CreditedLearner):
    """Mean touch per place in a situation, behavior and person.

    A person's *place* is what the situation is without names but with this person
    marked: its class under swaps, with and without the person. People who are not in
    the situation have no place, and their touches are left out of account. Silence is
    no opinion.

    Attributes:
        opinions: per place, behavior and person, the touches.
    """

    opinions: dict[tuple[Hashable, int], dict[Hashable, Touches]] = field(
        default_factory=dict, init=False, repr=False
    )
    _places: dict[Hashable, dict[Hashable, Hashable]] = field(
        default_factory=dict, init=False, repr=False, metadata=DERIVED
    )

    @abstractmethod
    def opinion(
        self, person: Hashable, place: Hashable, behavior: int
    ) -> tuple[float, float]:
        """Expected touch of a person for a behavior, and its variance."""

    def place(self, state: Hashable, person: Hashable) -> Hashable:
        """A person's place in a state; None if it is not in it.

        Raises:
            StateError: if the state does not follow `learners.analogy.operators.State`.
        """
        places = self._places.get(state)
        if places is None:
            places = _places(as_state(state))
            remember(self._places, state, places, MEMO_SIZE)
        return places.get(person)

    def estimates(self, state: Hashable) -> Estimates:
        """Sum of the opinions of all in the situation, with its deviation."""
        people = [(p, self.place(state, p)) for p in as_state(state).entities]
        behaviors = range(self.n_behaviors)
        opinions = [[self.opinion(*each, b) for each in people] for b in behaviors]
        return Estimates(
            [sum(mean for mean, _ in each) for each in opinions],
            [sum(self._touches(at, b) for _, at in people) for b in behaviors],
            [sum(variance for _, variance in each) ** 0.5 for each in opinions],
        )

    def _touches(self, place: Hashable, behavior: int) -> float:
        told = self.opinions.get((place, behavior), {})
        return sum(touches for touches, _ in told.values())

    def _absorb(self, credits: Sequence[Credit]) -> None:
        touches = [
            (self.place(entry.state, reward.giver), entry.action, reward, weight)
            for credit in credits
            if (reward := credit.reward) is not None
            for entry, weight in credit.shares
        ]
        for place, behavior, reward, weight in touches:
            if place is not None:
                self._note(place, behavior, reward, weight)

    def _note(
        self, place: Hashable, behavior: int, reward: Reward, weight: float
    ) -> None:
        by_person = self.opinions.setdefault((place, behavior), {})
        n, mean = by_person.get(reward.giver, (0.0, 0.0))
        n += weight
        by_person[reward.giver] = (n, mean + weight / n * (reward.value - mean))


def _places(state: State) -> dict[Hashable, Hashable]:
    whole, people = state.canonical(), state.entities
    # Each person takes the last one's name before leaving, so that what remains is told
    # in the same names whoever left.
    return {
        e: (whole, state.swapped(e, people[-1]).without(people[-1]).canonical())
        for e in people
    }

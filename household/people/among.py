"""People with minds of their own, among others who have the usual ones."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from household.arguments import check_name
from household.people.individuals import Individuals, Mind
from household.people.mind import Intentions, Minds, Percepts
from household.scenario.scenario import Scenario
from household.state import Stateful

MakeMind = Callable[[], Mind]
"""Makes a mind: its class, or a `functools.partial` of it. Not a mind itself, since
every home needs one of its own."""


class Among(Minds, Stateful):
    """Some people have minds of their own, the others the usual ones.

    Args:
        others: Decides for everybody; where somebody has a mind of its own, what it
            decides is not done.
        own: The minds of the people who have one.
    """

    STATE = ("_others", "_own")

    def __init__(self, others: Minds, own: Individuals) -> None:
        self._others, self._own = others, own
        self._who = list(own.who)

    def reset(self, rngs: Sequence[np.random.Generator]) -> Intentions:
        """Begins a new episode; the others draw as they would if they were alone."""
        usual = self._others.reset(rngs)
        return self._joined(usual, self._own.reset([_own(rngs[i]) for i in self._who]))

    def decide(self, percepts: Percepts) -> Intentions:
        """Asks the others, then each who has a mind of its own."""
        return self._joined(self._others.decide(percepts), self._own.decide(percepts))

    def _joined(self, usual: Intentions, own: Intentions) -> Intentions:
        """Intentions of everybody; those of the usual minds are theirs to keep."""
        who, wishes = self._who, list(usual.wishes)
        for person, wish in zip(who, own.wishes, strict=True):
            wishes[person] = wish
        arrays = {
            name: getattr(usual, name).copy()
            for name in ("place", "look", "eyes_open", "changed")
        }
        for name, array in arrays.items():
            array[who] = getattr(own, name)
        return Intentions(wishes=wishes, **arrays)


def _own(rng: np.random.Generator) -> np.random.Generator:
    """A stream beside that of the usual mind."""
    return rng.spawn(1)[0]


def with_own_minds(
    scenario: Scenario,
    *,
    usual: Callable[[Scenario], Minds],
    own: Mapping[str, MakeMind],
) -> Among:
    """The minds of a scenario's people, some of whom have one of their own.

    Args:
        scenario: Whose people.
        usual: Gives everybody the usual minds.
        own: Makes the minds of some, by the person's name.

    Raises:
        HouseholdError: If nobody has one of these names.
    """
    names = scenario.person_names
    for name in own:
        check_name(name, names, "person")
    minds = {names.index(name): make() for name, make in own.items()}
    return Among(usual(scenario), Individuals(minds, scenario))

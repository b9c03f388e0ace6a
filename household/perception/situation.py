"""Situations: conjunctions of relations, seen from one robot (paper, section 2.2).

A situation says which role each actor plays and who attends to whom. It is hashable
and free of order, so that it can be a key, and it offers what analogy asks of a state:
its entities, itself with two of them exchanged, without one of them, and in a canonical
form.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from household.perception.canonical import Relation, canonical_order


@dataclass(frozen=True, slots=True)
class Situation:
    """Who plays what and who attends to whom.

    Attributes:
        plays: Pairs (actor, role), sorted by actor; one for each actor.
        attends: Pairs (observer, target); either may be an actor or a robot.
    """

    plays: tuple[Relation, ...]
    attends: frozenset[Relation] = frozenset()

    @classmethod
    def of(
        cls, roles: Mapping[str, str], attends: Iterable[Relation] = ()
    ) -> "Situation":
        """The situation in which actors play these roles."""
        return cls(tuple(sorted(roles.items())), frozenset(attends))

    @property
    def entities(self) -> tuple[str, ...]:
        """The actors, sorted by name."""
        return tuple(actor for actor, _ in self.plays)

    def swapped(self, one: str, other: str) -> "Situation":
        """SwapRoles: two actors take each other's place in every relation."""
        return self._renamed({one: other, other: one})

    def without(self, entity: str) -> "Situation":
        """RemoveEntity: the same situation with no relation to one entity."""
        return Situation(
            tuple(relation for relation in self.plays if relation[0] != entity),
            frozenset(pair for pair in self.attends if entity not in pair),
        )

    def canonical(self) -> "Situation":
        """The one situation that stands for all that swaps lead to from here."""
        names = self.entities
        features = {actor: self._alone(actor, role) for actor, role in self.plays}
        among = [(a, b) for a, b in self.attends if a in features and b in features]
        order = canonical_order(features, among)
        return self._renamed(dict(zip(order, names, strict=True)))

    def _alone(self, actor: str, role: str) -> tuple[str, list[str], list[str]]:
        """What is true of an actor without looking at other actors."""
        actors = self.entities
        return (
            role,
            sorted(b for a, b in self.attends if a == actor and b not in actors),
            sorted(a for a, b in self.attends if b == actor and a not in actors),
        )

    def _renamed(self, names: Mapping[str, str]) -> "Situation":
        return Situation.of(
            {names.get(actor, actor): role for actor, role in self.plays},
            ((names.get(a, a), names.get(b, b)) for a, b in self.attends),
        )

    def __str__(self) -> str:
        roles = [f"{actor} {role}" for actor, role in self.plays]
        looks = [f"{observer} > {target}" for observer, target in sorted(self.attends)]
        return ", ".join(roles + looks)

"""Situations: conjunctions of relations, seen from one robot (paper, section 2.2).

A situation says which role each actor plays and who attends to whom; where the scenario
wants it, also who is near the robot and who would hear it. It is hashable and free of
order, so that it can be a key, and it offers what analogy asks of a state: its
entities, itself with two of them exchanged, without one of them, and in a canonical
form.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from household.perception.canonical import Relation, canonical_order

PAIRS = {"attends": ">", "near": "near", "hears": "hears"}
"""The relations between two entities, and how they are written."""

View = tuple[Relation, ...]
"""Pairs (relation, in which to what): what is true of one actor by itself."""


@dataclass(frozen=True, slots=True, repr=False)
class Situation:
    """Who plays what, who attends to whom, who is near or hears whom.

    Attributes:
        plays: Pairs (actor, role), sorted by actor; one for each actor.
        attends: Pairs (observer, target); either may be an actor or a robot.
        near: Pairs (actor, robot) that are near each other.
        hears: Pairs (actor, robot): the actor would hear that robot.
    """

    plays: tuple[Relation, ...]
    attends: frozenset[Relation] = frozenset()
    near: frozenset[Relation] = frozenset()
    hears: frozenset[Relation] = frozenset()

    @classmethod
    def of(
        cls,
        roles: Mapping[str, str],
        attends: Iterable[Relation] = (),
        near: Iterable[Relation] = (),
        hears: Iterable[Relation] = (),
    ) -> "Situation":
        """The situation in which actors play these roles."""
        plays = tuple(sorted(roles.items()))
        return cls(plays, frozenset(attends), frozenset(near), frozenset(hears))

    @property
    def entities(self) -> tuple[str, ...]:
        """The actors, sorted by name."""
        return tuple(actor for actor, _ in self.plays)

    def swapped(self, one: str, other: str) -> "Situation":
        """SwapRoles: two actors take each other's place in every relation."""
        return self._renamed({one: other, other: one})

    def views(self) -> tuple[tuple[str, View], ...]:
        """Every actor with what is true of it when no other actor is looked at.

        Its role, ("plays", role), then its relations to robots, such as ("attends",
        robot), in order; its own name is left out.
        """
        views = {actor: [("plays", role)] for actor, role in self.plays}
        for one, other in sorted(self.attends):
            if one in views and other not in views:
                views[one].append(("attends", other))
            elif other in views and one not in views:
                views[other].append(("attended by", one))
        for relation, pairs in (("near", self.near), ("hears", self.hears)):
            for actor, robot in sorted(pairs):
                views[actor].append((relation, robot))
        return tuple((actor, tuple(view)) for actor, view in views.items())

    def without_names(self) -> "Situation":
        """The one situation that stands for all that differ from it in names alone."""
        form = self.canonical()
        slots = {actor: f"p{i}" for i, actor in enumerate(form.entities)}
        return form._renamed(slots)

    def without(self, entity: str) -> "Situation":
        """RemoveEntity: the same situation with no relation to one entity."""
        kept = (
            frozenset(pair for pair in pairs if entity not in pair)
            for pairs in (self.attends, self.near, self.hears)
        )
        plays = tuple(relation for relation in self.plays if relation[0] != entity)
        return Situation(plays, *kept)

    def canonical(self) -> "Situation":
        """The one situation that stands for all that swaps lead to from here."""
        names = self.entities
        features = {actor: self._alone(actor, role) for actor, role in self.plays}
        among = [(a, b) for a, b in self.attends if a in features and b in features]
        order = canonical_order(features, among)
        return self._renamed(dict(zip(order, names, strict=True)))

    def relations(self, actor: str) -> tuple[bool, bool, bool]:
        """Whether an actor attends to a robot, is near it, and would hear it."""
        actors = self.entities
        attends = any(a == actor and b not in actors for a, b in self.attends)
        near = any(a == actor for a, _ in self.near)
        return attends, near, any(a == actor for a, _ in self.hears)

    def _alone(self, actor: str, role: str) -> tuple[str, *tuple[list[str], ...]]:
        """What is true of an actor without looking at other actors."""
        actors = self.entities
        looks_at = sorted(b for a, b in self.attends if a == actor and b not in actors)
        seen_by = sorted(a for a, b in self.attends if b == actor and a not in actors)
        near = sorted(b for a, b in self.near if a == actor)
        hears = sorted(b for a, b in self.hears if a == actor)
        return (role, looks_at, seen_by, near, hears)

    def _renamed(self, names: Mapping[str, str]) -> "Situation":
        attends, near, hears = (
            ((names.get(a, a), names.get(b, b)) for a, b in pairs)
            for pairs in (self.attends, self.near, self.hears)
        )
        roles = {names.get(actor, actor): role for actor, role in self.plays}
        return Situation.of(roles, attends, near, hears)

    def __str__(self) -> str:
        roles = [f"{actor} {role}" for actor, role in self.plays]
        pairs = [
            f"{one} {sign} {other}"
            for name, sign in PAIRS.items()
            for one, other in sorted(getattr(self, name))
        ]
        return ", ".join(roles + pairs)

    def __repr__(self) -> str:
        return f"Situation({self})"

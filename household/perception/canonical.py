"""A canonical order of actors: the same for every way of exchanging them.

Actors are distinguished by their own features, then by the actors they are related to
(Weisfeiler-Leman refinement). Those who remain tied fall into groups that are not
related to each other, and each group is ordered on its own. Where all of a group are
tied, each of them is tried in the first place (individualization), so that the result
is exact and not a heuristic.
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

Relation = tuple[str, str]
Ranks = dict[str, int]
Pairs = frozenset[Relation]


def canonical_order(
    features: Mapping[str, Any], relations: Iterable[Relation]
) -> list[str]:
    """The actors in an order that depends on names only where that changes nothing.

    Args:
        features: What is true of each actor on its own; values must be sortable.
        relations: Pairs of actors (observer, target).

    Returns:
        All actors. Renaming them renames the order alike, except among actors whose
        exchange leaves all features and relations as they are.
    """
    return _order(_ranked(features), frozenset(relations))


def _order(ranks: Ranks, pairs: Pairs) -> list[str]:
    ranks = _refined(ranks, pairs) if pairs else ranks
    # Relations to an actor with a unique rank are in the others' ranks already.
    held = Counter(ranks.values())
    tied = {actor for actor, rank in ranks.items() if held[rank] > 1}
    pairs = _among(pairs, tied)
    if not pairs:
        return sorted(ranks, key=ranks.__getitem__)
    groups = list(_groups(ranks, pairs))
    if len(groups) > 1:
        orders = [
            _order({actor: ranks[actor] for actor in group}, _among(pairs, group))
            for group in groups
        ]
        orders.sort(key=lambda order: _form(order, ranks, pairs))
        return [actor for order in orders for actor in order]
    candidates = (
        _order({a: 2 * rank - (a == first) for a, rank in ranks.items()}, pairs)
        for first in _firsts(ranks, pairs)
    )
    return min(candidates, key=lambda order: _form(order, ranks, pairs))


def _form(order: list[str], ranks: Ranks, pairs: Pairs) -> tuple[Any, ...]:
    """What is left of ranks and pairs when names are replaced by places."""
    place = {actor: index for index, actor in enumerate(order)}
    related = sorted((place[a], place[b]) for a, b in pairs if a in place)
    return [ranks[actor] for actor in order], related


def _groups(ranks: Ranks, pairs: Pairs) -> Iterator[set[str]]:
    """The connected components: actors that pairs link, in whichever direction."""
    near: dict[str, set[str]] = {actor: set() for actor in ranks}
    for a, b in pairs:
        near[a].add(b)
        near[b].add(a)
    left = dict.fromkeys(ranks)
    while left:
        group: set[str] = set()
        frontier = [next(iter(left))]
        while frontier:
            actor = frontier.pop()
            if actor not in group:
                group.add(actor)
                del left[actor]
                frontier.extend(near[actor])
        yield group


def _among(pairs: Pairs, group: set[str]) -> Pairs:
    return frozenset(pair for pair in pairs if group.issuperset(pair))


def _firsts(ranks: Ranks, pairs: Pairs) -> list[str]:
    """Actors of the lowest shared rank, one of those whose exchange changes nothing."""
    lowest = min(rank for rank, n in Counter(ranks.values()).items() if n > 1)
    firsts: list[str] = []
    for actor in (a for a, rank in ranks.items() if rank == lowest):
        if not any(_are_twins(actor, other, pairs) for other in firsts):
            firsts.append(actor)
    return firsts


def _are_twins(one: str, other: str, pairs: Pairs) -> bool:
    """Whether two actors can be exchanged without changing any pair."""
    names = {one: other, other: one}
    return all((names.get(a, a), names.get(b, b)) in pairs for a, b in pairs)


def _refined(ranks: Ranks, pairs: Pairs) -> Ranks:
    """Splits ranks by the ranks that actors are related to, as long as any splits."""
    while True:
        finer = _ranked(
            {
                actor: (
                    rank,
                    sorted(ranks[b] for a, b in pairs if a == actor),
                    sorted(ranks[a] for a, b in pairs if b == actor),
                )
                for actor, rank in ranks.items()
            }
        )
        if len(set(finer.values())) == len(set(ranks.values())):
            return finer
        ranks = finer


def _ranked(features: Mapping[str, Any]) -> Ranks:
    """The rank of each actor's feature; equal features share a rank."""
    distinct: list[Any] = []
    for feature in sorted(features.values()):
        if not distinct or feature != distinct[-1]:
            distinct.append(feature)
    return {actor: distinct.index(feature) for actor, feature in features.items()}

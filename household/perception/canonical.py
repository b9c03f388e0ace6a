"""A canonical order of actors: the same for every way of exchanging them.

Actors are told apart by what is true of them, then by whom they are related to
(Weisfeiler-Leman refinement). Where that leaves actors tied, each of them is tried in
the first place (individualization), so that the result is exact and not a heuristic.
"""

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

Relation = tuple[str, str]
Ranks = dict[str, int]


def canonical_orders(
    features: Mapping[str, Any], relations: Iterable[Relation]
) -> Iterator[tuple[str, ...]]:
    """All orders of the actors among which one is canonical.

    Args:
        features: What is true of each actor on its own; values must be sortable.
        relations: Pairs of actors (observer, target).

    Yields:
        Orders that depend on names only where actors are tied; renaming the actors
        renames the set of orders alike.
    """
    pairs = tuple(relations)
    related = {actor for pair in pairs for actor in pair}
    yield from _orders(_ranked(features), pairs, related)


def _orders(
    ranks: Ranks, pairs: tuple[Relation, ...], related: set[str]
) -> Iterator[tuple[str, ...]]:
    ranks = _refined(ranks, pairs) if pairs else ranks
    tied = _first_tie(ranks, related)
    if not tied:
        yield tuple(sorted(ranks, key=ranks.__getitem__))
    for actor in tied:
        first = {a: 2 * rank - (a == actor) for a, rank in ranks.items()}
        yield from _orders(first, pairs, related)


def _first_tie(ranks: Ranks, related: set[str]) -> list[str]:
    """Actors of the lowest shared rank, of those whose order makes a difference."""
    groups: dict[int, list[str]] = {}
    for actor in sorted(related & ranks.keys()):
        groups.setdefault(ranks[actor], []).append(actor)
    ties = (groups[rank] for rank in sorted(groups) if len(groups[rank]) > 1)
    return next(ties, [])


def _refined(ranks: Ranks, pairs: tuple[Relation, ...]) -> Ranks:
    """Tells actors apart by the ranks that they are related to, as far as it goes."""
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

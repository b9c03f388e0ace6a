"""Makes the lists of people, homes and role assignments for each split.

Run as `python -m experiments.phases.splitting` to write them anew; the same lists come
out. Whoever changes them changes what every stored result means, so their hashes stand
in `experiments.phases.splits` and have to be changed by hand.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from experiments.phases.days import ACTIVITIES, DAYS
from experiments.phases.splits import LISTS, SplitLists
from experiments.running.files import to_json, write_text
from household.compiled.arrays import Floats
from household.scenario.persona import Persona
from household.scenario.population import Population, preferences

POPULATION = Population(clusters=4)
"""Of whom people are numbers; only who belongs to which cluster depends on it."""

UNSEEN = 3
"""The cluster that training, validation and test have nobody of."""

N_BEHAVIORS = 6
"""As many as the behaviors of the studies."""

TRAIN, VALIDATION, TEST, OUTSIDE, CANDIDATES = 64, 16, 32, 16, 200
"""Sizes of the splits of people, and of how many those of test are chosen."""

HOMES = {"train": 24, "validation": 6, "test": 12, "out_of_distribution": 6}

ROLES = {"train": 0.6, "validation": 0.1}
"""Shares of the role assignments; the rest is test."""

_SEED = 20_080_312  # the date of HRI 2008


def lists() -> dict[str, SplitLists]:
    """Returns the lists of each split."""
    people, homes, roles = _people(), _homes(), _roles()
    return {
        name: SplitLists(
            people=tuple(people[name]), homes=homes[name], roles=tuple(roles[name])
        )
        for name in HOMES
    }


def best_responses(person: int) -> Floats:
    """Returns the behavior that somebody likes best, by activity and attention.

    Args:
        person: Number in the population.

    Returns:
        Shape (n_activities * 2,), of whole numbers.
    """
    nothing = np.zeros((len(ACTIVITIES) + 1, 2, N_BEHAVIORS))
    names = tuple(str(index) for index in range(N_BEHAVIORS))
    plain = Persona(name="plain")
    taste = preferences(nothing, plain, names, POPULATION, 1.0, person)
    return taste.argmax(axis=2).ravel().astype(np.float64)


def most_different(candidates: Sequence[int], n: int) -> list[int]:
    """Returns those of some people whose best responses differ most.

    Begins with who differs most from all others, then takes again and again who differs
    most from the nearest of those taken.
    """
    liked = np.array([best_responses(person) for person in candidates])
    apart = (liked[:, None, :] != liked[None, :, :]).mean(axis=2)
    taken = [int(apart.sum(axis=1).argmax())]
    while len(taken) < n:
        nearest = apart[:, taken].min(axis=1)
        nearest[taken] = -1.0
        taken.append(int(nearest.argmax()))
    return sorted(candidates[index] for index in taken)


def cluster_of(person: int) -> int:
    """Returns which kind of taste somebody has: the first that is drawn of tastes."""
    stream = POPULATION.person(person).spawn(2)[1]
    return int(stream.integers(POPULATION.clusters))


def _people() -> dict[str, list[int]]:
    known: list[int] = []
    outside: list[int] = []
    person = 0
    while len(known) < TRAIN + VALIDATION + CANDIDATES or len(outside) < OUTSIDE:
        (outside if cluster_of(person) == UNSEEN else known).append(person)
        person += 1
    candidates = known[TRAIN + VALIDATION : TRAIN + VALIDATION + CANDIDATES]
    return {
        "train": known[:TRAIN],
        "validation": known[TRAIN : TRAIN + VALIDATION],
        "test": most_different(candidates, TEST),
        "out_of_distribution": outside[:OUTSIDE],
    }


def _homes() -> dict[str, tuple[int, ...]]:
    found, first = {}, 0
    for name, n in HOMES.items():
        found[name] = tuple(range(first, first + n))
        first += n
    return found


def _roles() -> dict[str, list[tuple[int, int]]]:
    """Splits the pairs of days so that training knows each day of both people."""
    rng = np.random.default_rng(_SEED)
    pairs = list(combinations(range(len(DAYS)), 2))
    n_train, n_validation = (round(share * len(pairs)) for share in ROLES.values())
    everything = set(range(len(DAYS)))
    while True:
        drawn = [pairs[index] for index in rng.permutation(len(pairs))]
        turned = [
            (one, other) if keep else (other, one)
            for (one, other), keep in zip(
                drawn, rng.integers(2, size=len(pairs)).tolist(), strict=True
            )
        ]
        train = turned[:n_train]
        if all({pair[place] for pair in train} == everything for place in (0, 1)):
            break
    return {
        "train": train,
        "validation": turned[n_train : n_train + n_validation],
        "test": turned[n_train + n_validation :],
        "out_of_distribution": [(other, one) for one, other in train],
    }


if __name__ == "__main__":
    for _name, _lists in lists().items():
        write_text(LISTS / f"{_name}.json", to_json(_lists))

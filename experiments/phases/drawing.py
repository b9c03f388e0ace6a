"""Which households a trial is about: drawn from the lists of the splits by its seed.

Each factor has a stream of its own, so that conditions with the same seed share what
they have in common: people, homes, roles. People of a split live together in groups
that are the same for all seeds, so that a group's score can be resampled.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, TypeVar

import numpy as np

from experiments.phases.records import Phases, Probing, Training
from experiments.phases.splits import Split, read
from experiments.phases.world import Residence, World

T = TypeVar("T")
Pairs = tuple[tuple[int, int], ...]

PEOPLE, HOMES, ROLES = range(3)


def trained_in(training: Training, seed: int) -> tuple[Residence, ...]:
    """Returns the households of the first phase, in order.

    Args:
        training: What is trained.
        seed: The trial's.
    """
    world, n = training.world, training.households
    people = _groups(world, "train", n, _stream(seed, PEOPLE), final=False)
    homes = _cycled(read("train").homes, n, _stream(seed, HOMES))
    roles = _roles(world, "train", n, _stream(seed, ROLES), final=False)
    return tuple(
        Residence(world=world, home=home, people=group, roles=days)
        for group, home, days in zip(people, homes, roles, strict=True)
    )


def probed_in(condition: Phases, seed: int) -> tuple[Residence, ...]:
    """Returns the households that are probed, in order.

    Each is one of training in which something is new. This alone reads the test.

    Args:
        condition: What is new, and from which split.
        seed: The trial's.
    """
    training, probing = condition.training, condition.probing
    before = trained_in(replace(training, world=_alike(training, probing)), seed)
    base = [before[i % len(before)] for i in range(probing.households)]
    changed = [_renewed(each, probing) for each in base]
    for factor in ("people", "home", "roles"):
        if factor in probing.new:
            drawn: Any = _drawn(factor, probing, seed)
            changed = [
                replace(each, **{factor: value})
                for each, value in zip(changed, drawn, strict=True)
            ]
    if probing.acquaintances:
        changed = [
            replace(each, people=_mixed(known.people, each.people, probing))
            for known, each in zip(base, changed, strict=True)
        ]
    return tuple(changed)


def _alike(training: Training, probing: Probing) -> World:
    """The world of training with as many people as are probed."""
    return replace(
        training.world,
        people=probing.world.people,
        family=probing.world.family,
        days=probing.world.days,
    )


def _renewed(residence: Residence, probing: Probing) -> Residence:
    moved = replace(residence, world=probing.world)
    return moved.swapped() if "swap" in probing.new else moved


def _mixed(
    known: tuple[int, ...], new: tuple[int, ...], probing: Probing
) -> tuple[int, ...]:
    return known[: probing.acquaintances] + new[probing.acquaintances :]


def _drawn(factor: str, probing: Probing, seed: int) -> Sequence[object]:
    """A value of one factor for each household that is probed."""
    world, split, n = probing.world, probing.split, probing.households
    streams = {"people": PEOPLE, "home": HOMES, "roles": ROLES}
    rng = _stream(seed, streams[factor], anew=True)
    if factor == "people":
        return _groups(world, split, n, rng, final=True)
    if factor == "home":
        return _cycled(read(split, final=True).homes, n, rng)
    return _roles(world, split, n, rng, final=True)


def _groups(
    world: World, split: Split, n: int, rng: np.random.Generator, *, final: bool
) -> list[tuple[int, ...]]:
    """People who live together; in a family, the seed that draws them all."""
    people = read(split, final=final).people
    size = 1 if world.family is not None else world.people
    groups = [
        tuple(people[(first + i) % len(people)] for i in range(size))
        for first in range(0, max(len(people) - size + 1, 1), size)
    ]
    return _cycled(groups, n, rng)


def _roles(
    world: World, split: Split, n: int, rng: np.random.Generator, *, final: bool
) -> list[Pairs]:
    """Days two by two; nothing where everybody does everything."""
    known = read(split, final=final).roles
    if world.family is not None:
        return [((one * 100 + other, 0),) for one, other in _cycled(known, n, rng)]
    if not world.days:
        return [()] * n
    size = -(-world.people // 2)
    drawn = _cycled(known, n * size, rng)
    return [tuple(drawn[i * size : (i + 1) * size]) for i in range(n)]


def _cycled(values: Sequence[T], n: int, rng: np.random.Generator) -> list[T]:
    """So many values, none twice before each came once."""
    found: list[T] = []
    while len(found) < n:
        found += [values[i] for i in rng.permutation(len(values)).tolist()]
    return found[:n]


def _stream(seed: int, what: int, *, anew: bool = False) -> np.random.Generator:
    return np.random.default_rng(
        np.random.SeedSequence(seed, spawn_key=(5, what, int(anew)))
    )

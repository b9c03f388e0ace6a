"""The population that a household's people are drawn from.

Tastes are drawn hierarchically: a person belongs to a cluster, and departs from it
individually. How far tastes replace the household's norms is the scenario's
`heterogeneity`: at 0 everybody shares the norms, so that roles are interchangeable; at
1 everybody has a taste of its own, so that analogy between people misleads.
"""

import math
from typing import Annotated

import msgspec
import numpy as np

from household.compiled.arrays import Floats
from household.config.quantities import Seed, Share
from household.config.toml import Record
from household.scenario.norms import norm_table
from household.scenario.persona import Persona

SPREAD = 0.3
"""Standard deviation of the logarithm of a trait at full heterogeneity: two people in
three then lie within about 35 % of their persona (our choice). The medians of the
reaction times of CHARM's 46 people, 0.59 to 2.37 s, spread as much."""

VARIED = (
    *("walking_speed", "praise", "sanction", "habituation", "recovery", "patience"),
    "reaction",
)
"""Traits in which people of the same persona differ; new ones come last, so that the
others stay what they were."""

CLUSTERS, PEOPLE = 0, 1


class Population(Record, frozen=True, kw_only=True):
    """How people are drawn.

    Attributes:
        seed: The same seed draws the same people, whatever the episode's seed is.
        clusters: How many kinds of taste there are.
        clusteredness: Share of a taste that is its cluster's; 0: all individual.
        reliability: How reliably people give feedback; scales praise and sanction,
            and what is missing to 1 becomes touches of the wrong kind, half of it.
    """

    seed: Seed = 0
    clusters: Annotated[int, msgspec.Meta(ge=1, le=1000)] = 4
    clusteredness: Share = 0.0
    reliability: Share = 1.0

    def person(self, number: int) -> np.random.Generator:
        """The stream that draws one person; adding people changes no other's."""
        return self._stream(PEOPLE, number)

    def cluster(self, index: int) -> np.random.Generator:
        """The stream that draws one cluster's taste."""
        return self._stream(CLUSTERS, index)

    def _stream(self, kind: int, index: int) -> np.random.Generator:
        sequence = np.random.SeedSequence(self.seed, spawn_key=(kind, index))
        return np.random.default_rng(sequence)


def individual(
    persona: Persona, population: Population, heterogeneity: float, number: int
) -> Persona:
    """A persona with the traits of one person.

    Args:
        persona: What kind of person it is.
        population: Draws the traits.
        heterogeneity: How far people differ, in [0, 1].
        number: Which person of the population it is.
    """
    # Spawned, so that traits and tastes do not shift each other's draws.
    rng = population.person(number).spawn(2)[0]
    draws = (heterogeneity * SPREAD * rng.standard_normal(len(VARIED))).tolist()
    traits = {
        # NumPy's `exp` rounds otherwise on processors with AVX-512.
        name: getattr(persona, name) * math.exp(draw)
        for name, draw in zip(VARIED, draws, strict=True)
    }
    for name in ("praise", "sanction", "habituation"):
        traits[name] = min(traits[name], 1.0)
    for name in ("praise", "sanction"):
        traits[name] *= population.reliability
    wrong = persona.mistakes + (1.0 - population.reliability) / 2
    return msgspec.structs.replace(persona, **traits, mistakes=min(wrong, 1.0))


def preferences(
    norms: Floats,
    persona: Persona,
    behaviors: tuple[str, ...],
    population: Population,
    heterogeneity: float,
    number: int,
) -> Floats:
    """What one person finds polite.

    Args:
        norms: The household's, shape (n_activities, 2, n_behaviors), in [-1, 1].
        persona: Its preferences are a part of the taste that is not drawn.
        behaviors: Names in the order of the last axis.
        population: Draws the rest of the taste.
        heterogeneity: Share of the taste in what the person prefers, in [0, 1].
        number: Which person of the population it is.

    Returns:
        Shape of ``norms``, in [-1, 1].
    """
    rng = population.person(number).spawn(2)[1]
    cluster = population.cluster(int(rng.integers(population.clusters)))
    shared = cluster.uniform(-1.0, 1.0, norms.shape)
    own = rng.uniform(-1.0, 1.0, norms.shape)
    drawn = population.clusteredness * shared + (1 - population.clusteredness) * own
    known = norm_table(persona.preferences, behaviors, np.nan)
    taste = np.where(np.isnan(known), drawn, known)
    return (1.0 - heterogeneity) * norms + heterogeneity * taste

"""How well a policy does in one household: on its probe set, and living there."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from experiments.phases.world import Residence, household
from experiments.scoring.moments import Moment, ProbeSet, Sight, probe_set
from experiments.scoring.policies import Policy
from experiments.scoring.scores import Choose, live, probe_score

if TYPE_CHECKING:
    from household.environment import Household

WALKS, STEPS = 2, 900
"""Reference walks that a probe set is drawn from, and their length [steps]."""

LIVED = (
    "verdicts_per_minute",
    "verdicts_per_bout",
    "caresses_per_minute",
    "taps_per_minute",
    "opinion",
)
"""Columns of what comes of living there."""

Row = dict[str, Any]


def row_of(residence: Residence, policy: Policy, probes: ProbeSet, lived: int) -> Row:
    """What becomes of a policy in a household.

    Args:
        residence: The household.
        policy: What is judged.
        probes: The household's probe set.
        lived: Steps of an episode of the policy's own; 0: none.
    """
    sights: Sequence[Sight] = probes.moments
    return about(residence, probes) | {
        "greedy": probe_score([policy.greedy(s) for s in sights], probes.moments),
        "deployed": probe_score([policy.deployed(s) for s in sights], probes.moments),
        **life(residence, lambda now: policy.deployed(now.sight()), lived),
    }


def about(residence: Residence, probes: ProbeSet) -> Row:
    """Which household it is, and what its probe set is like."""
    return {
        "people": residence.group,
        "home": residence.home,
        "roles": " ".join(f"{one}-{other}" for one, other in residence.roles),
        "best_constant": _best_constant(probes),
        "moments": len(probes.moments),
        "share": probes.share,
    }


def life(residence: Residence, choose: Choose, steps: int) -> Row:
    """What becomes of a policy's own episode; nothing if there is none."""
    if not steps:
        return dict.fromkeys(LIVED)
    return life_in(household(residence, steps), residence, choose)


def life_in(env: Household, residence: Residence, choose: Choose) -> Row:
    """What becomes of an episode in a household that `choose` may look ahead in."""
    lived = live(env, choose, residence.words(3)[2])
    return {
        "verdicts_per_minute": lived.per_minute,
        "verdicts_per_bout": lived.per_bout,
        "caresses_per_minute": lived.caresses / lived.minutes,
        "taps_per_minute": lived.taps / lived.minutes,
        "opinion": lived.opinion,
    }


@lru_cache(maxsize=48)
def probes_of(residence: Residence) -> ProbeSet:
    """The probe set of a household: the same for every seed and every condition.

    What a robot observes is kept as it is asked for (features).
    """
    return probe_set(household(residence, STEPS), residence.words(WALKS), STEPS)


def _best_constant(probes: ProbeSet) -> float:
    moments: tuple[Moment, ...] = probes.moments
    if not moments:
        return float("nan")
    n = moments[0].n_behaviors
    return max(probe_score([each] * len(moments), moments) for each in range(n))

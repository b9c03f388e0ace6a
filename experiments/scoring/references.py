"""Reference policies: what every score is read beside.

They may know what only the simulator knows. None is a true ceiling: people react to
what a robot did before, and a policy changes who looks at the robot.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from experiments.scoring.lookahead import played_out
from experiments.scoring.moments import Moment
from experiments.scoring.policies import Policy, at_random

if TYPE_CHECKING:
    from household.environment import Household


@dataclass(frozen=True, kw_only=True)
class Reference:
    """A policy to compare with."""

    choose: Callable[[Moment], int]
    """Index of a behavior."""

    on_probes: bool = True
    """Whether a moment alone is enough for it to choose."""


def references(env: Household, rng: np.random.Generator) -> dict[str, Reference]:
    """Returns the reference policies of a household, by name.

    The best constant is not among them: which one that is shows only once all of them
    are scored.
    """
    return {
        "random": Reference(choose=at_random(rng).greedy),
        **{
            f"constant:{name}": Reference(choose=_constant(behavior))
            for behavior, name in enumerate(env.behaviors)
        },
        "population": Reference(choose=lambda moment: int(moment.expected.argmax())),
        "persona": Reference(choose=lambda moment: int(moment.truth.argmax())),
        "lookahead": Reference(
            choose=lambda moment: int(played_out(env, moment.agent).argmax()),
            on_probes=False,
        ),
    }


def _constant(behavior: int) -> Callable[[Moment], int]:
    return Policy.plain(lambda sight: behavior).greedy

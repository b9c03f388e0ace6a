"""What a trial with phases is: plain records of what is trained, changed and probed."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from experiments.errors import ExperimentError
from experiments.phases.splits import Split
from experiments.phases.world import World
from experiments.running.study import Condition
from learners.team import Sharing

New = Literal["people", "home", "roles", "swap"]
"""What can be other in the households that are probed. `swap`: people two by two have
exchanged their days."""


@dataclass(frozen=True, kw_only=True)
class Training:
    """The first phase: many households, one after the other."""

    world: World = field(default_factory=World)
    """Where; people, homes and roles are from the split `train`."""

    households: int = 4
    decisions: int = 1_500
    """Steps of the environment in each household (25 minutes); 0: nothing is
    learned."""

    alone: int = 0
    """So many robots learn, each alone in the households; 0: those of the world learn
    there together."""


@dataclass(frozen=True, kw_only=True)
class Probing:
    """The phases after it: freeze or adapt, probe, live."""

    world: World = field(default_factory=World)
    """Where."""

    new: tuple[New, ...] = ()
    """What is other than in training; nothing: the same households, other episodes."""

    split: Split = "test"
    """Where that is from."""

    acquaintances: int = 0
    """How many of the people are nevertheless known from training."""

    households: int = 4
    touches: tuple[int, ...] = (0,)
    """It is probed when it has felt so many touches there; 0: frozen."""

    decisions: int = 6_000
    """It adapts for so many steps at most, however few touches it feels."""

    lived: int = 0
    """Steps for which it then lives there, frozen, to be scored by what people think;
    0: it does not."""

    def __post_init__(self) -> None:
        """Checks the touches."""
        if not self.touches or list(self.touches) != sorted(set(self.touches)):
            raise ExperimentError(f"touches {self.touches}: must rise, at least one.")


@dataclass(frozen=True, kw_only=True)
class Phases(Condition):
    """One condition of a study: who is trained where, and what is then probed.

    `learner` is a name from the catalog, `module:function` (which makes a learner of
    one's own from the number of behaviors, a generator and the overrides), a policy
    (`act:module:function`, of observation and agent), or a reference: `random`,
    `constant:BEHAVIOR`, `population`, `persona`, `lookahead`.
    """

    scenario: str = "drawn"
    training: Training = field(default_factory=Training)
    probing: Probing = field(default_factory=Probing)
    sharing: Sharing = "independent"
    """What several robots have of each other's experience."""

"""The one list of learners by name."""

import dataclasses
import difflib
from collections.abc import Callable, Mapping
from typing import Any, cast

import numpy as np

from learners.analogy import AdaptiveAnalogy, Propagation, RemoveEntity, SwapRoles
from learners.baselines.advise import Advise
from learners.baselines.bounds import BestConstant, Oracle, OracleCredit, RandomChoice
from learners.baselines.coach import Coach
from learners.baselines.delay_density import DelayDensity
from learners.baselines.e_coach import ECoach
from learners.baselines.fixed_shift import FixedShift
from learners.baselines.full_sharing import FullSharing
from learners.baselines.hierarchical_thompson import HierarchicalThompson
from learners.baselines.hysteretic import Hysteretic
from learners.baselines.i_sabl import ISabl
from learners.baselines.no_sharing import NoSharing
from learners.baselines.sign_asymmetric import SignAsymmetric
from learners.baselines.skip_silence import SkipSilence
from learners.baselines.symmetric import SymmetricQ
from learners.baselines.tamer import Tamer
from learners.baselines.travel_posterior import TravelPosterior
from learners.baselines.uniform_window import UniformWindow
from learners.credit.advice import Advice
from learners.credit.heuristics import AttentionShift, FixedDelay, MostRecent
from learners.credit.rules import Designated, Trace
from learners.errors import ParameterError, UnknownNameError
from learners.learner import Learner
from learners.qlearner import QLearner
from learners.representation import Canonical
from learners.tabular.rates import AsynchronousRate, SynchronousRate

Components = Callable[..., dict[str, Any]]
"""Makes settings from what a recipe needs; `dict` passes that on as it is."""


@dataclasses.dataclass(frozen=True, kw_only=True)
class Recipe:
    """How a named learner is put together.

    Attributes:
        summary: one line for people who choose.
        kind: the learner's class, a dataclass.
        components: makes its settings anew for each learner, from what it `needs`.
        needs: names of callables into the world that the caller must give.
    """

    summary: str
    kind: type
    components: Components = dict
    needs: tuple[str, ...] = ()

    @property
    def settings(self) -> frozenset[str]:
        """Names that may be overridden."""
        fields = dataclasses.fields(self.kind)
        names = {f.name for f in fields if f.init} - {"n_behaviors", "rng"}
        return frozenset(names | set(self.needs))


CATALOG: Mapping[str, Recipe] = {
    "q_synchronous": Recipe(
        summary="standard Q-learning, one rate for all pairs (experiment 1)",
        kind=QLearner,
        components=lambda: {"rate": SynchronousRate()},
    ),
    "q_asynchronous": Recipe(
        summary="standard Q-learning, each pair its own rate (experiment 1)",
        kind=QLearner,
        components=lambda: {"rate": AsynchronousRate()},
    ),
    "q_social": Recipe(
        summary="Q-learning with the social rate (experiments 2 and 3)",
        kind=QLearner,
    ),
    "q_trace": Recipe(
        summary="Watkins' Q(lambda), accumulating traces (experiment 3)",
        kind=QLearner,
        components=lambda: {"credit": Trace()},
    ),
    "q_trace_replacing": Recipe(
        summary="Watkins' Q(lambda), replacing traces",
        kind=QLearner,
        components=lambda: {"credit": Trace(replacing=True)},
    ),
    "designated": Recipe(
        summary="credit to the pair before the giver set out (experiment 4)",
        kind=QLearner,
        components=lambda: {"credit": Designated()},
    ),
    "designated_most_recent": Recipe(
        summary="designated credit, the most recent pair",
        kind=QLearner,
        components=lambda: {"credit": Designated(heuristic=MostRecent())},
    ),
    "designated_fixed_delay": Recipe(
        summary="designated credit, the pair a fixed delay ago",
        kind=QLearner,
        components=lambda: {"credit": Designated(heuristic=FixedDelay())},
    ),
    "designated_attention": Recipe(
        summary="designated credit, the pair when the giver's attention shifted",
        kind=QLearner,
        components=lambda: {"credit": Designated(heuristic=AttentionShift())},
    ),
    "advice": Recipe(
        summary="designated credit, asking why when in doubt",
        kind=QLearner,
        components=lambda ask: {"credit": Designated(heuristic=Advice(ask=ask))},
        needs=("ask",),
    ),
    "designated_swap": Recipe(
        summary="designated credit and SwapRoles, two actors (experiment 5)",
        kind=QLearner,
        components=lambda: {"credit": Designated(), "analogy": Propagation()},
    ),
    "designated_remove": Recipe(
        summary="designated credit and SwapRoles and RemoveEntity",
        kind=QLearner,
        components=lambda: {
            "credit": Designated(),
            "analogy": Propagation(operators=(SwapRoles(), RemoveEntity())),
        },
    ),
    "designated_canonical": Recipe(
        summary="designated credit and the canonical form, many actors",
        kind=QLearner,
        components=lambda: {"credit": Designated(), "representation": Canonical()},
    ),
    "designated_adaptive": Recipe(
        summary="designated credit and analogy trusted as far as people agree",
        kind=QLearner,
        components=lambda: {"credit": Designated(), "analogy": AdaptiveAnalogy()},
    ),
    "skip_silence": Recipe(
        summary="Q-learning that skips steps without a touch",
        kind=SkipSilence,
    ),
    "hysteretic": Recipe(
        summary="Q-learning slow to believe bad news",
        kind=Hysteretic,
    ),
    "sign_asymmetric": Recipe(
        summary="Q-learning that weighs caress, tap and silence apart",
        kind=SignAsymmetric,
    ),
    "tamer": Recipe(
        summary="predicts the feedback itself, credit by a delay density",
        kind=Tamer,
    ),
    "coach": Recipe(
        summary="policy gradient weighed by feedback",
        kind=Coach,
    ),
    "e_coach": Recipe(
        summary="policy gradient by episodes, discounted",
        kind=ECoach,
    ),
    "advise": Recipe(
        summary="policy shaping: touches as votes",
        kind=Advise,
    ),
    "i_sabl": Recipe(
        summary="reads silence as evidence, by EM",
        kind=ISabl,
    ),
    "fixed_shift": Recipe(
        summary="Q-learning, credit a constant delay ago",
        kind=QLearner,
        components=lambda: {"credit": FixedShift()},
    ),
    "uniform_window": Recipe(
        summary="Q-learning, credit spread over a window",
        kind=QLearner,
        components=lambda: {"credit": UniformWindow()},
    ),
    "delay_density": Recipe(
        summary="Q-learning, credit by TAMER's delay density",
        kind=QLearner,
        components=lambda: {"credit": DelayDensity()},
    ),
    "travel_posterior": Recipe(
        summary="Q-learning, credit by Bayes over when the giver set out",
        kind=QLearner,
        components=lambda: {"credit": TravelPosterior()},
    ),
    "symmetric": Recipe(
        summary="standard Q-learning, one table tied over the orbit",
        kind=SymmetricQ,
    ),
    "full_sharing": Recipe(
        summary="mean touch per place, everybody's opinion pooled",
        kind=FullSharing,
        components=lambda: {"credit": Designated()},
    ),
    "no_sharing": Recipe(
        summary="mean touch per place, each person by itself",
        kind=NoSharing,
        components=lambda: {"credit": Designated()},
    ),
    "hierarchical_thompson": Recipe(
        summary="partial pooling over people, Thompson sampling",
        kind=HierarchicalThompson,
        components=lambda: {"credit": Designated()},
    ),
    "random": Recipe(
        summary="any behavior at any time",
        kind=RandomChoice,
    ),
    "best_constant": Recipe(
        summary="the one behavior that is best on average",
        kind=BestConstant,
        needs=("appropriateness",),
    ),
    "population_oracle": Recipe(
        summary="best for the average person",
        kind=Oracle,
        needs=("appropriateness",),
    ),
    "persona_oracle": Recipe(
        summary="best for the people who are there",
        kind=Oracle,
        needs=("appropriateness",),
    ),
    "oracle_credit": Recipe(
        summary="social Q-learning, credit to the true cause",
        kind=QLearner,
        components=lambda cause: {"credit": OracleCredit(cause=cause)},
        needs=("cause",),
    ),
}


def make_learner(
    name: str, n_behaviors: int, rng: np.random.Generator, **overrides: object
) -> Learner:
    """A learner by name.

    Args:
        name: one of `CATALOG`.
        n_behaviors: number of behaviors to choose from.
        rng: its only source of randomness.
        **overrides: settings in place of the recipe's, such as `gamma=0.5` or
            `exploration=Greedy()`, and whatever the recipe needs.

    Raises:
        UnknownNameError: if there is no such learner or setting, naming the nearest.
        ParameterError: if a setting is out of range, or one that it needs is missing.
    """
    recipe = CATALOG.get(name)
    if recipe is None:
        raise UnknownNameError(_no_such("learner", name, CATALOG))
    for given in overrides:
        if given not in recipe.settings:
            raise UnknownNameError(
                _no_such(f"setting of {name}", given, recipe.settings)
            )
    missing = [need for need in recipe.needs if need not in overrides]
    if missing:
        raise ParameterError(f"learner {name!r} needs {', '.join(missing)}")
    needed = {need: overrides.pop(need) for need in recipe.needs}
    components = recipe.components(**needed) | overrides
    return cast(Learner, recipe.kind(n_behaviors, rng, **components))


def _no_such(what: str, name: str, known: Mapping[str, Any] | frozenset[str]) -> str:
    allowed = sorted(known)
    near = difflib.get_close_matches(name, allowed, n=1)
    hint = f"; did you mean {near[0]!r}?" if near else ""
    return f"there is no {what} called {name!r}{hint} (allowed: {', '.join(allowed)})"

"""Learners to compare with: baselines, and bounds from above and below."""

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
from learners.catalog.recipe import Recipe, Recipes
from learners.credit.rules import Designated
from learners.qlearner import QLearner

BASELINES: Recipes = {
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
"""What a reviewer would ask to see beside the paper's."""

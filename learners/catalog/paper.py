"""The learners of the paper's experiments, and their heuristics."""

from learners.analogy import Propagation
from learners.catalog.recipe import Recipe, Recipes
from learners.credit.advice import Advice
from learners.credit.heuristics import AttentionShift, FixedDelay, MostRecent
from learners.credit.rules import Designated, Trace
from learners.qlearner import QLearner
from learners.tabular.rates import AsynchronousRate, SynchronousRate

PAPER: Recipes = {
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
}
"""What the paper describes."""

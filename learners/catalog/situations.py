"""Learners by what they represent of a situation, and of whom."""

from learners.analogy import AdaptiveAnalogy, Propagation, RemoveEntity, SwapRoles
from learners.catalog.recipe import Recipe, Recipes
from learners.credit.rules import Designated
from learners.expectation import ExpectedTouch
from learners.exploration import Softmax
from learners.pooling import HierarchicalPooling
from learners.qlearner import QLearner
from learners.representation import (
    AudibleViews,
    Canonical,
    Nameless,
    NestedViews,
    Views,
)


def rates_of_people() -> HierarchicalPooling:
    """Hierarchical pooling for means of exposures.

    Most bouts pass in silence, so what people do in them, and what they differ by, is
    about a quarter of what it is for touches. Our choice, by the scores of random walks
    through villas and generated homes with 1 to 12 people, heterogeneity 0 to 1.
    """
    return HierarchicalPooling(population=0.15, person=0.05, touch=0.15)


SITUATIONS: Recipes = {
    "designated_canonical": Recipe(
        summary="designated credit and the canonical form, many actors",
        kind=QLearner,
        components=lambda: {"credit": Designated(), "representation": Canonical()},
    ),
    "designated_nameless": Recipe(
        summary="designated credit and the canonical form without names, for strangers",
        kind=QLearner,
        components=lambda: {"credit": Designated(), "representation": Nameless()},
    ),
    "designated_remove": Recipe(
        summary="designated credit and SwapRoles and RemoveEntity",
        kind=QLearner,
        components=lambda: {
            "credit": Designated(),
            "analogy": Propagation(operators=(SwapRoles(), RemoveEntity())),
        },
    ),
    "designated_back_off": Recipe(
        summary="designated credit, borrowing from situations with one or two less",
        kind=QLearner,
        components=lambda: {
            "credit": Designated(),
            "representation": Nameless(),
            "analogy": Propagation(operators=(RemoveEntity(),), depth=2),
        },
    ),
    "designated_adaptive": Recipe(
        summary="designated credit and analogy trusted as far as people agree",
        kind=QLearner,
        components=lambda: {"credit": Designated(), "analogy": AdaptiveAnalogy()},
    ),
    "designated_views": Recipe(
        summary="designated credit and a value for each person's view, summed",
        kind=QLearner,
        components=lambda: {
            "credit": Designated(),
            "gamma": 0.0,  # as good as 0.1 here, and quicker
            "representation": Views(),
            "pooling": rates_of_people(),
        },
    ),
    "views": Recipe(
        summary="expected touch of each person's view per exposure, summed",
        kind=ExpectedTouch,
        components=lambda: {
            "credit": Designated(),
            "counts": "exposures",
            "representation": Views(),
            "pooling": rates_of_people(),
            # Rates are about a sixth of touches, and so is the temperature.
            "exploration": Softmax(temperature=0.03),
        },
    ),
    "audible_views": Recipe(
        summary="the same for those alone who attend to the robot or hear it",
        kind=ExpectedTouch,
        components=lambda: {
            "credit": Designated(),
            "counts": "exposures",
            "representation": AudibleViews(),
            "pooling": rates_of_people(),
            "exploration": Softmax(temperature=0.03),
        },
    ),
    "nested_views": Recipe(
        summary="the same in full and by role alone, so that new views are not blank",
        kind=ExpectedTouch,
        components=lambda: {
            "credit": Designated(),
            "counts": "exposures",
            "representation": NestedViews(),
            "pooling": rates_of_people(),
            "exploration": Softmax(temperature=0.03),
        },
    ),
}
"""Designated credit throughout; what differs is the representation."""

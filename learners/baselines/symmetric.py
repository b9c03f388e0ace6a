"""Symmetric Q-learning: one table tied over the orbit of each state.

Ravindran & Barto (2001), "Symmetries and model minimization in Markov decision
processes"; van der Pol, Worrall, van Hoof, Oliehoek & Welling (2020), "MDP homomorphic
networks", NeurIPS: symmetric states share one value by construction. It takes for
granted that people are interchangeable.
"""

from dataclasses import dataclass, field

from learners.qlearner import QLearner
from learners.representation.parts import Representation
from learners.representation.situations import Canonical
from learners.saving import saved
from learners.tabular.rates import AsynchronousRate, Rate


@saved
@dataclass(eq=False)
class SymmetricQ(QLearner):
    """Standard Q-learning on canonical states.

    Attributes:
        representation: the canonical form.
        rate: asynchronous by default.
    """

    representation: Representation = field(default_factory=Canonical, kw_only=True)
    rate: Rate = field(default_factory=AsynchronousRate, kw_only=True)

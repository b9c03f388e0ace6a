"""Temporal-difference arithmetic: pure functions of numbers, one line each.

Time indices follow the names: `_tm1` before the transition, `_t` after it.
"""

from collections.abc import Sequence


def q_target(r_t: float, discount_t: float, q_t: Sequence[float]) -> float:
    """What Q-learning moves a value towards: r + gamma * max_a' Q(s', a').

    Args:
        r_t: reward of the transition.
        discount_t: gamma, in [0, 1).
        q_t: values in the next state, shape (n_behaviors,).

    Source: section 3.1 of the paper (after Watkins 1989).
    """
    return r_t + discount_t * max(q_t)


def td_error(q_tm1: float, target: float) -> float:
    """How far a value is from its target: positive if it was too low."""
    return target - q_tm1


def moved(q_tm1: float, target: float, step: float) -> float:
    """A value after one step: (1 - alpha) * Q + alpha * target.

    Args:
        q_tm1: the value before.
        target: what it moves towards.
        step: learning rate times eligibility, >= 0.

    Source: section 3.1 of the paper, written as Q + alpha * (target - Q).
    """
    return q_tm1 + step * (target - q_tm1)


def hysteretic(q_tm1: float, target: float, increase: float, decrease: float) -> float:
    """Learning-rate factor by the way it goes: good surprises count more.

    Args:
        q_tm1: the value before.
        target: what it moves towards.
        increase: factor if the value was not too high, in [0, 1].
        decrease: factor if it was too high, in [0, 1].

    Source: Matignon, Laurent & Le Fort-Piat (2007), equation 3.
    """
    return increase if target >= q_tm1 else decrease

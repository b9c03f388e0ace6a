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
    return q_tm1 + step * td_error(q_tm1, target)


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


def pooled(
    own: float, n_own: float, others: float, trust: float, noise: float
) -> float:
    """Partial pooling: own experience first, the others' where there is little.

        own + w * (others - own),   w = trust * k / (n_own + k)

    where k = noise * trust / (1 - trust) is how many touches of one's own the others'
    value is worth. At trust 0 the own value stands alone, at trust 1 the others' does.

    Args:
        own: value learned in this very state.
        n_own: touches behind it, >= 0.
        others: value learned in all analogous states together.
        trust: how far people agree, in [0, 1].
        noise: variance of one touch over the variance of tastes, > 0.

    Source: our choice, after the normal hierarchical model (Gelman & Hill 2007, 12.2):
    with tastes of variance 1, of which people share the part `trust`, one touch with
    variance `noise`, and an unknown taste guessed at trust * others.
    """
    if trust <= 0.0:
        return own
    worth = noise * trust
    weight = trust * worth / (n_own * (1.0 - trust) + worth)
    return own + weight * (others - own)

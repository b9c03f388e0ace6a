"""Partial pooling by trust: pure functions of numbers."""


def borrowed(n_own: float, trust: float, noise: float) -> float:
    """Partial pooling: how much of a value is others', the rest is one's own.

        trust * k / (n_own + k)

    where k = noise * trust / (1 - trust) is how many touches of one's own the others'
    value is worth. At trust 0 the own value stands alone, at trust 1 the others' does.

    Args:
        n_own: touches behind the own value, >= 0.
        trust: how far people agree, in [0, 1].
        noise: variance of one touch over the variance of tastes, > 0.

    Source: our choice, after the normal hierarchical model (Gelman & Hill 2007, 12.2):
    with tastes of variance 1, of which people share the part `trust`, one touch with
    variance `noise`, and an unknown taste guessed at trust * others.
    """
    if trust <= 0.0:
        return 0.0
    worth = noise * trust
    if worth <= 0.0:  # Too little for floating point.
        return 0.0
    return trust * worth / (n_own * (1.0 - trust) + worth)


def pooled(
    own: float, n_own: float, others: float, trust: float, noise: float
) -> float:
    """Partial pooling: own experience first, the others' where there is little.

    Args:
        own: value learned in this very state.
        n_own: touches behind it, >= 0.
        others: value learned in all analogous states together.
        trust: how far people agree, in [0, 1].
        noise: variance of one touch over the variance of tastes, > 0.
    """
    return own + borrowed(n_own, trust, noise) * (others - own)

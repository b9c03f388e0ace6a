"""Attention: how people and robots share it out, and to whom they attend."""

from typing import NamedTuple

import numpy as np

from household.compiled.jit import compiled
from household.perception.relations import Entities, Relations


class AttentionModel(NamedTuple):
    """The constants of attention.

    Attributes:
        focus: Width of the gaze's focus [rad].
        distance: At which an entity counts half [m].
        attend_above: Share of the attention from which attending begins.
        attend_below: Share from which it goes on.
    """

    focus: float
    distance: float
    attend_above: float
    attend_below: float


@compiled
def distribute_attention(
    entities: Entities, model: AttentionModel, relations: Relations
) -> None:
    """Works out the attention matrix: which share of its attention each gives to each.

    For observer i and entity j, with mass over distance squared after Maisonnasse
    et al. (2006)::

        a_ij = sees_ij * m_j * exp(-angle_ij^2 / (2 focus^2)) / (1 + (d_ij / d0)^2)
        A_ij = a_ij / (a_i0 + sum_k a_ik)

    where m is the salience, a_i0 the absorption and d0 the model's distance.

    Args:
        entities: Everybody.
        model: The constants.
        relations: Its ``sees`` and ``facing`` are read, its ``attention`` is filled in.
    """
    position, attention = entities.position, relations.attention
    n = len(position)
    for i in range(n):
        total = entities.absorption[i]
        for j in range(n):
            attention[i, j] = 0.0
            if relations.sees[i, j]:
                dx = position[j, 0] - position[i, 0]
                dy = position[j, 1] - position[i, 1]
                near = 1.0 + (dx * dx + dy * dy) / (model.distance * model.distance)
                angle = np.arccos(relations.facing[i, j])
                focused = np.exp(-(angle**2) / (2.0 * model.focus * model.focus))
                attention[i, j] = entities.salience[j] * focused / near
                total += attention[i, j]
        for j in range(n):
            attention[i, j] /= total


@compiled
def attend(model: AttentionModel, now: float, relations: Relations) -> bool:
    """Finds out who attends to whom.

    Attending begins above one share of the attention and ends below a lower one.

    Args:
        model: The constants.
        now: [s].
        relations: Its ``attention`` is read; ``attends`` and ``attention_began`` are
            brought up to date in place.

    Returns:
        Whether anybody attends to others than before.
    """
    attention, attends = relations.attention, relations.attends
    n, changed = len(attention), False
    for i in range(n):
        for j in range(n):
            goes_on = attends[i, j]
            least = model.attend_below if goes_on else model.attend_above
            attends[i, j] = attention[i, j] >= least
            changed |= attends[i, j] != goes_on
            if not attends[i, j]:
                relations.attention_began[i, j] = np.nan
            elif not goes_on:
                relations.attention_began[i, j] = now
    return changed

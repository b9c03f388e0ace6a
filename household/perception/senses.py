"""Senses: everybody's sight, attention and hearing at this moment."""

import numpy as np

from household.compiled.arrays import Floats, Zeros, new_zeros
from household.compiled.jit import bind, compiled
from household.home.floorplan import FloorPlan
from household.perception.attention import AttentionModel, attend, distribute_attention
from household.perception.hearing import Acoustics, attenuate, hear
from household.perception.obstruction import (
    Barriers,
    Obstructions,
    update_obstructions,
)
from household.perception.relations import Entities, Relations
from household.perception.sight import see
from household.scenario.scenario import PerceptionModel
from household.state import Stateful

BATCH = 16
"""Segments that the processor handles at once; those left over are taken one by one."""


class Senses(Stateful):
    """What everybody perceives; people come first and robots after them.

    Args:
        plan: The home.
        model: How well everybody perceives.
        n: How many there are.
        silent: How many of them, from the first on, never make a sound.
        zeros: Makes the arrays that are recorded: ``attention`` and ``attends``.

    Attributes:
        walls: What can stand between two, walls and closed doors, shape (4, m), columns
            of x1, y1, x2, y2 [m]; the last ones may be NaN.
        relations: Who sees, hears and attends to whom; the same arrays from moment to
            moment, with new values in them.
        obstructions: Where everybody is, and what is between; likewise.
    """

    STATE = ("relations", "obstructions")

    def __init__(
        self,
        plan: FloorPlan,
        model: PerceptionModel,
        n: int,
        silent: int = 0,
        zeros: Zeros = new_zeros,
    ) -> None:
        self.walls = _columns(plan.parting_walls)
        self.relations = Relations(
            sees=np.zeros((n, n), np.bool_),
            facing=np.ones((n, n)),
            attention=zeros("attention", (n, n)),
            attends=zeros("attends", (n, n), np.bool_),
            attention_began=np.full((n, n), np.nan),
            loss=np.full((n, n), np.inf),
            level=np.zeros((n, n)),
        )
        self.obstructions = Obstructions(
            position=np.zeros((n, 2)),
            moved=np.zeros(n, np.bool_),
            crossed=np.zeros((n, n), np.int64),
            hidden=np.zeros((n, n), np.bool_),
        )
        attention = AttentionModel(
            focus=float(np.deg2rad(model.focus)),
            distance=model.distance,
            attend_above=model.attend_above,
            attend_below=model.attend_below,
        )
        self._of_home = (
            Barriers(self.walls, _columns(plan.tall_diagonals)),
            Acoustics(model.wall_loss, silent),
            attention,
            self.obstructions,
            self.relations,
        )
        self._entities: Entities | None = None

    def forget(self) -> None:
        """Begins a new episode: nobody has perceived anything yet."""
        self.obstructions.position[:] = np.nan  # Everybody has moved.
        relations = self.relations
        relations.sees[:] = relations.attends[:] = False
        relations.attention[:] = relations.level[:] = 0.0
        relations.attention_began[:] = np.nan

    def perceive(self, entities: Entities, now: float) -> bool:
        """Perceives this moment.

        Args:
            entities: Everybody.
            now: [s].

        Returns:
            Whether anybody attends to others than before.
        """
        if entities is not self._entities:  # Mostly the same, and bound once.
            self._entities = entities
            self._perceive = bind(_perceive, *self._of_home, entities)
        return self._perceive(now)


@compiled
def _perceive(
    barriers: Barriers,
    acoustics: Acoustics,
    model: AttentionModel,
    obstructions: Obstructions,
    relations: Relations,
    entities: Entities,
    now: float,
) -> bool:
    """Sees, attends and hears, all in one call; changes relations in place.

    Returns:
        Whether anybody attends to others than before.
    """
    update_obstructions(obstructions, barriers, entities.position)
    see(entities, obstructions.hidden, relations)
    distribute_attention(entities, model, relations)
    attenuate(obstructions, acoustics, relations.loss)
    hear(entities.source, relations.loss, relations.level)
    return attend(model, now, relations)


def _columns(segments: Floats) -> Floats:
    """Segments as columns, filled up to full batches with NaN, which no line crosses.

    Args:
        segments: Shape (m, 4) [m].

    Returns:
        Shape (4, at least m).
    """
    columns = np.full((4, -(-len(segments) // BATCH) * BATCH), np.nan)
    columns[:, : len(segments)] = segments.T
    return columns

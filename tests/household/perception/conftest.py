import math

import numpy as np
import pytest

from household.perception.relations import Entities
from household.perception.senses import Senses
from household.scenario.scenario import PerceptionModel


@pytest.fixture
def sensing(room):
    """Lets entities perceive one moment; they look east unless it says otherwise."""

    def perceive(position, *, plan=None, senses=None, now=0.0, **changes):
        n = len(position)
        senses = senses or Senses(plan or room(), PerceptionModel(), n)
        usual = {
            "position": np.array(position, dtype=float),
            "gaze": np.zeros(n),
            "half_view": np.full(n, math.radians(60.0)),
            "salience": np.ones(n),
            "absorption": np.full(n, 0.3),
            "source": np.zeros(n),
        }
        arrays = {k: np.array(v, dtype=float) for k, v in changes.items()}
        senses.perceive(Entities(**(usual | arrays)), now)
        return senses.relations

    return perceive

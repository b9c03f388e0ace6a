"""The same seed gives the same network, in whatever process it is trained."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np
import torch


def steady() -> None:
    """Has PyTorch add numbers up in one order only: that of a single thread."""
    torch.set_num_threads(1)
    torch.use_deterministic_algorithms(mode=True)


@contextmanager
def drawn_by(rng: np.random.Generator) -> Iterator[None]:
    """What libraries draw from the generators of the process is drawn from `rng` here.

    Outside of the block these generators are as they were.

    Args:
        rng: Draws one number.
    """
    steady()
    seed = int(rng.integers(2**31))
    before = np.random.get_state()  # noqa: NPY002 - Stable-Baselines3 draws from it
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(seed)
        np.random.seed(seed)  # noqa: NPY002 - as above
        try:
            yield
        finally:
            np.random.set_state(before)  # noqa: NPY002 - as above

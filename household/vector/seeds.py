"""Seeds: one for each home, no two alike."""

from collections.abc import Sequence

import numpy as np

from household.arguments import checked_seed
from household.errors import HouseholdError, shown

NUMBER_BITS = 20
"""Bits of a seed that count the homes, so that no two are alike."""


MOST = 2**63
"""Seeds of homes are below this, as they stand in an array."""


def home_seeds(seed: int | None, homes: int) -> tuple[int, ...]:
    """A seed for each home.

    Args:
        seed: Draws them; None: they come from the system's entropy.
        homes: How many, up to a million.

    Returns:
        Numbers from 0 up, below 2 ** 63, that all differ.

    Raises:
        HouseholdError: If the seed is no whole number from 0 up.
    """
    entropy = np.random.SeedSequence(checked_seed(seed))
    drawn = entropy.generate_state(homes, np.uint64).tolist()
    return tuple(
        (number >> 1 >> NUMBER_BITS << NUMBER_BITS) | home
        for home, number in enumerate(drawn)
    )


def checked_seeds(
    seed: int | Sequence[int] | None, homes: int
) -> tuple[int, ...] | None:
    """What `reset` was handed as seeds of the homes.

    Args:
        seed: One that draws them, or one for each home; None: none.
        homes: How many homes.

    Raises:
        HouseholdError: If it is none of these.
    """
    if seed is None:
        return None
    if isinstance(seed, list | tuple | np.ndarray) and np.ndim(seed) == 1:
        if len(seed) != homes:
            raise HouseholdError(f"{len(seed)} seeds for {homes} homes")
        return tuple(map(_checked, seed))
    return home_seeds(seed, homes)  # type: ignore[arg-type]


def _checked(seed: object) -> int:
    number = checked_seed(seed)
    if number is None or number >= MOST:
        raise HouseholdError(
            f"seed of a home: {shown(seed)}; "
            "allowed: whole numbers from 0 to 2 ** 63 - 1"
        )
    return number

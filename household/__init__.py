"""A simulated household with people, homes and robots, as a PettingZoo environment."""

from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pettingzoo

from household.companions import check_companions

if TYPE_CHECKING:
    from household import vector
    from household.holding import held

__all__ = ["held", "vector"]

__version__ = "0.1.0"

check_companions(Path(__file__).parents[1])

# PettingZoo has a registry since 1.27; a name there costs nothing until it is made.
if hasattr(pettingzoo, "register"):
    for _form, _maker in (("parallel", "parallel_env"), ("aec", "env")):
        pettingzoo.register(
            _form,
            "household/household_v0",
            entry_point=f"household.household_v0:{_maker}",
        )


def __getattr__(name: str) -> Any:  # noqa: ANN401 - whatever has that name
    """What is loaded only when somebody asks for it, as it takes a second."""
    if name == "held":
        return import_module("household.holding").held
    if name == "vector":
        return import_module("household.vector")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

"""A simulated household with people, homes and robots, as a PettingZoo environment."""

import pettingzoo

__version__ = "0.1.0"

# PettingZoo has a registry since 1.27; a name there costs nothing until it is made.
if hasattr(pettingzoo, "register"):
    for _form, _maker in (("parallel", "parallel_env"), ("aec", "env")):
        pettingzoo.register(
            _form,
            "household/household_v0",
            entry_point=f"household.household_v0:{_maker}",
        )

"""`household warm-up`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from household.scenario.scenario import Scenario

STEPS = 40
"""Of each scenario: until everybody walks, meets and is touched."""


@dataclass(frozen=True, kw_only=True)
class WarmUp:
    """Compile what is compiled at first use: half a minute, once per installation."""

    def run(self) -> None:
        """Lives a little in every shipped scenario and in a home of each family."""
        from experiments.commands.terminal import new_console
        from household.compiled.patience import PATIENCE
        from household.config.toml import shipped
        from household.household_v0 import parallel_env
        from household.scenario.family import draw

        console = new_console()
        scenarios: list[str | Scenario] = [*shipped("scenario")]
        scenarios += [draw(name) for name in shipped("family")]
        with console.status("Compiling"):
            for scenario in scenarios:
                for observation in ("features", "situation"):
                    env = parallel_env(scenario, observation)
                    env.reset(seed=1)
                    for step in range(STEPS):
                        env.step(dict.fromkeys(env.agents, step % len(env.behaviors)))
        if PATIENCE.waited:
            console.print(f"Compiled in {PATIENCE.waited:.0f} s.")
        else:
            console.print("Everything was compiled already.")

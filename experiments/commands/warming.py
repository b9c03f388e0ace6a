"""`household warm-up`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from household.scenario.scenario import Scenario

STEPS = 40
"""Of each scenario: until everybody has walked, met others and touched robots."""


@dataclass(frozen=True, kw_only=True)
class WarmUp:
    """Compile what is compiled at first use: half a minute, once per installation."""

    def run(self) -> None:
        """Lives a little in every shipped scenario and in a home of each family."""
        from tempfile import TemporaryDirectory

        from experiments.commands.terminal import new_console
        from household.compiled.patience import PATIENCE
        from household.config.toml import shipped
        from household.household_v0 import parallel_env
        from household.replay import RecordEpisodes
        from household.scenario.family import draw

        console = new_console()
        scenarios: list[str | Scenario] = [*shipped("scenario")]
        scenarios += [draw(name) for name in shipped("family")]
        with console.status("Compiling"), TemporaryDirectory() as folder:
            for scenario in scenarios:
                _live(parallel_env(scenario, "situation", max_cycles=STEPS))
                _live(RecordEpisodes(parallel_env(scenario, max_cycles=STEPS), folder))
        if PATIENCE.waited:
            console.print(f"Compiled in {PATIENCE.waited:.0f} s.")
        else:
            console.print("Everything was compiled already.")


def _live(env: Any) -> None:  # noqa: ANN401 - PettingZoo's wrappers have no types
    """Lives through an episode in which robots do one thing after the other."""
    env.reset(seed=1)
    while env.agents:
        action = env.unwrapped.decision % len(env.behaviors)
        env.step(dict.fromkeys(env.agents, action))
    env.unwrapped.appropriateness("robot_0")  # What evaluations ask.
    env.close()

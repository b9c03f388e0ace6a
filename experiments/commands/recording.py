"""`household record`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from tyro.conf import Positional, arg

from experiments.commands.terminal import new_console
from experiments.errors import ExperimentError

if TYPE_CHECKING:
    from experiments.scoring.batches import Batch
    from household.environment import Household


@dataclass(frozen=True, kw_only=True)
class Record:
    """Record episodes as a Minari data set, to learn from offline."""

    scenario: Annotated[Positional[str], arg(metavar="SCENARIO")]
    """A name from `household scenarios`, a TOML file, or FAMILY:SEED."""

    policy: str = "random"
    """random, constant:BEHAVIOR, LEARNER.json or module:function."""

    episodes: int = 10
    """Episodes to live through."""

    decisions: int | None = None
    """Steps of each episode; as many as the scenario says unless said otherwise."""

    seed: int = 0
    """Seed of the first episode; each further one has the next."""

    name: str = ""
    """What Minari is to call the data set; household/SCENARIO-v0 unless said
    otherwise."""

    out: Path = Path("runs/data")
    """Directory in which Minari finds it, if MINARI_DATASETS_PATH says so."""

    def run(self) -> None:
        """Lives through the episodes, writes the data set and says how to read it."""
        import numpy as np

        from experiments.running.files import make_directory
        from experiments.running.progress import progress
        from experiments.scoring.batches import STORED_IN, lived, write_minari
        from experiments.scoring.policies import specification

        for option, number, least in (
            ("episodes", self.episodes, 1),
            ("seed", self.seed, 0),
        ):
            if number < least:
                raise ExperimentError(
                    f"--{option} must be at least {least}, got {number}."
                )
        asked = specification(self.policy)
        if asked.make is None:
            raise ExperimentError(
                f"policy {self.policy}: a learner has to be trained first, with "
                "`household train`, and then named by its file."
            )
        env = self._home(asked.encoding)
        name = self.name or f"household/{env.scenario.name.replace('_', '-')}-v0"
        make_directory(self.out)
        policy = asked.make(env.behaviors, np.random.default_rng(self.seed))
        console = new_console()
        batches: list[Batch] = []
        with progress(console, "episodes", self.episodes) as advance:
            for episode in range(self.episodes):
                batches += lived(env, policy, self.seed + episode)
                advance()
        write_minari(batches, env, name, self.out, algorithm_name=self.policy)
        steps = sum(len(batch.actions) for batch in batches)
        console.print(
            f"{name}: {len(batches)} episodes of one robot each, {steps} steps. "
            f"To read it: {STORED_IN}={self.out} and "
            f"minari.load_dataset({name!r}).",
            soft_wrap=True,
            highlight=False,
        )

    def _home(self, encoding: str) -> Household:
        from household import household_v0
        from household.config.toml import shipped
        from household.scenario.family import draw

        family, _, seed = self.scenario.rpartition(":")
        drawn = family in shipped("family") and seed.isdigit()
        overrides: dict[str, Any] = {}
        if self.decisions is not None:
            overrides["max_cycles"] = self.decisions
        return household_v0.parallel_env(
            draw(family, int(seed)) if drawn else self.scenario,
            observation=encoding,
            **overrides,
        )

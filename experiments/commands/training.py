"""`household train`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from tyro.conf import Positional, arg

from experiments.commands.terminal import new_console
from experiments.errors import ExperimentError

if TYPE_CHECKING:
    import polars
    from rich.console import Console

    from experiments.running.study import Trial


@dataclass(frozen=True, kw_only=True)
class Train:
    """Let robots learn in one household, and keep what they learned."""

    scenario: Annotated[Positional[str], arg(metavar="SCENARIO")]
    """A name from `household scenarios`, or a TOML file."""

    learner: str = "q_social"
    """How the robots learn, a name from the learners' catalog."""

    decisions: int = 1_000
    """Steps of the environment."""

    seed: int = 0
    """Seed of the people's lives and of the robots' choices."""

    out: Path = Path("runs/train")
    """Directory for what was learned, the table of the trial and the replay."""

    watch: bool = False
    """Open the Rerun viewer and show the episode while it goes on."""

    def run(self) -> None:
        """Runs one episode and stores what came of it."""
        from experiments.running.store import make_directory
        from experiments.running.trial import describe_condition

        trial = self._trial()
        describe_condition(trial.condition)  # refuses a wrong condition
        make_directory(self.out)
        self._live(new_console(), trial)

    def _trial(self) -> Trial:
        from experiments.running.study import Condition, Trial

        if self.decisions < 1:
            raise ExperimentError(f"--decisions must be at least 1: {self.decisions}.")
        if self.seed < 0:
            raise ExperimentError(f"--seed must be 0 or larger, got {self.seed}.")
        condition = Condition(
            name="train",
            scenario=self.scenario,
            learner=self.learner,
            scenario_overrides={"max_cycles": self.decisions},
        )
        return Trial(condition=condition, seed=self.seed)

    def _live(self, console: Console, trial: Trial) -> None:
        from experiments.running.progress import Steps, progress
        from experiments.running.store import write_whole
        from experiments.running.trial import play
        from experiments.running.trial_table import TrialTable
        from policies.recording import RecordingObserver

        table = TrialTable()
        replay = RecordingObserver(self.out / "replay.rrd", watch=self.watch)
        with progress(console, "decisions", self.decisions) as advance:
            robots = play(trial, [table, replay, Steps(advance)])
        write_whole(self.out / "trial.parquet", table.frame().write_parquet)
        for agent, robot in robots.items():
            robot.learner.save(self.out / f"{agent}.json")
        self._tell(console, table.frame())

    def _tell(self, console: Console, frame: polars.DataFrame) -> None:
        """Says how it went and where everything lies."""
        from experiments.analysis.measures import final_reward, touches

        values = touches(frame)["value"]
        console.print(
            f"{len(frame)} history entries, {(values > 0).sum()} caresses, "
            f"{(values < 0).sum()} taps, cumulative reward {final_reward(frame):.1f}."
        )
        console.print(f"replay: household replay {self.out / 'replay.rrd'}")
        console.print(f"learners: {self.out}/robot_*.json")
        console.print(f"table of the trial: {self.out / 'trial.parquet'}")

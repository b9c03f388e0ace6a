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


SPACE, SPACE_PER_BEING = 1e6, 300
"""What a replay takes in any case, and what replay, learners and table take together
for each person and robot in each decision [bytes]; `evening` takes 220, `party` 240."""


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
        from experiments.running.files import ask_for_space, remove_remains
        from experiments.running.lock import alone_in
        from experiments.running.trial import describe_condition, make_home

        trial = self._trial()
        describe_condition(trial.condition)  # refuses a wrong condition
        scenario = make_home(trial.condition).scenario
        beings = len(scenario.people) + len(scenario.robots)
        with alone_in(self.out):
            remove_remains(self.out)
            need = SPACE + SPACE_PER_BEING * beings * self.decisions
            ask_for_space(self.out, need, f"{self.decisions} decisions")
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
        from experiments.running.keeping import Keeper
        from experiments.running.progress import Steps, progress
        from experiments.running.trial import play
        from experiments.running.trial_table import TrialTable
        from household.errors import HouseholdError
        from policies.recording import RecordingObserver

        table, replay = TrialTable(), self.out / "replay.rrd"
        keeper = Keeper(table, self.out, replay)
        recorder = RecordingObserver(replay, watch=self.watch)
        try:
            with progress(console, "decisions", self.decisions) as advance:
                play(trial, [table, keeper, recorder, Steps(advance)])
        except HouseholdError as error:
            if not keeper.done:
                raise
            raise ExperimentError(
                f"{error}. What was learned is stored in {self.out}."
            ) from error
        self._tell(console, table.frame())

    def _tell(self, console: Console, frame: polars.DataFrame) -> None:
        """Says how it went and where everything lies."""
        from experiments.analysis.measures import final_reward, touches

        values = touches(frame)["value"]
        console.print(
            f"{len(frame)} history entries, {(values > 0).sum()} caresses, "
            f"{(values < 0).sum()} taps, cumulative reward {final_reward(frame):.1f}."
        )
        for line in (
            f"replay: household replay {self.out / 'replay.rrd'}",
            f"learners: {self.out}/robot_*.json",
            f"table of the trial: {self.out / 'trial.parquet'}",
        ):
            console.print(line, soft_wrap=True)

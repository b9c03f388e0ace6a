"""The wrapper that records every episode of an environment."""

from pathlib import Path
from typing import Any

from pettingzoo import ParallelEnv
from pettingzoo.utils.wrappers import BaseParallelWrapper

from household.environment import Household
from household.errors import HouseholdError
from household.replay.buffer import FLUSH_EVERY
from household.replay.recorder import Recorder


class RecordEpisodes(BaseParallelWrapper[str, Any, int]):
    """Writes each episode of a household as a replay file of its own.

    Args:
        env: A parallel household, also inside other wrappers.
        folder: Where ``episode_00000.rrd`` and so on are written.
        watch: Whether to show the running episode in the viewer; or the address of the
            viewer to show it in.
        flush_every: Decisions between writes; a killed process loses no more.

    Raises:
        HouseholdError: If it is not a parallel household.
    """

    def __init__(
        self,
        env: Any,  # noqa: ANN401 - PettingZoo's wrappers have no type information
        folder: Path | str,
        *,
        watch: bool | str = False,
        flush_every: int = FLUSH_EVERY,
    ) -> None:
        home = isinstance(env.unwrapped, Household)
        if not (home and isinstance(env, ParallelEnv)):
            raise HouseholdError(
                "RecordEpisodes records parallel households; make a turn-based one "
                "from what it returns"
            )
        super().__init__(env)
        self._folder, self._watch, self._flush_every = Path(folder), watch, flush_every
        self._episode = 0
        self._recorder: Recorder | None = None

    def reset(
        self, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> Any:  # noqa: ANN401 - PettingZoo's tuple
        """Begins an episode and its file; an unfinished one is closed."""
        self._finish()
        result = super().reset(seed=seed, options=options)
        self._recorder = Recorder(
            self.unwrapped.simulation,
            self._folder / f"episode_{self._episode:05d}.rrd",
            watch=self._watch,
            flush_every=self._flush_every,
        )
        self._episode += 1
        return result

    def step(self, actions: dict[str, int]) -> Any:  # noqa: ANN401
        """Makes a step and records it; the last one closes the file."""
        env, recorder = self.env, self._recorder
        result = env.step(actions)
        if recorder is not None:
            recorder.record()
            if not env.agents:
                self._finish()
        return result

    def wait(self) -> None:
        """Waits for Rerun, which writes while the episode goes on."""
        if self._recorder is not None:
            self._recorder.wait()

    def close(self) -> None:
        """Closes the file and the environment."""
        self._finish()
        super().close()

    def _finish(self) -> None:
        if self._recorder is not None:
            self._recorder.close()
            self._recorder = None

"""The vector environment: every robot of every home is a slot."""

from collections.abc import Callable, Iterable, Sequence
from functools import partial
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from gymnasium import spaces
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray

from household.arguments import checked_count
from household.compiled.arrays import Floats, Integers, Mask, Singles
from household.errors import HouseholdError, shown
from household.household_v0 import make_minds as usual_minds
from household.observation.encodings import Features
from household.observation.frame import common_frame
from household.people.people import MakeMinds
from household.scenario.scenario import Scenario
from household.scenario.validation import load_scenario
from household.vector.buffers import GO_ON, Size, Told, buffers_in
from household.vector.homes import Plan, Share
from household.vector.seeds import checked_seeds, home_seeds
from household.vector.worker import BEGIN, STEP
from household.vector.workers import Workers

AnyScenario = str | Path | Scenario
Keep = Callable[[], NDArray[Any]]
"""Hands out one of the buffers."""

Results = tuple[Singles, Floats, Mask, Mask, dict[str, Any]]
"""Observations, rewards, terminations, truncations and infos, by slot."""


def make(
    scenario: AnyScenario | Sequence[AnyScenario],
    homes: int | None = None,
    workers: int = 0,
    seed: int | None = None,
    *,
    make_minds: MakeMinds = usual_minds,
    copy: bool = True,
    **overrides: Any,  # noqa: ANN401 - checked against the scenario's fields
) -> "VectorHousehold":
    """Many homes as one Gymnasium vector environment, in which every robot is a slot.

    Args:
        scenario: A built-in name, a path to a TOML file, or a scenario; or several, one
            for each home, also of different families.
        homes: How many homes; if there are more of them than scenarios, these are taken
            in turn. None: as many as scenarios.
        workers: Processes that step homes beside this one, which steps as many.
        seed: Draws the seeds of the homes.
        make_minds: Gives the people their minds.
        copy: Whether what `step` and `reset` return is the caller's to keep. If not, it
            is overwritten by the next step.
        **overrides: Top-level fields to replace in all scenarios.

    Raises:
        HouseholdError: If an argument cannot be used.
    """
    several = [scenario] if isinstance(scenario, str | Path | Scenario) else scenario
    if not several:
        raise HouseholdError("scenario: none; allowed: one or more")
    n = checked_count("homes", len(several) if homes is None else homes, 1)
    workers = checked_count("workers", workers, 0)
    loaded = [load_scenario(each, **overrides) for each in several[:n]]
    scenarios = tuple(loaded[home % len(loaded)] for home in range(n))
    plan = Plan(scenarios, make_minds, common_frame(scenarios))
    return VectorHousehold(plan, workers=workers, seed=seed, copy=copy)


class VectorHousehold(VectorEnv[Singles, Integers, NDArray[Any]]):
    """Many homes at once; see `make`.

    A home whose episode is over begins the next one in the same step: observations and
    infos are already of the new episode, and those of its end are in
    ``infos["final_obs"]`` and ``infos["final_info"]``. Nobody is ever terminated; the
    robots of a home are truncated together.

    A home lives through the same history as `household_v0.parallel_env` with its
    scenario and its seed. If homes differ in size, observations have room for the
    largest, and the rest of them is 0. If robots of some homes can do what those of
    others cannot, actions are numbered through: see `behaviors` and
    ``infos["action_mask"]``; who cannot do what it is told goes on with what it does.

    Attributes:
        behaviors: What the actions mean, in order.
        layout: Name of each field to its slice of an observation.
        scenarios: Of each home.
        home: Index of the home of each slot, shape (num_envs,).
        agents: Name of the robot in each slot, unique in its home.
        seeds: With which the homes' present histories began.
    """

    metadata: ClassVar[dict[str, Any]] = {  # type: ignore[misc]
        "name": "household_v0",
        "render_modes": [],
        "autoreset_mode": AutoresetMode.SAME_STEP,
    }
    autoreset_mode = AutoresetMode.SAME_STEP
    """As Gymnasium's own vector environments have it, and TorchRL asks for."""

    def __init__(
        self, plan: Plan, *, workers: int, seed: int | None, copy: bool
    ) -> None:
        n_homes = len(plan.scenarios)
        self.seeds = home_seeds(seed, n_homes)
        self.scenarios, self.behaviors = plan.scenarios, plan.frame.behaviors
        of_homes = [scenario.robot_names for scenario in plan.scenarios]
        self.agents = tuple(name for names in of_homes for name in names)
        self.home = np.repeat(np.arange(n_homes), [len(names) for names in of_homes])
        self.num_envs = len(self.agents)
        features = Features(plan.scenarios[0], plan.frame)
        self.layout = features.layout
        self.single_observation_space = features.space
        self.single_action_space = spaces.Discrete(len(self.behaviors))
        self.observation_space = batch_space(features.space, self.num_envs)
        self.action_space = batch_space(self.single_action_space, self.num_envs)
        self._begun = False
        self._shape, self._possible = (self.num_envs,), set(range(len(self.behaviors)))
        length = features.space.shape[0]
        mine, *others = _shares(n_homes, workers)
        n_actions = len(self.behaviors)
        self._alone = not others
        size = Size(n_homes, self.num_envs, length, n_actions, len(others))
        self._workers = Workers(size)
        self._buffers = buffers = buffers_in(self._workers.record)
        # Found once: at a single home, looking them up takes as long as copying them.
        now, rewards, truncations = buffers.now, buffers.rewards, buffers.truncations
        told = _hand_out((now.observations, *now.notices), copy=copy)
        results = _hand_out((rewards, truncations), copy=copy)
        # Always copies: no step writes these anew.
        nobody = np.zeros(self.num_envs, np.bool_)
        self._told = [*told, (~nobody).copy]
        self._results = [*results, nobody.copy, *self._told]
        try:
            # First here: what is compiled for that, the others find on disk.
            self._mine = Share(plan, mine, self._buffers)
            self._workers.hand_out(plan, others)
        except BaseException:
            self.close()
            raise

    def reset(
        self,
        *,
        seed: int | Sequence[int] | None = None,
        options: dict[str, Any] | None = None,
    ) -> tuple[Singles, dict[str, Any]]:
        """Begins an episode in all homes.

        Args:
            seed: Draws a seed for each home, or gives it. None: the homes go on with
                their histories, or begin those of the seed with which this was made.
            options: Must be empty.

        Returns:
            Observations, shape (num_envs, length), and infos.

        Raises:
            HouseholdError: If there are options or the seeds cannot be used.
        """
        if options:
            raise HouseholdError(f"options: {shown(options)}; allowed: none")
        seeds = checked_seeds(seed, len(self.scenarios))
        if seeds is None and not self._begun:
            seeds = self.seeds
        if seeds is not None:
            self.seeds = seeds
        self._buffers.seeds[:] = GO_ON if seeds is None else seeds
        self._together(BEGIN)
        self._begun = True
        observations, *notices, everybody = [kept() for kept in self._told]
        return observations, _infos(notices, everybody)

    def step(self, actions: NDArray[Any]) -> Results:
        """Lets one decision period pass in all homes.

        An action that repeats what a robot does goes on with it until it is over, and
        another one interrupts it. What may be chosen without an interruption is in
        ``infos["action_mask"]``.

        Args:
            actions: Of each slot, shape (num_envs,).

        Returns:
            Observations, shape (num_envs, length); rewards, terminations and
            truncations, shape (num_envs,); and infos: the fields of
            `household.observation.notices.Notices`, each with a mask.

        Raises:
            HouseholdError: Before the first reset, after `close`, or if actions are
                none.
            WorkerError: If a worker failed; all are ended then.
        """
        if not self._begun:
            raise HouseholdError("nobody is at home yet: call reset() first")
        self._buffers.actions[:] = self._checked(actions)
        self._together(STEP)
        kept = [hand_out() for hand_out in self._results]
        rewards, truncations, nobody, observations, *notices, everybody = kept
        infos = _infos(notices, everybody)
        if True in truncations.tolist():
            infos |= _final(self._buffers.final, truncations.copy())
        return observations, rewards, nobody, truncations, infos

    def close_extras(self, **_kwargs: object) -> None:
        """Ends the workers."""
        self._workers.end()

    def _together(self, word: bytes) -> None:
        """All processes do something at the same time."""
        if self.closed:
            raise HouseholdError("these homes are closed")
        mine = self._mine.step if word == STEP else self._mine.begin
        try:
            if self._alone:
                mine()
                return
            self._workers.set_to(word)
            mine()
            self._workers.wait(self._mine.chores())
        except BaseException:  # Ctrl-C, too: homes are no longer at the same moment.
            self.close()
            raise

    def _checked(self, actions: object) -> Integers:
        chosen = np.asarray(actions)
        if chosen.shape != self._shape or chosen.dtype.kind not in "iu":
            raise HouseholdError(
                f"actions: {chosen.dtype} of shape {chosen.shape}; "
                f"allowed: whole numbers of shape {self._shape}"
            )
        listed = chosen.tolist()
        if not self._possible.issuperset(listed):
            slot = next(i for i, one in enumerate(listed) if one not in self._possible)
            raise HouseholdError(
                f"slot {slot}: action {listed[slot]} is none of the behaviors; "
                f"allowed: 0 to {len(self._possible) - 1}"
            )
        return chosen

    def __getstate__(self) -> dict[str, Any]:
        """Is asked by `copy` and pickle.

        Raises:
            HouseholdError: Always; homes share memory with each other and with workers.
        """
        raise HouseholdError(
            "a vector environment cannot be copied or pickled; "
            "household_v0.parallel_env can, in mid-episode"
        )

    def __repr__(self) -> str:
        kinds = dict.fromkeys(scenario.name for scenario in self.scenarios)
        named = ", ".join(kinds) if len(kinds) <= 3 else f"{len(kinds)} households"
        homes, robots = len(self.scenarios), self.num_envs
        return f"VectorHousehold({named}: {homes} homes, {robots} robots)"


def _shares(homes: int, workers: int) -> list[list[int]]:
    """The homes of this process and of each worker, as many in each, none empty.

    Where they do not share out evenly this process has fewer: it does all else, too.
    """
    parts = np.array_split(np.arange(homes), min(workers + 1, homes))
    return [part.tolist() for part in reversed(parts)]


def _hand_out(buffers: Iterable[NDArray[Any]], *, copy: bool) -> list[Keep]:
    """What hands out each of some buffers, as a copy or as it is."""
    return [each.copy if copy else partial(np.asarray, each) for each in buffers]


def _infos(notices: Iterable[NDArray[Any]], whose: Mask) -> dict[str, Any]:
    """Infos as Gymnasium has them: an array for each key, and whose it is.

    Written out: that takes a quarter of the time, and is done in every step.
    """
    caresses, taps, behavior_over, attended, action_mask = notices
    return {
        "caresses": caresses,
        "_caresses": whose,
        "taps": taps,
        "_taps": whose,
        "behavior_over": behavior_over,
        "_behavior_over": whose,
        "attended": attended,
        "_attended": whose,
        "action_mask": action_mask,
        "_action_mask": whose,
    }


def _final(told: Told, over: Mask) -> dict[str, Any]:
    """Observations and infos of the episodes that are over."""
    observations = np.full(len(over), None, dtype=object)
    for slot in np.flatnonzero(over):
        observations[slot] = told.observations[slot].copy()

    def of_those(array: NDArray[Any]) -> NDArray[Any]:
        final = np.zeros_like(array)
        final[over] = array[over]
        return final

    return {
        "final_obs": observations,
        "_final_obs": over,
        "final_info": _infos(map(of_those, told.notices), over.copy()),
        "_final_info": over,
    }

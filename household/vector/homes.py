"""The homes of a vector environment, and the share of them that one process steps."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from household.observation.encodings import Features
from household.observation.frame import Frame
from household.observation.notices import Notifier
from household.people.people import MakeMinds
from household.scenario.scenario import Scenario
from household.simulation.simulation import PHASES, Simulation
from household.vector.buffers import GO_ON, Buffers, Told


class Plan(NamedTuple):
    """What a vector environment consists of.

    Attributes:
        scenarios: Of each home.
        make_minds: Gives the people their minds.
        frame: What observations have room for, the same for all homes.
    """

    scenarios: tuple[Scenario, ...]
    make_minds: MakeMinds
    frame: Frame

    def slots(self, home: int) -> slice:
        """Where the robots of a home stand."""
        first = sum(len(scenario.robots) for scenario in self.scenarios[:home])
        return slice(first, first + len(self.scenarios[home].robots))


class Home:
    """One home, which reads its actions from buffers and writes into them.

    Args:
        scenario: Who lives there.
        plan: What it is a part of.
        slots: Where its robots stand.
        buffers: Of all homes.
    """

    def __init__(
        self, scenario: Scenario, plan: Plan, slots: slice, buffers: Buffers
    ) -> None:
        self.simulation = Simulation(scenario, plan.make_minds)
        self._last = scenario.max_cycles
        self._features = Features(scenario, plan.frame)
        self._notifier = Notifier(scenario, plan.frame)
        # Behaviors by action; None where both are numbered alike.
        self._own: list[int | None] | None = None
        if scenario.behaviors != plan.frame.behaviors:
            own = {name: behavior for behavior, name in enumerate(scenario.behaviors)}
            self._own = [own.get(name) for name in plan.frame.behaviors]
        self.slots = slots
        self._now, self._final = buffers.now.of(slots), buffers.final.of(slots)
        self._rewards = buffers.rewards[slots]
        self._truncations = buffers.truncations[slots]

    def begin(self, seed: int | None) -> None:
        """Begins an episode.

        Args:
            seed: Begins a history of its own; None goes on with the present one.
        """
        self.simulation.begin(seed)
        self._tell(self._now)

    def choose(self, actions: Sequence[int]) -> None:
        """Its robots begin what they are told to.

        Args:
            actions: Of all slots.
        """
        own = self._own
        if own is None:
            self.simulation.choose(enumerate(actions[self.slots]))
            return
        self.simulation.choose(
            [
                (robot, behavior)
                for robot, action in enumerate(actions[self.slots])
                # Who cannot do what only robots elsewhere can goes on as before.
                if (behavior := own[action]) is not None
            ]
        )

    def tell(self) -> None:
        """Tells what came of a step; after the last one, begins the next episode.

        Rewards and truncations hold zeros before.
        """
        simulation = self.simulation
        if simulation.robots.touched:
            self._rewards[:] = simulation.robots.rewards
        if simulation.decision >= self._last:
            self._truncations[:] = True
            self._tell(self._final)
            simulation.begin(None)
        self._tell(self._now)

    def _tell(self, told: Told) -> None:
        simulation = self.simulation
        self._features.write(told.observations, simulation.view)
        self._notifier.write(told.notices, simulation.robots, simulation.view)


class Share:
    """The homes that one process steps.

    Args:
        plan: What there is.
        which: The homes of this share.
        buffers: Of all homes.
    """

    def __init__(self, plan: Plan, which: Sequence[int], buffers: Buffers) -> None:
        self._seeds = buffers.seeds[which[0] : which[-1] + 1]
        self._homes = [
            Home(plan.scenarios[home], plan, plan.slots(home), buffers)
            for home in which
        ]
        self._actions = buffers.actions
        slots = slice(self._homes[0].slots.start, self._homes[-1].slots.stop)
        self._rewards, self._truncations = (
            buffers.rewards[slots],
            buffers.truncations[slots],
        )
        simulations = [home.simulation for home in self._homes]
        self._phases = [[getattr(s, phase) for s in simulations] for phase in PHASES]

    def begin(self) -> None:
        """Begins an episode in each home, with the seeds in the buffers."""
        self._clear()
        for home, seed in zip(self._homes, self._seeds.tolist(), strict=True):
            home.begin(None if seed == GO_ON else seed)

    def step(self) -> None:
        """Lets one decision period pass in all homes, phase by phase."""
        self._clear()
        actions = self._actions.tolist()
        for home in self._homes:
            home.choose(actions)
        for phase in self._phases:
            for let_pass in phase:
                let_pass()
        for home in self._homes:
            home.tell()

    def chores(self) -> Iterator[None]:
        """Does what later steps will need, a few microseconds' worth at a time.

        The homes take turns, so that none gets all the time there is.
        """
        pending = [home.simulation.prepare for home in self._homes]
        while pending:
            for prepare in pending.copy():
                if prepare():
                    yield
                else:
                    pending.remove(prepare)

    def _clear(self) -> None:
        self._rewards.fill(0.0)
        self._truncations.fill(False)

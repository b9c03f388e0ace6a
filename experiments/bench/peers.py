"""Peers: other simulators of several moving agents, where they are installed.

Each moves as many agents as we do, without rendering, by its usual means.
"""

from __future__ import annotations

import contextlib
import io
import os
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

PERIOD = 0.1
"""What a step of every peer simulates [s]."""

IR_SIM_WORLD = """
world: {{height: 10, width: 10, step_time: {period}}}
robot:
  - number: {n}
    distribution: {{name: circle, radius: 4.0, center: [5, 5]}}
    kinematics: {{name: diff}}
    shape: {{name: circle, radius: 0.2}}
    behavior: {{name: dash}}
"""


@dataclass(frozen=True, kw_only=True)
class Peer:
    """Another simulator, ready to step."""

    name: str
    """Its package, and which of its worlds."""

    step: Callable[[], object]
    """Makes a step of all agents."""

    period: float = PERIOD
    """What a step simulates [s]."""


def installed(n: int) -> Iterator[Peer]:
    """Yields the peers that can be imported, each with n agents."""
    for make in (_mpe2, _ir_sim, _jupedsim):
        with contextlib.suppress(ImportError):
            yield make(n)


def _mpe2(n: int) -> Peer:
    from mpe2 import simple_spread_v3

    from experiments.bench.homes import FOREVER, Stepping

    env = simple_spread_v3.parallel_env(N=n, max_cycles=FOREVER)
    return Peer(name="mpe2 simple_spread_v3", step=Stepping(env))


def _ir_sim(n: int) -> Peer:
    os.environ.setdefault("MPLBACKEND", "Agg")
    with contextlib.redirect_stdout(io.StringIO()):  # it complains of missing screens
        import irsim
    with TemporaryDirectory() as folder:
        world = Path(folder) / "world.yaml"
        world.write_text(IR_SIM_WORLD.format(n=n, period=PERIOD), encoding="utf-8")
        env = irsim.make(
            str(world), disable_all_plot=True, display=False, log_level="ERROR"
        )
    return Peer(name="ir-sim", step=env.step)


def _jupedsim(n: int) -> Peer:
    import jupedsim as jps

    simulation = jps.Simulation(
        model=jps.CollisionFreeSpeedModel(),
        geometry=[(0, 0), (10, 0), (10, 10), (0, 10)],
        dt=PERIOD,
    )
    # There and back again, so that nobody ever arrives for good.
    ends = [simulation.add_waypoint_stage(spot, 0.5) for spot in ((8, 8), (2, 2))]
    journey = jps.JourneyDescription(ends)
    for here, there in (ends, ends[::-1]):
        journey.set_transition_for_stage(
            here, jps.Transition.create_fixed_transition(there)
        )
    number = simulation.add_journey(journey)
    for i in range(n):
        simulation.add_agent(
            jps.CollisionFreeSpeedModelAgentParameters(
                journey_id=number,
                stage_id=ends[0],
                position=(0.5 + 9.0 * i / n, 2.0 + 0.1 * i),
            )
        )
    return Peer(name="JuPedSim", step=simulation.iterate)

"""Checkpoints: the whole state of a household, to go on from as often as one likes."""

import pickle
from dataclasses import dataclass
from hashlib import sha256

import msgspec

from household.errors import HouseholdError
from household.scenario.scenario import Scenario
from household.simulation.simulation import Simulation
from household.state import put_back, state_of


@dataclass(frozen=True, slots=True)
class Checkpoint:
    """A moment of a household; pickles, also for other processes.

    Like all that was pickled, it is to be read from trusted sources only.

    Attributes:
        scenario: Fingerprint of the scenario that it belongs to.
        agents: Who has not left yet.
        state: All that changes, pickled at once, so that what was one object stays one.
    """

    scenario: str
    agents: tuple[str, ...]
    state: bytes


def take(simulation: Simulation, agents: tuple[str, ...]) -> Checkpoint:
    """Takes a checkpoint; nothing changes by that.

    Raises:
        HouseholdError: If the people's minds cannot be pickled.
    """
    now = state_of(simulation)
    try:
        state = pickle.dumps(now, protocol=5)
    except (pickle.PicklingError, TypeError, AttributeError) as error:
        raise HouseholdError(f"these minds cannot be pickled: {error}") from error
    return Checkpoint(fingerprint(simulation.scenario), agents, state)


def restore(simulation: Simulation, checkpoint: Checkpoint) -> None:
    """Puts everything back as it was.

    Raises:
        HouseholdError: If the checkpoint belongs to another scenario.
    """
    if checkpoint.scenario != fingerprint(simulation.scenario):
        raise HouseholdError("this checkpoint belongs to another scenario")
    if not simulation.begun:
        simulation.begin(seed=0)
    put_back(simulation, pickle.loads(checkpoint.state))
    # Follows from the time, and is not kept.
    simulation.people.preferences.hold_at(simulation.time)
    # Whoever remembers what was true of a revision must not meet it again.
    simulation.revision += 1


def fingerprint(scenario: Scenario) -> str:
    """Tells scenarios apart by all that they say."""
    return sha256(msgspec.json.encode(scenario)).hexdigest()

"""The simulation: everything that exists and moves, from one moment to the next."""

from household.simulation.simulation import Simulation

__all__ = ["Simulation"]

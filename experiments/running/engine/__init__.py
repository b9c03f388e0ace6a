"""Runs trials on local processes, Dask or Ray, through one seam: an `Executor`."""

from experiments.running.engine.driver import Outcome, run_trials
from experiments.running.engine.engines import Engine, open_engine
from experiments.running.engine.interrupts import ctrl_c_held_back, result_of

__all__ = [
    "Engine",
    "Outcome",
    "ctrl_c_held_back",
    "open_engine",
    "result_of",
    "run_trials",
]

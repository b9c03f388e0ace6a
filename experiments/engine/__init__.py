"""Runs trials on local processes, Dask or Ray, through one seam: an `Executor`."""

from experiments.engine.driver import Outcome, run_trials
from experiments.engine.engines import Engine, open_engine

__all__ = ["Engine", "Outcome", "open_engine", "run_trials"]

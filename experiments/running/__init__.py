"""Running trials: what is run, how, by whom, and where its table is kept."""

from experiments.running.study import Condition, Study, Trial
from experiments.running.trial import run_trial

__all__ = ["Condition", "Study", "Trial", "run_trial"]

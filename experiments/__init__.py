"""The paper's experiments, studies, scores, statistics, figures, report, commands."""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from experiments.running.jobs import run_study
    from experiments.running.study import Condition, Study
    from experiments.running.trial import run_trial
    from experiments.scoring.evaluate import evaluate

__all__ = ["Condition", "Study", "evaluate", "run_study", "run_trial"]

_WHERE = {
    "Condition": "experiments.running.study",
    "Study": "experiments.running.study",
    "evaluate": "experiments.scoring.evaluate",
    "run_study": "experiments.running.jobs",
    "run_trial": "experiments.running.trial",
}


def __getattr__(name: str) -> object:
    """Imports what users enter by only when it is asked for: `--help` stays quick."""
    if name in _WHERE:
        return getattr(import_module(_WHERE[name]), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

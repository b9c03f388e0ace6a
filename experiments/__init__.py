"""The paper's experiments, studies, scores, statistics, figures, report, commands."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from experiments.scoring.evaluate import evaluate

__all__ = ["evaluate"]


def __getattr__(name: str) -> object:
    """Imports what users enter by only when it is asked for: `--help` stays quick."""
    if name == "evaluate":
        from experiments.scoring.evaluate import evaluate

        return evaluate
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

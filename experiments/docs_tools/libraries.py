"""The page docs/libraries.md: what four training libraries learn in the same homes.

For each example, in an environment that has its library, with the folder of examples:

    python -m experiments.docs_tools.libraries learn examples/ppo.py 400000 DATA

trains and evaluates, and writes DATA/ppo.json. Then

    python -m experiments.docs_tools.libraries page DATA DOCS

draws the learning curves and writes the page.
"""

from __future__ import annotations

import json
import runpy
import sys
import time
from collections.abc import Mapping, Sequence
from importlib import metadata
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from experiments.docs_tools.pages import render

if TYPE_CHECKING:
    from matplotlib.axes import Axes

EXAMPLES: Mapping[str, str] = {
    "ppo": "one file, PyTorch alone",
    "stable_baselines3_ppo": "Stable-Baselines3",
    "torchrl_ppo": "TorchRL",
    "rllib_ppo": "Ray RLlib",
}
"""Name of an example -> what it trains with."""

REFERENCES = ("random", "best constant", "population", "persona", "lookahead")

FAMILY, HOUSEHOLDS = "quiet_work", 8
"""What is trained in, and how many other homes of it are evaluated in."""

PACKAGES = ("torch", "stable-baselines3", "sb3-contrib", "torchrl", "ray", "gymnasium")

SMOOTHED = 5.0
"""Width of the window that curves are averaged over [robot-hours]."""


def learned(example: Path, steps: int) -> dict[str, Any]:
    """Trains an example and evaluates what it learned in homes that it never saw.

    Args:
        example: The file; its `train` takes steps and returns a policy and a curve.
        steps: As the example counts them.

    Returns:
        Plain data: the curve, the scores, and how long it took.
    """
    from experiments import evaluate
    from experiments.running.files import to_json

    train = runpy.run_path(str(example))["train"]
    begin = time.perf_counter()
    policy, curve = train(steps)
    took = time.perf_counter() - begin
    evaluation = evaluate(policy, FAMILY, HOUSEHOLDS)
    return {
        "format": 1,
        "example": example.stem,
        "steps": steps,
        "seconds": round(took, 1),
        "versions": _versions(),
        "curve": [[round(float(h), 4), round(float(r), 4)] for h, r in curve],
        "family": json.loads(to_json(evaluation.families[0])),
    }


def _versions() -> dict[str, str]:
    found = {}
    for name in PACKAGES:
        try:
            found[name] = metadata.version(name)
        except metadata.PackageNotFoundError:
            continue
    return found


def page(documents: Sequence[Mapping[str, Any]]) -> str:
    """Returns the page.

    Args:
        documents: Of each example, in the order of `EXAMPLES`.
    """
    family = documents[0]["family"]
    best = f"always {family['best_constant']}"
    constants = [name for name in family["scores"] if name.startswith("constant:")]
    dearest = max(
        constants, key=lambda n: family["scores"][n]["reward_per_minute"]["value"]
    )
    liked = dearest.partition(":")[2]
    return render(
        "libraries.md.j2",
        documents=documents,
        demand=family["demand"],
        names=EXAMPLES,
        scores=family["scores"],
        references=[
            *((n, best if n == "best constant" else n) for n in REFERENCES),
            (dearest, f"always {liked}"),
        ],
        liked=liked,
        dearest=family["scores"][dearest],
        households=HOUSEHOLDS,
        hours={one["example"]: one["curve"][-1][0] for one in documents},
    )


def draw_curves(documents: Sequence[Mapping[str, Any]], stem: Path) -> None:
    """Draws the learning curves of all examples as SVG.

    Args:
        documents: As for `page`.
        stem: Path of the picture without its suffix.
    """
    from experiments.figures.canvas import DASHES, PALETTE, Column, Panel, save

    def draw(axes: Axes) -> None:
        for one, color, dash in zip(documents, PALETTE, DASHES, strict=True):
            hours, rewards = smoothed(one["curve"])
            label = EXAMPLES[one["example"]]
            axes.plot(hours, rewards, color=color, linestyle=dash, label=label)
        axes.legend(loc="lower right")

    panel = Panel(label="reward a minute", draw=draw, height=3.2)
    column = Column(
        title="PPO in sixteen homes", panels=(panel,), across="robot-hours lived"
    )
    save((column,), stem, kinds=(".svg",))


def smoothed(curve: Sequence[Sequence[float]]) -> tuple[list[float], list[float]]:
    """Averages a learning curve over the last hours up to each of its points.

    Args:
        curve: Robot-hours and rewards.

    Returns:
        The hours and the averages.
    """
    hours, rewards = np.array(curve).T
    windows = [(hours > end - SMOOTHED) & (hours <= end) for end in hours]
    return hours.tolist(), [float(rewards[window].mean()) for window in windows]


if __name__ == "__main__":
    task, *words = sys.argv[1:]
    if task == "learn":
        file, data = Path(words[0]), Path(words[2])
        text = json.dumps(learned(file, int(words[1])), indent=1)
        (data / f"{file.stem}.json").write_text(text + "\n", encoding="utf-8")
    else:
        data, docs = map(Path, words)
        stored = [
            json.loads((data / f"{name}.json").read_text("utf-8")) for name in EXAMPLES
        ]
        draw_curves(stored, docs / "pictures" / "libraries")
        (docs / "libraries.md").write_text(page(stored), encoding="utf-8")

"""The page docs/libraries.md: what four training libraries learn in the same homes.

For each example, in an environment that has its library, with the folder of examples:

    python -m experiments.docs_tools.libraries learn examples/ppo.py 200000 DATA 0

trains with seed 0 and evaluates, and writes DATA/ppo_0.json. Then

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

SEEDS = (0, 1, 2)
"""Of training."""

PACKAGES = ("torch", "stable-baselines3", "sb3-contrib", "torchrl", "ray", "gymnasium")

SMOOTHED = 5.0
"""Width of the window that curves are averaged over [robot-hours]."""


def learned(example: Path, steps: int, seed: int) -> dict[str, Any]:
    """Trains an example and evaluates what it learned in homes that it never saw.

    Args:
        example: The file; its `train` takes steps and a seed, and returns a policy
            and a curve.
        steps: As the example counts them.
        seed: Of training.

    Returns:
        Plain data: the curve, the scores, and how long it took.
    """
    from experiments import evaluate
    from experiments.running.files import to_json

    train = runpy.run_path(str(example))["train"]
    begin = time.perf_counter()
    policy, curve = train(steps, seed=seed)
    took = time.perf_counter() - begin
    evaluation = evaluate(policy, FAMILY, HOUSEHOLDS)
    return {
        "format": 1,
        "example": example.stem,
        "seed": seed,
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


def read(data: Path) -> list[dict[str, Any]]:
    """Reads the runs that are stored, by example and seed.

    Args:
        data: The folder; each example has a run of the first seed at least.
    """
    files = [data / f"{name}_{seed}.json" for name in EXAMPLES for seed in SEEDS]
    first = [file for file in files if file.stem.endswith(f"_{SEEDS[0]}")]
    there = [file for file in files if file in first or file.exists()]
    return [json.loads(file.read_text("utf-8")) for file in there]


def page(documents: Sequence[Mapping[str, Any]]) -> str:
    """Returns the page.

    Args:
        documents: From `read`.
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
        rows=[_row(name, documents) for name in EXAMPLES],
        scores=family["scores"],
        references=[
            *((n, best if n == "best constant" else n) for n in REFERENCES),
            (dearest, f"always {liked}"),
        ],
        liked=liked,
        dearest=family["scores"][dearest],
        households=HOUSEHOLDS,
    )


def _row(name: str, documents: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """What an example comes to: means over its seeds, and each one's probe score."""
    runs = [one for one in documents if one["example"] == name]
    scores = [one["family"]["scores"]["policy"] for one in runs]

    def mean(measure: str) -> float:
        return float(np.mean([score[measure]["value"] for score in scores]))

    return {
        "example": name,
        "hours": runs[0]["curve"][-1][0],
        "seconds": float(np.mean([one["seconds"] for one in runs])),
        "versions": runs[0]["versions"],
        "probes": [score["probe_greedy"]["value"] for score in scores],
        "over_homes": scores[0]["probe_greedy"],
        "probe": mean("probe_greedy"),
        "verdicts": mean("verdicts_per_minute"),
        "reward": mean("reward_per_minute"),
        "caresses": mean("caresses_per_minute"),
        "taps": mean("taps_per_minute"),
    }


def draw_curves(documents: Sequence[Mapping[str, Any]], stem: Path) -> None:
    """Draws the learning curves of all runs as SVG, those of an example in one color.

    Args:
        documents: As for `page`.
        stem: Path of the picture without its suffix.
    """
    from experiments.figures.canvas import DASHES, PALETTE, Column, Panel, save

    def draw(axes: Axes) -> None:
        for name, color, dash in zip(EXAMPLES, PALETTE, DASHES, strict=False):
            label: str | None = EXAMPLES[name]
            for one in documents:
                if one["example"] == name:
                    hours, rewards = smoothed(one["curve"])
                    axes.plot(hours, rewards, color=color, linestyle=dash, label=label)
                    label = None  # The others of this example look the same.
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
        file, data, seed = Path(words[0]), Path(words[2]), int(words[3])
        text = json.dumps(learned(file, int(words[1]), seed), indent=1)
        (data / f"{file.stem}_{seed}.json").write_text(text + "\n", encoding="utf-8")
    else:
        data, docs = map(Path, words)
        stored = read(data)
        draw_curves(stored, docs / "pictures" / "libraries")
        (docs / "libraries.md").write_text(page(stored), encoding="utf-8")

"""A picture of a moment in every shipped scenario, for docs/scenarios.md.

Run as `python -m experiments.docs_tools.gallery FOLDER` (needs the extra `render`).
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from matplotlib.image import imsave

from household import household_v0
from household.config.toml import shipped

MOMENT = 150
"""Decision at which the picture is taken: everybody has found something to do."""


def take(scenario: str, path: Path) -> None:
    """Plays the beginning of a scenario with robots that choose at random.

    Args:
        scenario: Name of a shipped scenario.
        path: PNG file to write.
    """
    env = household_v0.parallel_env(scenario, render_mode="rgb_array")
    env.reset(seed=1)
    rng = np.random.default_rng(1)
    for _ in range(MOMENT):
        env.step(
            {
                agent: int(rng.integers(len(env.behaviors)))
                if env.behavior_over(agent)
                else env.behavior(agent).behavior
                for agent in env.agents
            }
        )
    imsave(path, np.asarray(env.render()))
    env.close()


if __name__ == "__main__":
    for name in shipped("scenario"):
        take(name, Path(sys.argv[1]) / f"scenario_{name}.png")

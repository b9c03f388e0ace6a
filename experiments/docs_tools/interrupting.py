"""Does it pay to interrupt? The table of docs/environment.md, from examples/ppo.py.

    python -m experiments.docs_tools.interrupting learn FAMILY SEED DATA
    python -m experiments.docs_tools.interrupting table DATA docs/environment.md

The first trains a robot that may choose in every step and one that is held, and lets
both live in other homes of the family; it needs PyTorch. The second writes the table.
"""

from __future__ import annotations

import json
import runpy
import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

FAMILIES = ("phone", "family_evening", "sleeping_baby", "quiet_work")
SEEDS = (0, 1, 2)

STEPS = 500_000
"""Of robots, in training."""

HOMES, FIRST, LIVED = 8, 5_000, 600
"""Other homes that are lived in, the first one's number, and for how many steps."""

CHOICES = {"in every step": False, "held": True}
"""What a robot may do, and whether that is held."""

BEGIN, END = "<!-- interrupting -->\n", "<!-- /interrupting -->\n"

Policy = Callable[[Any, str], int]


def learned(family: str, seed: int, steps: int = STEPS) -> dict[str, Any]:
    """Trains both robots of a seed, and tells how they lived.

    Args:
        family: Whose homes.
        seed: Of training.
        steps: Of robots.
    """
    example = Path(__file__).parents[2] / "examples" / "ppo.py"
    train = runpy.run_path(str(example))["train"]
    found = {"family": family, "seed": seed, "steps": steps}
    for name, held in CHOICES.items():
        policy, _ = train(steps, seed, family=family, held=held, draws=True)
        found[name] = lived(policy, family, seed, held=held)
    return found


def lived(policy: Policy, family: str, seed: int, *, held: bool) -> dict[str, float]:
    """What a robot does in homes that it never saw, on average.

    Args:
        policy: Of an observation and a robot's name.
        family: Whose homes.
        seed: Of their histories.
        held: Whether behaviors go on until they are over, whatever the policy says.
    """
    rows = [
        _home(policy, family, FIRST + home, seed, held=held) for home in range(HOMES)
    ]
    return {key: float(np.mean([row[key] for row in rows])) for key in rows[0]}


def _home(
    policy: Policy, family: str, home: int, seed: int, *, held: bool
) -> dict[str, float]:
    from household import household_v0
    from household.scenario.family import draw

    env = household_v0.parallel_env(draw(family, home), "features", max_cycles=LIVED)
    seen, infos = env.reset(seed=seed)
    counts = {"reward": 0.0, "caresses": 0.0, "taps": 0.0, "bouts": 0.0}
    liked, present = 0.0, dict.fromkeys(env.agents, -1)
    n_robots = len(env.agents)
    while env.agents:
        actions = {}
        for robot in env.agents:
            allowed = np.flatnonzero(infos[robot]["action_mask"])
            due = len(allowed) > 1
            action = policy(seen[robot], robot) if due or not held else int(allowed[0])
            counts["bouts"] += due or action != present[robot]
            liked += float(env.appropriateness(robot)[action])
            actions[robot] = present[robot] = action
        seen, rewards, _, _, infos = env.step(actions)
        counts["reward"] += sum(rewards.values())
        for info in infos.values():
            counts["caresses"] += int(np.sum(info["caresses"]))
            counts["taps"] += int(np.sum(info["taps"]))
    minutes = n_robots * LIVED * env.scenario.decision_period / 60
    told = {key: value / minutes for key, value in counts.items()}
    return told | {"appropriateness": liked / (n_robots * LIVED)}


def table(runs: list[Mapping[str, Any]]) -> str:
    """Returns the table: means over seeds, lowest and highest seed in brackets."""
    lines = [
        "| family | choice | reward a minute | caresses, taps a minute "
        "| bouts a minute | appropriateness |",
        "| --- | --- | --- | --- | --- | --- |",
    ]
    for family in FAMILIES:
        for name in CHOICES:
            rows = [run[name] for run in runs if run["family"] == family]
            found = {key: [row[key] for row in rows] for key in rows[0]}
            mean = {key: float(np.mean(values)) for key, values in found.items()}
            reward, first = found["reward"], name == next(iter(CHOICES))
            lines.append(
                f"| {family if first else ''} | {name} | {mean['reward']:z.2f} "
                f"[{min(reward):z.2f}, {max(reward):z.2f}] | {mean['caresses']:.1f}, "
                f"{mean['taps']:.1f} | {mean['bouts']:.0f} "
                f"| {mean['appropriateness']:z.3f} |"
            )
    return "\n".join(lines) + "\n"


def read(data: Path) -> list[Mapping[str, Any]]:
    """Reads the runs that are stored, by family and seed."""
    files = [data / f"{family}_{seed}.json" for family in FAMILIES for seed in SEEDS]
    return [json.loads(file.read_text("utf-8")) for file in files]


def main() -> None:
    """Trains, or writes the table into the page."""
    if sys.argv[1] == "learn":
        from experiments.running.files import to_json

        family, seed, data = sys.argv[2], int(sys.argv[3]), Path(sys.argv[4])
        file = data / f"{family}_{seed}.json"
        file.write_text(to_json(learned(family, seed)), "utf-8")
        return
    data, page = map(Path, sys.argv[2:])
    before, _, rest = page.read_text("utf-8").partition(BEGIN)
    after = rest.partition(END)[2]
    page.write_text(before + BEGIN + "\n" + table(read(data)) + "\n" + END + after)


if __name__ == "__main__":
    main()

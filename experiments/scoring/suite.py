"""Which scenario families are worth learning in: the admission rule, as figures.

A family enters the suite only if no constant behavior is nearly right all the time, and
if what robots can see of people is enough to be right: by the probe score, the best
constant is at most .5, and the best table that the richest representation allows,
fitted to the true verdicts on other episodes of the same household, reaches .9.

The richest representation is additive over people: a row for each person, its role,
whether it attends to the robot, hears it and is near it.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass

import msgspec
import numpy as np

from experiments.analysis.statistics import Estimate, mean
from experiments.running.engine import Engine, run_trials
from experiments.scoring.moments import Floats, Moment, ProbeSet, probe_set
from experiments.scoring.scores import live, probe_score
from household.scenario.family import Family

MOST_BY_CONSTANT, LEAST_BY_TABLE = 0.5, 0.9
"""Bounds of the admission rule, as probe scores."""

FITTED, HELD_OUT, STEPS = 6, 2, 900
"""Walks that the table is fitted to, walks that it is tested on, and their length."""

RIDGE = 0.01
"""Penalty of the fit: rows hardly ever met stay near 0 (our choice)."""

FEWEST_TOUCHES = 1.0
"""Touches in a robot's minute under random behavior below which there is nothing to
learn from."""


@dataclass(frozen=True, kw_only=True)
class Demand:
    """What one household of a family demands, by probe score."""

    family: str
    seed: int
    people: int
    robots: int
    constants: Mapping[str, float]
    """Score of each constant behavior."""

    table: float
    """Score of the fitted table."""

    share: float
    """Share of all moments that matter."""

    touches: float
    """Touches in a robot's minute under random behavior."""


@dataclass(frozen=True, kw_only=True)
class Admission:
    """Whether a family may enter the suite, and why."""

    family: str
    demand: str
    """What it demands of a robot, in one line."""

    best_constant: str
    constant: Estimate
    """Probe score of the best constant, over households."""

    table: Estimate
    """Probe score of the fitted table, over households."""

    share: Estimate
    """Share of moments that matter."""

    touches: Estimate
    """Touches in a robot's minute under random behavior."""

    like: str | None = None
    """A family before it that differs from it in words alone."""

    @property
    def faults(self) -> tuple[str, ...]:
        """What speaks against the family, one line each; empty if it is admitted."""
        found = []
        if not self.constant.value <= MOST_BY_CONSTANT:
            found.append(
                f"constant {self.best_constant} scores {self.constant.value:.2f}; "
                f"allowed: at most {MOST_BY_CONSTANT}"
            )
        if not self.table.value >= LEAST_BY_TABLE:
            found.append(
                f"the richest table scores {self.table.value:.2f}; "
                f"allowed: at least {LEAST_BY_TABLE}"
            )
        if not self.touches.value >= FEWEST_TOUCHES:
            found.append(
                f"{self.touches.value:.2f} touches a minute under random behavior; "
                f"allowed: at least {FEWEST_TOUCHES:g}"
            )
        if self.like is not None:
            found.append(f"draws the same households as {self.like}")
        return tuple(found)


def demand(task: tuple[str, int]) -> Demand:
    """Measures what one household demands; a function of family and seed alone."""
    from household import household_v0
    from household.scenario.family import draw

    family, seed = task
    scenario = draw(family, seed)
    env = household_v0.parallel_env(scenario)
    words = np.random.SeedSequence(seed, spawn_key=(2,)).generate_state(
        FITTED + HELD_OUT + 1
    )
    seeds = [int(word) for word in words]
    fitted = probe_set(env, seeds[:FITTED], STEPS)
    probes = probe_set(env, seeds[FITTED:-1], STEPS)
    rng = np.random.default_rng(seeds[-1])
    lived = live(env, lambda now: int(rng.integers(now.n_behaviors)), seeds[-1], STEPS)
    return Demand(
        family=family,
        seed=seed,
        people=len(scenario.people),
        robots=len(scenario.robots),
        constants={
            name: probe_score([behavior] * len(probes.moments), probes.moments)
            for behavior, name in enumerate(env.behaviors)
        },
        table=probe_score(table_choices(fitted, probes), probes.moments),
        share=probes.share,
        touches=(lived.caresses + lived.taps) / lived.minutes,
    )


def table_choices(fitted: ProbeSet, tested: ProbeSet) -> list[int]:
    """Returns what the richest table chooses, fitted to the truth on other episodes.

    Args:
        fitted: What its rows are fitted to, by ridge regression.
        tested: Where it chooses.
    """
    rows: dict[Hashable, int] = {}
    for each in fitted.moments:
        for key in facts(each):
            rows.setdefault(key, len(rows))
    known = _indicators(fitted.moments, rows)
    truth = np.array([each.truth for each in fitted.moments])
    penalty = RIDGE * np.eye(len(rows))
    table = np.linalg.solve(known.T @ known + penalty, known.T @ truth)
    chosen = (_indicators(tested.moments, rows) @ table).argmax(axis=1)
    return [int(behavior) for behavior in chosen]


def facts(moment: Moment) -> Iterable[Hashable]:
    """Yields what the robot's situation says of each person, by name."""
    situation = moment.situation
    for person, role in situation.plays:  # type: ignore[attr-defined]
        yield (person, role, *situation.relations(person))  # type: ignore[attr-defined]


def _indicators(moments: Sequence[Moment], rows: Mapping[Hashable, int]) -> Floats:
    """Which rows hold at each moment, shape (n_moments, n_rows)."""
    known = np.zeros((len(moments), len(rows)))
    for at, each in enumerate(moments):
        for key in facts(each):
            if key in rows:
                known[at, rows[key]] += 1.0
    return known


def admission(
    demands: Sequence[Demand], what: str, like: str | None = None
) -> Admission:
    """Holds a family against the admission rule.

    Args:
        demands: Of its households.
        what: The family demands of a robot.
        like: A family that draws the same households.
    """
    names = list(demands[0].constants)
    scores = {name: [each.constants[name] for each in demands] for name in names}
    best = max(names, key=lambda name: float(np.mean(scores[name])))
    return Admission(
        family=demands[0].family,
        demand=what,
        best_constant=best,
        constant=mean(scores[best]),
        table=mean([each.table for each in demands]),
        share=mean([each.share for each in demands]),
        touches=mean([each.touches for each in demands]),
        like=like,
    )


def shipped_families() -> tuple[str, ...]:
    """Returns the names of the families that come with the package."""
    from household.config.toml import shipped

    return tuple(shipped("family"))


def check_suite(
    families: Sequence[str],
    households: int,
    engine: Engine,
    advance: Callable[[], None],
) -> tuple[Admission, ...]:
    """Holds families against the admission rule, in the order given.

    Args:
        families: Names or TOML paths.
        households: How many of each are drawn, with seeds from 0.
        engine: Where to measure them.
        advance: Called after each household.

    Raises:
        HouseholdError: If a family cannot be read or drawn.
    """
    from household.scenario.family import load_family

    demands: dict[str, list[Demand]] = {name: [] for name in families}
    tasks = [(name, seed) for name in families for seed in range(households)]
    for outcome in run_trials(demand, tasks, engine):
        if outcome.value is None:
            raise outcome.error or RuntimeError(f"{outcome.trial}: no result")
        demands[outcome.value.family].append(outcome.value)
        advance()
    copies = duplicates([load_family(name) for name in families])
    return tuple(
        admission(
            sorted(demands[name], key=lambda one: one.seed),
            load_family(name).demand,
            copies.get(load_family(name).name),
        )
        for name in families
    )


def duplicates(families: Sequence[Family]) -> dict[str, str]:
    """Returns families that differ from an earlier one in words alone, with it."""
    seen: dict[bytes, str] = {}
    found = {}
    for family in families:
        plain = msgspec.structs.replace(family, name="", demand="", description="")
        first = seen.setdefault(msgspec.json.encode(plain), family.name)
        if first != family.name:
            found[family.name] = first
    return found

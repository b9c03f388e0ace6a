"""One trial with phases: a pure function of its record.

    train    in many households, one after the other
    adapt    to a new household until k touches were felt there, or freeze
    probe    on moments of that household that no policy has produced
    test     live there, frozen, and be judged by its people

What is trained depends on the training and the learner alone. So it can be handed in,
where another trial has stored it; the result is the same.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from experiments.phases.drawing import probed_in
from experiments.phases.frozen import policy_of
from experiments.phases.lessons import TRAINED, condition_of, streams_of, taught
from experiments.phases.probed import (
    LIVED,
    STEPS,
    Row,
    about,
    life,
    life_in,
    probes_of,
    row_of,
)
from experiments.phases.records import Phases
from experiments.phases.robots import (
    Diary,
    brought_back,
    can_be_kept,
    copies,
    described_learner,
    home_of,
    kept,
    learns,
    robots_of,
    touched,
)
from experiments.phases.splits import HASHES
from experiments.phases.world import Residence, described, household
from experiments.running.study import Condition, Trial
from experiments.scoring.policies import specification
from experiments.scoring.references import references
from experiments.scoring.scores import probe_score
from learners.team import Team

if TYPE_CHECKING:
    import polars

_OVER = object()


def train(trial: Trial) -> polars.DataFrame:
    """Runs the first phase alone.

    Returns:
        One row: `learned` (all that the learners are, as a text; empty if they cannot
        be kept), `trained_touches`, `trained_choices` and `met` (share of the choices
        made in a situation that was met before).
    """
    import polars as pl

    team, row = taught(trial)
    text = kept(team) if can_be_kept(condition_of(trial)) else ""
    return pl.DataFrame({"learned": text} | row)


def run(trial: Trial, learned: polars.DataFrame | None = None) -> polars.DataFrame:
    """Runs all phases of a trial.

    Args:
        trial: Its condition is `Phases`.
        learned: What `train` returned for the same learner and training; None: the
            first phase is run here.

    Returns:
        A row for each household that is probed and each number of touches: which
        household it is (`people`, `home`, `roles`), `touches`, `felt` (touches that
        were really felt), `choices` made there and `met_there` (share of them in a
        situation that was met before, there), `greedy` and `deployed` (probe scores),
        `best_constant` (that of the best constant behavior, in hindsight), `moments`
        and `share` (of the probe set), what was lived through in training, and, in the
        last row of a household, what came of living there; null elsewhere.
    """
    import polars as pl

    condition = condition_of(trial)
    rows = _learner_rows(trial, learned) if learns(condition) else _policy_rows(trial)
    return pl.DataFrame(list(rows), _SCHEMA)


def describe_phases(condition: Condition) -> dict[str, Any]:
    """Returns everything that a condition fixes, as plain data."""
    phases = cast(Phases, condition)
    document = {
        "factors": dict(phases.factors),
        "learner": phases.learner,
        "settings": described_learner(phases) if learns(phases) else None,
        "sharing": phases.sharing,
        "splits": dict(HASHES),
    }
    for name in ("training", "probing"):
        phase = getattr(phases, name)
        document[name] = asdict(phase) | {"world": described(phase.world)}
    return document


def describe_training(condition: Condition) -> dict[str, Any]:
    """Returns everything that the first phase of a condition depends on."""
    document = describe_phases(condition)
    del document["probing"], document["factors"]
    return document


def _learner_rows(trial: Trial, learned: polars.DataFrame | None) -> Iterator[Row]:
    """The rows of a learner."""
    condition = condition_of(trial)
    if learned is None or not learned["learned"][0]:
        team, row = taught(trial)
        if can_be_kept(condition):  # So that it goes on as one that was stored does.
            team = brought_back(kept(team))
    else:
        team, row = brought_back(learned["learned"][0]), learned.row(0, named=True)
    another = copies(team, condition)
    adapting, choosing = (each.spawn(64) for each in streams_of(trial)[2:])
    for number, residence in enumerate(probed_in(condition, trial.seed)):
        fresh = another()
        seed = int(adapting[number].generate_state(1)[0])
        rng = np.random.default_rng(choosing[number])
        for each in _adapted(condition, residence, fresh, seed, rng):
            yield {name: row[name] for name in TRAINED} | each


def _adapted(
    condition: Phases,
    residence: Residence,
    team: Team,
    seed: int,
    rng: np.random.Generator,
) -> Iterator[Row]:
    """The rows of one household, as its robots adapt to it."""
    probing, probes = condition.probing, probes_of(residence)
    env = home_of(team, residence, probing.decisions)
    robots, diary = robots_of(team), Diary()
    going_on = touched(env, robots, seed, diary)
    for touches in probing.touches:
        while diary.touches < touches:
            if next(going_on, _OVER) is _OVER:
                break
        last = touches == probing.touches[-1]
        if last:
            going_on.close()
        policy = policy_of(robots, rng, env)
        lived = probing.lived if last else 0
        yield row_of(residence, policy, probes, lived) | {
            "touches": touches,
            "felt": diary.touches,
            "choices": diary.choices,
            "met_there": diary.met / max(diary.choices, 1),
        }


def _policy_rows(trial: Trial) -> Iterator[Row]:
    """The rows of a policy or a reference, which does not learn."""
    condition = condition_of(trial)
    nothing = dict.fromkeys(TRAINED, 0) | {"met": None}
    choosing = streams_of(trial)[3].spawn(64)
    for number, residence in enumerate(probed_in(condition, trial.seed)):
        rng = np.random.default_rng(choosing[number])
        scores = _policy_scores(condition, residence, rng)
        for touches in condition.probing.touches:
            yield nothing | scores | {"touches": touches, "felt": 0, "choices": 0}


def _policy_scores(
    condition: Phases, residence: Residence, rng: np.random.Generator
) -> Row:
    name, probes = condition.learner, probes_of(residence)
    lived = condition.probing.lived
    env = household(residence, lived or STEPS)
    known = references(env, rng)
    if name not in known:
        make = specification(name.removeprefix("act:")).make
        assert make is not None  # a learner of the catalog is none of these
        policy = make(env.behaviors, rng)
        return row_of(residence, policy, probes, lived)
    reference = known[name]
    if not reference.on_probes:
        return about(residence, probes) | {
            "greedy": float("nan"),
            "deployed": float("nan"),
            # It looks ahead in the very household that it lives in.
            **(life_in(env, residence, reference.choose) if lived else {}),
        }
    chosen = [reference.choose(moment) for moment in probes.moments]
    score = probe_score(chosen, probes.moments)
    return about(residence, probes) | {
        "greedy": score,
        "deployed": score,
        **life(residence, reference.choose, lived),
    }


_SCHEMA: dict[str, Any] = {
    **dict.fromkeys(("people", "roles"), str),
    **dict.fromkeys(("home", "touches", "felt", "moments"), int),
    **dict.fromkeys(("greedy", "deployed", "best_constant", "share"), float),
    **dict.fromkeys(("trained_touches", "trained_choices"), int),
    "met": float,
    "choices": int,
    "met_there": float,
    **dict.fromkeys(LIVED, float),
}

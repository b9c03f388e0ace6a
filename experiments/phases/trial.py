"""One trial with phases: a pure function of its record.

    train    in many households, one after the other
    adapt    to a new household until k touches were felt there, or freeze
    probe    on moments of that household that no policy has produced
    test     live there, frozen, and be judged by its people

What is trained depends on the training and the learner alone. So it can be handed in,
where another trial has stored it; the result is the same.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Mapping, Sequence
from dataclasses import asdict
from functools import lru_cache
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from experiments.phases.drawing import probed_in, trained_in
from experiments.phases.records import Phases
from experiments.phases.robots import (
    Diary,
    brought_back,
    can_be_kept,
    described_learner,
    home_of,
    kept,
    learns,
    new_team,
    robots_of,
    teach,
    touched,
)
from experiments.phases.seeing import Slotted, observes
from experiments.phases.splits import HASHES
from experiments.phases.world import Residence, described, household
from experiments.running.study import Condition, Trial
from experiments.scoring.moments import Moment, ProbeSet, Sight, probe_set
from experiments.scoring.policies import Policy, of_learner, of_robots, specification
from experiments.scoring.references import references
from experiments.scoring.scores import live, probe_score
from learners.team import Team

if TYPE_CHECKING:
    import polars

    from household.environment import Household
    from learners.learner import Learner
    from policies.learning import LearningRobot

WALKS, STEPS = 2, 900
"""Reference walks that a probe set is drawn from, and their length [steps]."""

Row = dict[str, Any]

_OVER = object()


def train(trial: Trial) -> polars.DataFrame:
    """Runs the first phase alone.

    Returns:
        One row: `learned` (all that the learners are, as a text; empty if they cannot
        be kept), `trained_touches`, `trained_choices` and `met` (share of the choices
        made in a situation that was met before).
    """
    import polars as pl

    team, row = _taught(trial)
    text = kept(team) if can_be_kept(_condition(trial)) else ""
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

    condition = _condition(trial)
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


def _condition(trial: Trial) -> Phases:
    return cast(Phases, trial.condition)


def _streams(trial: Trial) -> list[np.random.SeedSequence]:
    """Streams for: learning, living in training, adapting, choosing."""
    return np.random.SeedSequence(trial.seed, spawn_key=(6,)).spawn(4)


def _taught(trial: Trial) -> tuple[Team, Row]:
    """Runs the first phase: all robots together, or each in households of its own."""
    condition = _condition(trial)
    alone = condition.training.alone
    learning, living, _, _ = _streams(trial)
    if not alone:
        team, diary = _lesson(condition, trial.seed, learning, living)
        return team, _trained([diary])
    lessons = [
        _lesson(condition, trial.seed, one, other)
        for one, other in zip(learning.spawn(alone), living.spawn(alone), strict=True)
    ]
    members: dict[Hashable, Learner] = {
        f"robot_{number}": next(iter(team.members.values()))
        for number, (team, _) in enumerate(lessons)
    }
    return Team(members=members), _trained([diary for _, diary in lessons])


def _lesson(
    condition: Phases,
    seed: int,
    learning: np.random.SeedSequence,
    living: np.random.SeedSequence,
) -> tuple[Team, Diary]:
    """Teaches new robots in the households of training."""
    residences = trained_in(condition.training, seed)
    env = household(residences[0], 1)
    rng = np.random.default_rng(learning)
    team = new_team(condition, env.possible_agents, len(env.behaviors), rng)
    words = [int(word) for word in living.generate_state(len(residences))]
    return team, teach(team, residences, condition.training.decisions, words)


def _trained(diaries: Sequence[Diary]) -> Row:
    choices = sum(each.choices for each in diaries)
    return {
        "trained_touches": sum(each.touches for each in diaries),
        "trained_choices": choices,
        "met": sum(each.met for each in diaries) / max(choices, 1),
    }


def _learner_rows(trial: Trial, learned: polars.DataFrame | None) -> Iterator[Row]:
    """The rows of a learner."""
    import copy

    condition = _condition(trial)
    if learned is None or not learned["learned"][0]:
        team, row = _taught(trial)
    else:
        team, row = brought_back(learned["learned"][0]), learned.row(0, named=True)
    text = kept(team) if can_be_kept(condition) else None
    adapting, choosing = (each.spawn(64) for each in _streams(trial)[2:])
    for number, residence in enumerate(probed_in(condition, trial.seed)):
        fresh = brought_back(text) if text is not None else copy.deepcopy(team)
        seed = int(adapting[number].generate_state(1)[0])
        rng = np.random.default_rng(choosing[number])
        for each in _adapted(condition, residence, fresh, seed, rng):
            yield {name: row[name] for name in _TRAINED} | each


def _adapted(
    condition: Phases,
    residence: Residence,
    team: Team,
    seed: int,
    rng: np.random.Generator,
) -> Iterator[Row]:
    """The rows of one household, as its robots adapt to it."""
    probing, probes = condition.probing, _probes(residence)
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
        policy = _policy_of(robots, rng, env)
        lived = probing.lived if last else 0
        yield _row(residence, policy, probes, lived) | {
            "touches": touches,
            "felt": diary.touches,
            "choices": diary.choices,
            "met_there": diary.met / max(diary.choices, 1),
        }


def _policy_of(
    robots: Mapping[str, LearningRobot], rng: np.random.Generator, env: Household
) -> Policy:
    """What robots that no longer learn would do."""
    return of_robots(
        {
            agent: _looking(robot.learner, env)
            if observes(robot.learner)
            else of_learner(cast("Learner", _Remembering(robot.learner)), rng)
            for agent, robot in robots.items()
        }
    )


def _looking(learner: Learner, env: Household) -> Policy:
    """What a learner that looks at the features would do."""
    slotted = Slotted(env)

    def greedy(sight: Sight) -> int:
        seen = slotted.seen(sight.situation, sight.observation)
        return int(learner.q_values(seen).argmax())

    def deployed(sight: Sight) -> int:
        return learner.act(slotted.seen(sight.situation, sight.observation))

    return Policy(greedy=greedy, deployed=deployed)


class _Remembering:
    """A learner that no longer learns, and is asked for each situation only once."""

    def __init__(self, learner: Learner) -> None:
        self._learner = learner
        self._values: dict[Hashable, Any] = {}
        self._estimates: dict[Hashable, Any] = {}
        self.act = learner.act
        self.exploration = getattr(learner, "exploration", None)

    def q_values(self, state: Hashable) -> Any:  # noqa: ANN401 - as the learner's
        """Its values, remembered."""
        if state not in self._values:
            self._values[state] = self._learner.q_values(state)
        return self._values[state]

    def estimates(self, state: Hashable) -> Any:  # noqa: ANN401 - as the learner's
        """Its estimates, remembered."""
        if state not in self._estimates:
            self._estimates[state] = self._learner.estimates(state)  # type: ignore[attr-defined]
        return self._estimates[state]


def _policy_rows(trial: Trial) -> Iterator[Row]:
    """The rows of a policy or a reference, which does not learn."""
    condition = _condition(trial)
    nothing = dict.fromkeys(_TRAINED, 0) | {"met": None}
    choosing = _streams(trial)[3].spawn(64)
    for number, residence in enumerate(probed_in(condition, trial.seed)):
        rng = np.random.default_rng(choosing[number])
        scores = _policy_scores(condition, residence, rng)
        for touches in condition.probing.touches:
            yield nothing | scores | {"touches": touches, "felt": 0, "choices": 0}


def _policy_scores(
    condition: Phases, residence: Residence, rng: np.random.Generator
) -> Row:
    name, probes = condition.learner, _probes(residence)
    lived = condition.probing.lived
    env = household(residence, STEPS)
    known = references(env, rng)
    if name not in known:
        make = specification(name.removeprefix("act:")).make
        assert make is not None  # a learner of the catalog is none of these
        policy = make(env.behaviors, rng)
        return _row(residence, policy, probes, lived)
    reference = known[name]
    if not reference.on_probes:
        return _about(residence, probes) | {
            "greedy": float("nan"),
            "deployed": float("nan"),
            **_life(residence, reference.choose, lived),
        }
    chosen = [reference.choose(moment) for moment in probes.moments]
    score = probe_score(chosen, probes.moments)
    return _about(residence, probes) | {
        "greedy": score,
        "deployed": score,
        **_life(residence, reference.choose, lived),
    }


def _row(residence: Residence, policy: Policy, probes: ProbeSet, lived: int) -> Row:
    sights: Sequence[Sight] = probes.moments
    return _about(residence, probes) | {
        "greedy": probe_score([policy.greedy(s) for s in sights], probes.moments),
        "deployed": probe_score([policy.deployed(s) for s in sights], probes.moments),
        **_life(residence, lambda now: policy.deployed(now.sight()), lived),
    }


def _about(residence: Residence, probes: ProbeSet) -> Row:
    """Which household it is, and what its probe set is like."""
    return {
        "people": residence.group,
        "home": residence.home,
        "roles": " ".join(f"{one}-{other}" for one, other in residence.roles),
        "best_constant": _best_constant(probes),
        "moments": len(probes.moments),
        "share": probes.share,
    }


def _life(residence: Residence, choose: Any, steps: int) -> Row:  # noqa: ANN401
    """What becomes of a policy's own episode; nothing if there is none."""
    if not steps:
        return dict.fromkeys(_LIVED)
    env = household(residence, steps)
    lived = live(env, choose, residence.words(3)[2])
    return {
        "verdicts_per_minute": lived.per_minute,
        "verdicts_per_bout": lived.per_bout,
        "caresses_per_minute": lived.caresses / lived.minutes,
        "taps_per_minute": lived.taps / lived.minutes,
        "opinion": lived.opinion,
    }


@lru_cache(maxsize=48)
def _probes(residence: Residence) -> ProbeSet:
    """The probe set of a household: the same for every seed and every condition.

    What a robot observes is kept as it is asked for (features).
    """
    return probe_set(household(residence, STEPS), residence.words(WALKS), STEPS)


def _best_constant(probes: ProbeSet) -> float:
    moments: tuple[Moment, ...] = probes.moments
    if not moments:
        return float("nan")
    n = moments[0].n_behaviors
    return max(probe_score([each] * len(moments), moments) for each in range(n))


_TRAINED = ("trained_touches", "trained_choices", "met")

_LIVED = (
    "verdicts_per_minute",
    "verdicts_per_bout",
    "caresses_per_minute",
    "taps_per_minute",
    "opinion",
)

_SCHEMA: dict[str, Any] = {
    **dict.fromkeys(("people", "roles"), str),
    **dict.fromkeys(("home", "touches", "felt", "moments"), int),
    **dict.fromkeys(("greedy", "deployed", "best_constant", "share"), float),
    **dict.fromkeys(("trained_touches", "trained_choices"), int),
    "met": float,
    "choices": int,
    "met_there": float,
    **dict.fromkeys(_LIVED, float),
}

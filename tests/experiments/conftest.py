"""Shared helpers: programs to kill, a toy home, hand-written tables."""

import contextlib
import os
import shutil
import signal
import subprocess
import sys
import textwrap
import time
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import polars as pl
import pytest

from experiments.paper import EXPERIMENTS
from experiments.running.store import Results
from experiments.running.trial_columns import schema, situation_columns
from experiments.running.trial_table import TrialTable
from experiments.studies import factorial, sensitivity
from household.perception.situation import Situation
from learners.catalog import CATALOG, make_learner
from policies.learning import LearningRobot, run_episode


@pytest.fixture
def program(tmp_path):
    """Returns a function that starts a Python script in a process group of its own."""
    started = []

    def start(source, *arguments):
        script = tmp_path / "script.py"
        script.write_text(textwrap.dedent(source))
        process = subprocess.Popen(
            [sys.executable, str(script), *map(str, arguments)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
        )
        started.append(process)
        return process

    yield start
    for process in started:  # a test that failed may have left it running
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)


@pytest.fixture
def group_is_empty():
    """Returns a function that says whether a process group died out (waits 10 s)."""

    def check(group):
        for _ in range(100):
            try:
                os.killpg(group, 0)
            except ProcessLookupError:
                return True
            time.sleep(0.1)
        return False

    return check


@dataclass(frozen=True)
class ToyTouch:
    giver: str
    value: float
    time: float
    attending: bool = True
    mood: float = 0.0
    approach_began: float | None = None
    attention_began: float | None = None


@dataclass(frozen=True)
class ToyCause:
    robot: str
    decision: int
    behavior: int
    time: float


class PlayHome:
    """Experiment 1 without a room: ann plays, looks up now and then, and touches.

    A behavior takes two steps of one second. While ann looks up, she answers each
    behavior in its second step: a tap for bark, a caress for play that she gives less
    and less.
    """

    possible_agents: ClassVar = ["robot_0"]
    behaviors = ("bark", "play")

    def __init__(self, steps=400):
        self.steps = steps

    def reset(self, seed=None):
        self.rng = np.random.default_rng(seed)
        self.agents = list(self.possible_agents)
        self.decision, self.begun, self.doing = 0, 0, None
        self.looking, self.felt, self.caresses = False, None, 0

    def step(self, actions):
        if self.behavior_over("robot_0"):
            self.begun, self.doing = self.decision, actions["robot_0"]
        self.decision += 1
        if self.rng.random() < 0.15:
            self.looking = not self.looking
        self.felt = self._touch() if self.decision - self.begun == 2 else None
        if self.decision == self.steps:
            self.agents = []

    def _touch(self):
        if not self.looking:
            return None
        if self.doing == 0:
            return ToyTouch("ann", -1.0, self.time)
        self.caresses += 1
        fond = self.rng.random() < 0.95**self.caresses
        return ToyTouch("ann", 0.5, self.time) if fond else None

    @property
    def time(self):
        return float(self.decision)

    def situation(self, agent):
        return Situation.of({"ann": "playing"})

    def behavior_over(self, agent):
        return self.doing is None or self.decision - self.begun >= 2

    def feedback(self, agent):
        return () if self.felt is None else (self.felt,)

    def causes(self, agent):
        cause = ToyCause("robot_0", self.begun, self.doing, float(self.begun))
        return tuple(cause for _ in self.feedback(agent))

    def approached(self, agent):
        return False

    def attended(self, agent):
        return self.looking

    def appropriateness(self, agent):
        return np.array([-1.0, 1.0])

    def opinion(self, agent):
        return {"ann": 5.0 + self.caresses / 100}


@pytest.fixture
def play_home():
    return PlayHome


@pytest.fixture(scope="session")
def play_trial():
    """Returns a function that runs a trial of experiment 1 in a `PlayHome`."""

    def run(trial, steps=400):
        name, home = trial.condition.learner, PlayHome(steps)
        known = {"appropriateness": lambda state: home.appropriateness("robot_0")}
        learner = make_learner(
            name,
            2,
            np.random.default_rng(trial.seed),
            **{need: known[need] for need in CATALOG[name].needs},
        )
        table = TrialTable()
        robots = {"robot_0": LearningRobot(learner)}
        run_episode(home, robots, seed=trial.seed, observers=[table])
        return table.frame()

    return run


@pytest.fixture
def table():
    """Returns a function that makes a trial's table of hand-written entries."""

    def make(entries, **columns):
        rows = []
        for index, (situation, behavior, wanted) in enumerate(entries):
            row = {
                "robot": "robot_0",
                "time": 2.0 * index,
                "next_time": 2.0 * index + 2.0,
                "decision": 2 * index,
                "bout": 2 * index,
                **situation_columns(situation),
                "behavior": behavior,
                "chosen": True,
                "attended": False,
                "reward": 0.0,
                "cumulative": 0.0,
                "opinion": 5.0,
                "q": {"bark": 0.0, "play": 0.0},
                "appropriateness": {"bark": -wanted, "play": wanted},
                "touches": [],
                "updates": [],
            }
            rows.append(row | {name: given[index] for name, given in columns.items()})
        return pl.DataFrame(rows, schema=schema(("bark", "play")), orient="row")

    return make


@pytest.fixture
def stored(tmp_path, stored_once):
    """Directory with the plain run of experiment 1 and its factorial, in a toy home."""
    shutil.copytree(stored_once, tmp_path, dirs_exist_ok=True)
    return tmp_path


@pytest.fixture(scope="session")
def stored_once(tmp_path_factory, play_trial):
    """The same, to be copied by every test that changes it."""
    folder = tmp_path_factory.mktemp("stored")
    plain, combined = EXPERIMENTS[1].study((0, 1)), factorial.study(1, (0, 1))
    for study in (plain, combined):
        results = Results(folder / study.name)
        results.prepare(study, {})
        for index, trial in enumerate(study.trials()):
            made = pl.DataFrame({"right": [0.5 + index / 1000], "reward": 1.0})
            frame = play_trial(trial, 60) if study is plain else made
            results.write(trial, frame)
    return folder


@pytest.fixture
def plain_table(stored):
    """The table of the plain run."""
    study = EXPERIMENTS[1].study((0, 1))
    return Results(stored / study.name).read(study)


@pytest.fixture(scope="session")
def variants():
    """Returns `sensitivity.variants`, which tries each of them out, but only once."""
    found, work_out = {}, sensitivity.variants

    def once(experiments):
        chosen = tuple(experiments)
        numbers = tuple(each.number for each in chosen)
        if numbers not in found:
            found[numbers] = work_out(chosen)
        return found[numbers]

    return once


@pytest.fixture(scope="session")
def variant(variants):
    """Returns a function that finds a variant of experiment 1."""
    every = variants([EXPERIMENTS[1]])

    def find(name, direction="up"):
        return next(
            one
            for one in every
            if one.constant.name == name and one.direction == direction
        )

    return find


@pytest.fixture
def varied(stored, play_trial, variant):
    """A variant whose trials are there; the toy home does not change with it."""
    one = variant("learner: gamma")
    study = one.study((0, 1))
    results = Results(stored / study.name)
    results.prepare(study, {})
    for trial in study.trials():
        results.write(trial, play_trial(trial, 60))
    return one

import numpy as np
import pytest

from household import household_v0
from household.replay.reading import read_replay
from learners.catalog import make_learner
from policies.learning import LearningRobot, Observer, run_episode
from policies.recording import RecordingObserver


class Notes(Observer):
    """Writes down what learners say they believe and expect."""

    def __init__(self):
        self.credits, self.values = [], []

    def acted(self, env, robots):
        for name, robot in robots.items():
            self._note(env, name, robot)
            if robot.experience is not None or env.decision == 0:
                values = robot.learner.q_values(robot.pair.state)
                self.values.append((name, env.decision, values))

    def finished(self, env, robots):
        for name, robot in robots.items():
            self._note(env, name, robot)

    def _note(self, env, name, robot):
        for credit in robot.credits:
            for entry, weight in credit.shares:
                self.credits.append((env.decision, name, credit, entry, weight))


@pytest.fixture
def lived(tmp_path):
    """Plays an episode; returns what its learners said, and its replay."""

    def live(learner, **overrides):
        env = household_v0.parallel_env("experiment_4", max_cycles=200, **overrides)
        robots = {
            agent: LearningRobot(
                make_learner(learner, len(env.behaviors), np.random.default_rng(k))
            )
            for k, agent in enumerate(env.possible_agents)
        }
        notes, path = Notes(), tmp_path / "learning.rrd"
        observers = [notes, RecordingObserver(path, flush_every=64)]
        run_episode(env, robots, seed=3, observers=observers)
        return notes, read_replay(path, tried=True)

    return live


@pytest.mark.parametrize("learner", ["q_trace", "designated"])
def test_the_file_holds_what_the_learner_believed_of_each_touch(lived, learner):
    notes, replay = lived(learner)
    table = replay.credits
    assert len(notes.credits) == len(table["weight"]) > 10
    for row, (decision, name, credit, entry, weight) in enumerate(notes.credits):
        assert table["decision"][row] == decision
        assert replay.scenario.robot_names[table["robot"][row]] == name
        assert table["giver"][row] == credit.reward.giver
        assert table["touch_time"][row] == credit.reward.time
        assert table["time"][row] == entry.time
        assert table["behavior"][row] == entry.action
        assert table["weight"][row] == weight
        assert table["designated"][row] == (credit.designated is entry)


@pytest.mark.parametrize("learner", ["q_social", "random", "tamer"])
def test_the_file_holds_the_values_of_the_situation_at_each_choice(lived, learner):
    notes, replay = lived(learner)
    decisions, values = replay.values["robot_0"]
    said = {decision: values for _, decision, values in notes.values}
    assert decisions.tolist() == sorted(said)
    assert values.tolist() == [said[decision].tolist() for decision in sorted(said)]


def test_a_second_episode_gets_a_file_of_its_own(tmp_path):
    env = household_v0.parallel_env(max_cycles=5)
    learner = make_learner("q_social", len(env.behaviors), np.random.default_rng(0))
    observer = RecordingObserver(tmp_path / "home.rrd")
    for _ in range(2):
        run_episode(env, {"robot_0": LearningRobot(learner)}, observers=[observer])
    assert [
        len(read_replay(tmp_path / f"home{k}.rrd", tried=True)) for k in ("", "_1")
    ] == [6, 6]


def test_the_file_holds_each_choice_with_what_the_learner_knew(lived):
    _, replay = lived("designated")
    choices, moments = replay.choices, replay.moments
    chosen = np.flatnonzero(choices["chosen"])
    assert len(chosen) > 10
    for row in chosen:
        decision, robot = choices["decision"][row], choices["robot"][row]
        # A choice is made before the step that carries it out.
        assert moments.behavior[decision + 1, robot] == choices["behavior"][row]
    assert choices["probabilities"].sum(axis=1) == pytest.approx(1.0)
    name = replay.scenario.robot_names[0]
    decisions, values = replay.values[name]
    own = choices["robot"] == 0
    assert choices["decision"][own].tolist() == decisions.tolist()
    assert (choices["values"][own] == values).all()
    assert np.isfinite(choices["reference"]).all()


def test_touches_behind_values_add_up_as_they_come(lived):
    _, replay = lived("designated")
    touches = replay.choices["touches"]
    assert touches.max() >= 1
    assert (touches == np.round(touches)).all()
    assert touches.max() <= len(replay.credits["weight"])

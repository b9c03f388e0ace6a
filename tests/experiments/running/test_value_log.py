"""Which Q-values a trial's table looks at, and when."""

from collections import Counter

import numpy as np
import pytest

from experiments.analysis.measures import final_q, q_curve
from experiments.running.trial_columns import key_of
from experiments.running.trial_table import TrialTable
from experiments.running.value_log import ValueLog
from household.perception.situation import Situation
from policies.learning import LearningRobot, run_episode

PLAYING = Situation.of({"ann": "playing"})
CALLING = Situation.of({"ann": "calling"})
READING = Situation.of({"ann": "reading"})


class Drifting:
    """Chooses in turn; each entry moves the values of all situations, met or not."""

    n_behaviors = 2
    credits = ()

    def __init__(self):
        self.learned, self.looked_at = 0, Counter()

    def act(self, state):
        return self.learned % 2

    def start_episode(self):
        pass

    def q_values(self, state):
        self.looked_at[state] += 1
        return np.array([0.0, self.learned / 8])

    def learn(self, experience):
        self.learned += 1


def live(home, table):
    learner = Drifting()
    run_episode(home, {"robot_0": LearningRobot(learner)}, seed=0, observers=[table])
    return learner, table.frame()


@pytest.fixture
def many_situations(play_home):
    """A home in which every entry has a situation of its own."""

    class Home(play_home):
        def situation(self, agent):
            return Situation.of({"ann": f"role {self.decision // 2}"})

    return Home


@pytest.fixture
def three_situations(play_home):
    """A home in which ann plays, then calls, then plays again."""

    class Home(play_home):
        def situation(self, agent):
            return CALLING if 10 <= self.decision < 20 else PLAYING

    return Home


def test_a_table_asks_a_learner_for_each_situation_a_few_times(many_situations):
    learner, frame = live(many_situations(400), TrialTable())
    assert frame["situation"].n_unique() == len(frame) == 200
    # As the next one, when its own entry is over, and when the trial is.
    assert max(learner.looked_at.values()) <= 3


def test_every_value_is_what_the_learner_holds_when_the_trial_ends(many_situations):
    learner, frame = live(many_situations(60), TrialTable())
    for key in frame["situation"]:
        assert final_q(frame, key) == {"bark": 0.0, "play": learner.learned / 8}


def test_a_followed_situation_is_looked_at_after_every_entry(three_situations):
    table = TrialTable(followed=[lambda situation: situation == PLAYING])
    _, frame = live(three_situations(30), table)
    times, values = q_curve(frame, key_of(PLAYING), "play")
    assert times.tolist() == [0.0, *frame["next_time"]]
    assert values.tolist() == [n / 8 for n in range(len(frame) + 1)]


def test_another_situation_is_looked_at_when_it_is_met_again(three_situations):
    _, frame = live(three_situations(30), TrialTable())
    times, values = q_curve(frame, key_of(PLAYING), "play")
    away = [2 * n for n in range(6, 10)]
    assert set(frame["next_time"]) - set(times) == set(away)
    again = times.tolist().index(20.0)
    assert values[again] - values[again - 1] == 5 / 8


def test_the_values_of_an_entry_are_those_before_its_end(three_situations):
    _, frame = live(three_situations(30), TrialTable())
    assert frame["q"].struct.field("play").to_list() == [
        n / 8 for n in range(len(frame))
    ]


def test_a_situation_that_was_never_met_is_met_without_a_change():
    log, learner = ValueLog(followed=[lambda situation: True]), Drifting()
    assert list(log.changes(learner, [PLAYING])) == []
    learner.learned = 4
    assert list(log.changes(learner, [CALLING])) == [(PLAYING, 1, 0.5)]
    assert list(log.changes(learner, [CALLING])) == []
    assert log.values(learner, PLAYING) == log.values(learner, READING) == [0.0, 0.5]

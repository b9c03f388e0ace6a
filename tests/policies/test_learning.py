from dataclasses import dataclass, field

import numpy as np
import pytest

from learners.experience import Reward
from policies.learning import LearningRobot, Observer, run_episode


@dataclass
class Felt:
    value: float
    time: float
    giver: str = "ann"
    attending: bool = True
    mood: float = 0.0
    approach_began: float | None = None
    attention_began: float | None = None


@dataclass
class ToyHome:
    """A home whose every step is written down: one second a step, one robot or more.

    `situations[t]`, `over[t]`, `attended[t]` hold at time t; `touches[t]` were felt in
    the step that ended at t.
    """

    situations: list
    over: list
    touches: dict = field(default_factory=dict)
    attentive: set = field(default_factory=set)
    coming: set = field(default_factory=set)
    names: tuple = ("robot_0",)
    seeds: list = field(default_factory=list)
    actions: list = field(default_factory=list)
    decision: int = 0

    def reset(self, seed=None):
        self.agents = list(self.names)
        self.decision = 0
        self.seeds.append(seed)

    def step(self, actions):
        self.actions.append(actions)
        self.decision += 1
        if self.decision == len(self.situations) - 1:
            self.agents = []

    @property
    def time(self):
        return float(self.decision)

    def situation(self, agent):
        return self.situations[self.decision]

    def behavior_over(self, agent):
        return self.over[self.decision]

    def feedback(self, agent):
        return self.touches.get((agent, self.decision), ())

    def approached(self, agent):
        return self.decision in self.coming

    def attended(self, agent):
        return self.decision in self.attentive


class Notebook:
    """A learner that chooses 0, 1, 2, ... in turn and writes everything down."""

    n_behaviors = 100

    def __init__(self):
        self.asked, self.learned, self.episodes, self.credits = [], [], 0, ()

    def act(self, state):
        self.asked.append(state)
        return len(self.asked) - 1

    def learn(self, experience):
        self.learned.append(experience)
        self.credits = (len(self.learned),)

    def start_episode(self):
        self.episodes += 1

    def q_values(self, state):
        return np.zeros(self.n_behaviors)


def live(home, observers=()):
    learner = Notebook()
    run_episode(
        home,
        {name: LearningRobot(learner) for name in home.names},
        seed=3,
        observers=observers,
    )
    return learner


def test_a_learner_is_asked_only_when_the_behavior_is_over():
    home = ToyHome(["A"] * 6, [True, False, False, True, False, True])
    learner = live(home)
    assert learner.asked == ["A", "A"]
    assert [a["robot_0"] for a in home.actions] == [0, 0, 0, 1, 1]


def test_an_entry_ends_when_a_behavior_is_chosen_anew():
    learner = live(ToyHome(["A"] * 6, [True, False, False, True, False, True]))
    spans = [(e.action, e.time, e.next_time, e.chosen) for e in learner.learned]
    assert spans == [(0, 0.0, 3.0, True), (1, 3.0, 5.0, True)]


def test_an_entry_ends_when_the_situation_changes_and_the_behavior_goes_on():
    learner = live(ToyHome(["A", "A", "B", "B"], [True, False, False, False]))
    pairs = [(e.state, e.action, e.next_state, e.chosen) for e in learner.learned]
    assert pairs == [("A", 0, "B", True), ("B", 0, "B", False)]
    assert [(e.time, e.next_time) for e in learner.learned] == [(0.0, 2.0), (2.0, 3.0)]


def test_a_touch_belongs_to_the_entry_in_which_it_was_felt():
    touches = {("robot_0", 2): (Felt(-1.0, 1.5),), ("robot_0", 3): (Felt(0.5, 2.5),)}
    learner = live(ToyHome(["A"] * 5, [True, False, True, False, False], touches))
    assert [[f.value for f in e.rewards] for e in learner.learned] == [[-1.0], [0.5]]


def test_a_touch_in_the_last_step_is_learned_from():
    touches = {("robot_0", 3): (Felt(0.5, 3.0),)}
    learner = live(ToyHome(["A"] * 4, [True, False, False, False], touches))
    assert [f.value for f in learner.learned[-1].rewards] == [0.5]


def test_a_touch_keeps_all_that_the_robot_saw_of_it():
    felt = Felt(-0.5, 1.0, "bob", False, 0.25, 0.5, 0.75)
    learner = live(ToyHome(["A"] * 2, [True, False], {("robot_0", 1): (felt,)}))
    assert learner.learned[0].rewards == (
        Reward(
            value=-0.5,
            time=1.0,
            giver="bob",
            attending=False,
            mood=0.25,
            approach_began=0.5,
            attention_began=0.75,
        ),
    )


def test_an_entry_is_attended_if_somebody_attended_at_any_time_in_it():
    home = ToyHome(["A"] * 5, [True, False, True, False, True], attentive={1})
    assert [e.attended for e in live(home).learned] == [True, False]


def test_an_entry_is_approached_if_somebody_is_on_the_way_as_it_ends():
    home = ToyHome(["A"] * 5, [True, False, True, False, True], coming={1, 4})
    assert [e.approached for e in live(home).learned] == [False, True]


def test_a_new_episode_begins_a_new_history_and_carries_nothing_over():
    home = ToyHome(["A"] * 3, [True, False, True])
    learner = Notebook()
    robots = {"robot_0": LearningRobot(learner)}
    run_episode(home, robots, seed=3)
    run_episode(home, robots)
    assert learner.episodes == 2
    assert home.seeds == [3, None]
    assert [(e.time, e.next_time) for e in learner.learned] == [(0.0, 2.0)] * 2


def test_a_robot_that_was_not_told_of_the_end_starts_anew_all_the_same():
    home = ToyHome(["A"] * 4, [True, False, False, False])
    learner = Notebook()
    robot = LearningRobot(learner)
    for _ in range(2):
        home.reset()
        while home.agents:
            home.step({"robot_0": robot.act(home, "robot_0")})
    assert learner.episodes == 2
    assert learner.learned == []
    assert len(learner.asked) == 2


def test_several_robots_each_learn_from_their_own_touches():
    touches = {("robot_1", 1): (Felt(1.0, 1.0),)}
    home = ToyHome(
        ["A"] * 3, [True, False, False], touches, names=("robot_0", "robot_1")
    )
    learners = {name: Notebook() for name in home.names}
    run_episode(home, {name: LearningRobot(one) for name, one in learners.items()})
    assert learners["robot_0"].learned[0].rewards == ()
    assert len(learners["robot_1"].learned[0].rewards) == 1


class Diary(Observer):
    def __init__(self):
        self.lines = []

    def reset(self, env, robots):
        self.lines.append("reset")

    def acted(self, env, robots):
        robot = robots["robot_0"]
        self.lines.append(robot.credits if robot.experience else "acted")

    def stepped(self, env, actions, robots):
        self.lines.append(actions["robot_0"])

    def finished(self, env, robots):
        self.lines.append(robots["robot_0"].experience.time)


def test_observers_see_each_moment_and_each_experience_once():
    diary = Diary()
    live(ToyHome(["A"] * 4, [True, False, True, False]), [diary])
    assert diary.lines == ["reset", "acted", 0, "acted", 0, (1,), 1, 2]


def test_an_observer_that_overrides_nothing_changes_nothing():
    home = ToyHome(["A", "B", "A"], [True, True, False])
    assert live(home, [Observer()]).learned == live(home).learned


def test_a_touch_of_impossible_strength_is_refused():
    with pytest.raises(ValueError, match="7"):
        live(ToyHome(["A"] * 2, [True, False], {("robot_0", 1): (Felt(7.0, 1.0),)}))

import pytest
from matplotlib.figure import Figure

from experiments.figures import SituationSequence, TouchesByPhase
from experiments.running.trial_columns import TOUCH
from household.perception.situation import Situation


@pytest.fixture
def axes():
    return Figure().subplots()


def touches(*felt):
    names = [field.name for field in TOUCH.fields]
    return [dict.fromkeys(names) | {"time": t, "value": v} for t, v in felt]


def test_situations_are_shown_by_the_time_spent_in_them(table, axes):
    seen = Situation.of({"ann": "playing"}, [("ann", "robot_0")])
    calling = [(Situation.of({"ann": "calling"}), "play", 0.0)] * 3
    unknown = (Situation.of({"ann": "unknown"}), "play", 0.0)
    frame = table([(seen, "play", 1.0), (seen, "play", 1.0), unknown, *calling])
    SituationSequence(most=2).draw_trial(axes, frame)
    assert [label.get_text() for label in axes.get_yticklabels()] == [
        "calling",
        "playing*",  # attends
    ]


def test_touches_are_counted_by_kind_and_phase(table, axes):
    felt = touches((1.0, 0.5), (2.0, -0.5), (3.9, -0.5), (4.0, 0.5), (5.0, 0.1))
    frame = table(
        [(Situation.of({"ann": "reading"}), "play", 1.0)] * 4,
        touches=[felt, [], [], []],
    )
    TouchesByPhase(boundary=4.0).draw_trial(axes, frame)
    assert [bar.get_height() for bar in axes.patches] == [1.0, 2.0, 2.0, 0.0]
    names = [text.get_text() for text in axes.get_legend().get_texts()]
    assert names == ["caresses", "taps"]

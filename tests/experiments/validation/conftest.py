import numpy as np
import pytest

from experiments.validation.diary import Diary


@pytest.fixture
def diary():
    """Makes a diary by hand: two people and a robot that stand apart and look right.

    Moments are a second apart, from 0 s on.
    """

    def make(moments=10, touches=(), judgements=(), **changes):
        n, spots = 3, [[0.0, 0.0], [4.0, 0.0], [2.0, 2.0]]
        usual = {
            "time": np.arange(moments, dtype=float),
            "position": np.array([spots] * moments),
            "heading": np.zeros((moments, n)),
            "gaze": np.zeros((moments, n)),
            "eyes_open": np.ones((moments, 2), bool),
            "attention": np.full((moments, n, n), 0.5),
        }
        told = usual | changes
        return Diary(touches=tuple(touches), judgements=tuple(judgements), **told)

    return make

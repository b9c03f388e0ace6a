import numpy as np
import pytest
from matplotlib.image import imread

pytest.importorskip("pygame")

from experiments.docs_tools import gallery


@pytest.fixture
def picture_at(tmp_path, monkeypatch):
    """Takes a picture of a party after so many decisions, shape (480, 640, 4)."""

    def take(moment):
        monkeypatch.setattr(gallery, "MOMENT", moment)
        path = tmp_path / f"party_{moment}.png"
        gallery.take("party", path)
        return imread(path)

    return take


def test_a_picture_shows_the_scenario_at_its_moment(picture_at):
    begun, later = picture_at(0), picture_at(20)
    assert begun.shape == later.shape == (480, 640, 4)
    assert len(np.unique(later.reshape(-1, 4), axis=0)) > 10
    moved = (begun != later).any(axis=-1)
    assert 0.01 < moved.mean() < 0.5  # People and what they see, not their home.


def test_the_same_moment_gives_the_same_picture(picture_at):
    assert np.array_equal(picture_at(20), picture_at(20))

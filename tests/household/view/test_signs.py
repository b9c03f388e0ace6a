import numpy as np

from household.activity import Activity
from household.view.signs import POINTS, SIGNS


def test_every_activity_has_a_sign_of_its_own_that_fits_into_a_body():
    assert SIGNS.shape == (len(Activity), POINTS, 2)
    assert len({sign.tobytes() for sign in SIGNS}) == len(Activity)
    assert np.hypot(*SIGNS.reshape(-1, 2).T).max() < 0.85

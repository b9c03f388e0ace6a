import numpy as np
import pytest

from household import household_v0
from household.perception.approach import faces


@pytest.mark.parametrize(
    ("heading", "way", "expected"),
    [
        (0.0, (2.0, 0.0), True),
        (0.0, (2.0, 1.0), True),  # 27 degrees aside
        (0.0, (2.0, 1.3), False),  # 33 degrees
        (0.0, (-2.0, 0.0), False),
        (np.pi / 2, (0.0, 5.0), True),
        (3.0, (-2.0, -0.2), True),  # across the cut of the angle at 180 degrees
    ],
)
def test_a_body_faces_what_lies_within_30_degrees_ahead(heading, way, expected):
    assert faces(np.array([heading]), np.array([way])).tolist() == [expected]


def test_who_walks_over_to_tap_the_robot_is_seen_coming():
    env = household_v0.parallel_env(scenario="experiment_4")
    env.reset(seed=3)
    play = env.unwrapped.behaviors.index("play")
    seen, walked, unwarned = set(), 0, 0
    for _ in range(600):
        env.step({"robot_0": play})
        if env.unwrapped.approached("robot_0"):
            seen.add(env.unwrapped.decision)
        for touch in env.unwrapped.feedback("robot_0"):
            began = touch.approach_began
            if began is not None and touch.time - began > 2.0:
                walked += 1
                unwarned += not any(began <= second <= touch.time for second in seen)
    assert walked > 0
    assert unwarned == 0

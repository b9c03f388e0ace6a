"""Teach the robots something new to do, and say what people think of it."""

from collections import Counter

from household import household_v0
from household.scenario import Behavior, Norm

singing = Behavior(
    description="Hums a tune",
    duration=5.0,  # seconds
    loudness=62.0,  # dB at 1 m; talk is about 60
    salience=1.2,  # how strongly it draws the eye; 1 is a person standing still
    motion="follow",  # or still, spin, wander, retreat, fetch
)
norms = {
    "playing": Norm(attending={"sing": 0.9}, absorbed={"sing": 0.4}),
    "calling": Norm(attending={"sing": -0.6}, absorbed={"sing": -0.9}),
}
env = household_v0.parallel_env(
    "experiment_4",  # somebody plays, then telephones
    behaviors=("sleep", "sing"),
    behavior={"sing": singing},
    norms=norms,  # what is not named here is neither polite nor impolite
    max_cycles=600,
)
env.reset(seed=7)
touches = Counter()
while env.agents:
    env.step({"robot_0": env.behaviors.index("sing")})
    for touch in env.feedback("robot_0"):
        touches[str(env.situation("robot_0")), touch.kind] += 1
for (situation, kind), times in touches.most_common():
    print(f"{situation}: {kind}, {times} times")

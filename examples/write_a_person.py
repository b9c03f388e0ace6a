"""Give one person of a family a mind of your own."""

from functools import partial

from household import household_v0
from household.people import Intention, Mind


class Grump(Mind):
    """Stays in one place until it was annoyed ten times, then goes to bed.

    Args:
        place: Where it likes to be: the name of a place, or an activity.
    """

    def __init__(self, place):
        self.place = place

    def reset(self, rng):
        """Begins an episode."""
        self.annoyed, self.wish = 0, None
        return Intention(place=self.place)

    def decide(self, percept):
        """Taps whatever robot annoys it, and looks at a robot that it hears."""
        if percept.touched:  # its hand has reached the robot
            self.wish = None
        for appraisal in percept.appraisals:
            if appraisal.value < 0.0:
                self.annoyed += 1
                self.wish = appraisal.wish("tap", strength=0.5)
        place = self.place if self.annoyed < 10 else "sleeping"
        hears = percept.hears_how_loud("robot_0") > 40.0
        return Intention(place, "robot_0" if hears else "father", wish=self.wish)


env = household_v0.parallel_env(
    "evening",
    minds={"mother": partial(Grump, place="armchair")},  # everybody else is as always
    max_cycles=300,
)
env.reset(seed=7)
touches = []
while env.agents:
    env.step({"robot_0": env.behaviors.index("bark")})
    touches += env.feedback("robot_0")
print(*touches, sep="\n")
print(env.situation("robot_0"))

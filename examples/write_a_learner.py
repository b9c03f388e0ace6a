"""Write a learner of your own, let it learn in a home, and keep what it learned."""

from dataclasses import dataclass, field

import numpy as np

from household import household_v0
from learners import CreditedLearner, load, saved
from learners.exploration import EpsilonGreedy
from policies.learning import LearningRobot, run_episode


@saved  # so that it can be saved and loaded
@dataclass(eq=False)
class LastTouch(CreditedLearner):
    """Expects of a behavior what it brought last time, in the same situation.

    The base class checks and keeps the history, says which past behavior each touch is
    about (`credit=`), and chooses (`exploration=`).

    Attributes:
        forgetting: Share of a value that is lost with every entry without a touch.
    """

    forgetting: float = field(default=0.02, kw_only=True)

    def _absorb(self, credits):
        for credit in credits:
            touch = credit.reward  # None: the entry passed in silence
            value, giver = (touch.value, touch.giver) if touch else (0.0, None)
            for entry, share in credit.shares:
                step = share if touch else self.forgetting
                for cell in self.memory.taught(entry.state, giver):
                    self.memory.move(cell, entry.action, value, step, share)


env = household_v0.parallel_env("experiment_4", max_cycles=1200)
learner = LastTouch(
    len(env.behaviors),
    np.random.default_rng(1),
    exploration=EpsilonGreedy(epsilon=0.1),
)
print(*env.behaviors)
run_episode(env, {"robot_0": LearningRobot(learner)}, seed=7)
for situation in learner.table:
    values = learner.q_values(situation)
    print(situation, *(f"{v:+.2f}" for v in values), sep="  ")

learner.save("last_touch.json")
again = load("last_touch.json")  # goes on exactly as the saved one would
print(again.act(situation) == learner.act(situation))

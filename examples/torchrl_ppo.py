"""PPO of TorchRL in held homes; needs the extra `torchrl`."""

from torchrl.envs import PettingZooWrapper

from household import held, household_v0
from household.scenario.family import draw

OBSERVATION, ACTION = ("robot", "observation"), ("robot", "action")
LOGITS, VALUE = ("robot", "logits"), ("robot", "state_value")
FRAMES, EPOCHS, MINIBATCH = 1024, 4, 256


def home(seed):
    """A home in which the robot chooses only when its behavior is over."""
    env = held(household_v0.parallel_env(draw("quiet_work", seed)))
    return PettingZooWrapper(env, return_state=False, categorical_actions=True)

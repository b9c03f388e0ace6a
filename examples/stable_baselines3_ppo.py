"""PPO of Stable-Baselines3 in many homes at once; needs the extra `sb3`."""

import numpy as np
from sb3_contrib import MaskablePPO
from stable_baselines3.common.callbacks import BaseCallback

from household import vector
from household.scenario.family import draw
from household.vector.sb3 import HouseholdVecEnv


class Curve(BaseCallback):
    """Notes robot-hours and reward a minute of everything between two updates."""

    def __init__(self):
        super().__init__()
        self.points, self._rewards = [], []

    def _on_step(self):
        self._rewards.append(self.locals["rewards"].mean())
        return True

    def _on_rollout_end(self):
        self.points.append((self.num_timesteps / 3600, 60 * np.mean(self._rewards)))
        self._rewards.clear()


def train(steps, seed=0, n_homes=16):
    """Returns a policy and its learning curve: robot-hours, reward a minute."""
    drawn = [draw("quiet_work", 1000 + home) for home in range(n_homes)]
    env, curve = HouseholdVecEnv(vector.make(drawn)), Curve()
    # It uses the masks of the homes: no behavior is interrupted.
    model = MaskablePPO(
        "MlpPolicy",
        env,
        n_steps=128,
        batch_size=512,
        n_epochs=4,
        gamma=0.98,
        ent_coef=0.01,
        learning_rate=5e-4,
        policy_kwargs={"net_arch": [128, 128]},
        seed=seed,
    )
    model.learn(steps, callback=curve)
    env.close()

    def policy(observation, agent):
        return int(model.predict(observation, deterministic=True)[0])

    return policy, curve.points


if __name__ == "__main__":
    for hours, reward in train(200_000)[1]:
        print(f"{hours:5.1f} robot-hours: reward {reward:+.2f} a minute")

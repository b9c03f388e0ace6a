"""PPO of Ray RLlib (new API stack) in held homes; needs the extra `rllib`."""

import numpy as np
import ray
import torch
from ray.rllib.algorithms.ppo import PPOConfig
from ray.rllib.core.columns import Columns
from ray.rllib.core.rl_module.default_model_config import DefaultModelConfig
from ray.rllib.env.wrappers.pettingzoo_env import ParallelPettingZooEnv
from ray.tune.registry import register_env

from household import held, household_v0
from household.scenario.family import draw

MINUTES = 20  # an episode of these homes


def home(config):
    """A home of its own for each place; robots choose when their behavior is over."""
    seed = 1000 + (config.vector_index or 0)
    return ParallelPettingZooEnv(
        held(household_v0.parallel_env(draw("quiet_work", seed)))
    )


def train(steps, seed=0, n_homes=16):
    """Returns a policy and its learning curve: robot-hours, reward a minute.

    A step is a choice, after which a behavior lasts several seconds.
    """
    ray.init(address="local", num_cpus=1, include_dashboard=False, log_to_driver=False)
    register_env("home", home)
    config = (
        PPOConfig()
        .environment("home")
        .env_runners(num_env_runners=0, num_envs_per_env_runner=n_homes)
        .multi_agent(policies={"all"}, policy_mapping_fn=lambda agent, *_, **__: "all")
        .rl_module(model_config=DefaultModelConfig(fcnet_hiddens=[128, 128]))
        .training(
            train_batch_size_per_learner=1024,
            minibatch_size=256,
            num_epochs=4,
            gamma=0.9,
            lr=5e-4,
            entropy_coeff=0.01,
        )
        .reporting(metrics_num_episodes_for_smoothing=n_homes)
        .debugging(seed=seed)
    )
    algorithm, curve, done, counted, hours = config.build_algo(), [], 0, 0, 0.0
    while done < steps:
        told = algorithm.train()["env_runners"]
        done = told["num_env_steps_sampled_lifetime"]
        if told.get("episode_return_mean", np.nan) > -np.inf:  # if any has ended
            hours += (done - counted) / told["episode_len_mean"] * MINUTES / 60
            curve.append((hours, told["episode_return_mean"] / MINUTES))
            counted = done
    module = algorithm.get_module("all")
    algorithm.stop()
    ray.shutdown()

    def policy(observation, agent):
        batch = {Columns.OBS: torch.from_numpy(observation)[None]}
        logits = module.forward_inference(batch)[Columns.ACTION_DIST_INPUTS]
        return int(np.argmax(logits[0].detach().numpy()))

    return policy, curve


if __name__ == "__main__":
    for hours, reward in train(30_000)[1]:
        print(f"{hours:5.1f} robot-hours: reward {reward:+.2f} a minute")

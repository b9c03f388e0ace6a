"""PPO in one file, after CleanRL's, in many homes at once; needs PyTorch alone."""

import numpy as np
import torch
from torch import nn
from torch.distributions import Categorical

from household import vector
from household.scenario.family import draw

LENGTH, EPOCHS, MINIBATCH = 128, 4, 512
GAMMA, LAMBDA, CLIP, ENTROPY, RATE = 0.98, 0.95, 0.2, 0.01, 5e-4


def network(n_in, n_out):
    """Two hidden layers."""
    hidden = (nn.Linear(n_in, 128), nn.Tanh(), nn.Linear(128, 128), nn.Tanh())
    return nn.Sequential(*hidden, nn.Linear(128, n_out))


def train(steps, seed=0, n_homes=16, family="quiet_work", held=True, draws=False):
    """Returns a policy and its learning curve: robot-hours, reward a minute."""
    torch.manual_seed(seed)
    drawn = [draw(family, 1000 + home) for home in range(n_homes)]
    homes = vector.make(drawn, seed=seed)
    n, size = homes.num_envs, homes.single_observation_space.shape[0]
    actor, critic = network(size, len(homes.behaviors)), network(size, 1)
    weights = [*actor.parameters(), *critic.parameters()]
    optimizer = torch.optim.Adam(weights, lr=RATE, eps=1e-5)
    (x, infos), curve = homes.reset(), []
    for update in range(steps // (n * LENGTH)):
        rows = []
        for _ in range(LENGTH):
            # Held, it chooses only when a choice is due: nothing is interrupted.
            mask = torch.from_numpy((infos["action_mask"] == 1) | (not held))
            x = torch.from_numpy(x)
            with torch.no_grad():
                chances = Categorical(logits=actor(x).masked_fill(~mask, -1e9))
                action, value = chances.sample(), critic(x)[:, 0]
            before, log = x, chances.log_prob(action)
            x, reward, _, cut, infos = homes.step(action.numpy())
            after = x.copy()
            if cut.any():  # nobody is ever terminated: the last value counts, too
                after[cut] = np.stack(infos["final_obs"][cut])
            with torch.no_grad():
                beyond = critic(torch.from_numpy(after))[:, 0]
            told = (torch.from_numpy(reward).float(), torch.from_numpy(cut).float())
            rows.append((before, mask, action, log, value, beyond, *told))
        columns = map(torch.stack, zip(*rows, strict=True))
        o, masks, a, old, values, beyonds, rewards, cuts = columns
        curve.append(((update + 1) * n * LENGTH / 3600, 60 * rewards.mean().item()))
        errors, ahead = rewards + GAMMA * beyonds - values, torch.zeros(n)
        advantages = torch.zeros_like(errors)
        for t in reversed(range(LENGTH)):
            ahead = errors[t] + GAMMA * LAMBDA * (1 - cuts[t]) * ahead
            advantages[t] = ahead
        batch = (o, masks, a, old, advantages, advantages + values)
        batch = [each.flatten(0, 1) for each in batch]
        order = torch.cat([torch.randperm(n * LENGTH) for _ in range(EPOCHS)])
        for rows in order.split(MINIBATCH):
            seen, mask, a, old, gain, target = (each[rows] for each in batch)
            chances = Categorical(logits=actor(seen).masked_fill(~mask, -1e9))
            ratio = (chances.log_prob(a) - old).exp()
            gain = gain / (gain.std() + 1e-8)
            gain = torch.min(ratio * gain, ratio.clamp(1 - CLIP, 1 + CLIP) * gain)
            error = (critic(seen)[:, 0] - target).square()
            loss = error / 2 - gain - ENTROPY * chances.entropy()
            optimizer.zero_grad()
            loss.mean().backward()
            nn.utils.clip_grad_norm_(weights, 0.5)
            optimizer.step()
    homes.close()
    choose = (lambda x: Categorical(logits=x).sample()) if draws else torch.argmax
    return lambda seen, agent: int(choose(actor(torch.from_numpy(seen)))), curve


if __name__ == "__main__":
    for hours, reward in train(200_000)[1]:
        print(f"{hours:5.1f} robot-hours: reward {reward:+.2f} a minute")

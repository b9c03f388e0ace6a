"""PPO of TorchRL in many homes at once; needs the extra `torchrl`."""

import torch
from tensordict.nn import TensorDictModule
from torch import nn
from torchrl.collectors import Collector
from torchrl.envs import DTypeCastTransform, GymWrapper, TransformedEnv
from torchrl.modules import MaskedCategorical, ProbabilisticActor, ValueOperator
from torchrl.objectives import ClipPPOLoss
from torchrl.objectives.value import GAE

from household import vector
from household.scenario.family import draw

LENGTH, EPOCHS, MINIBATCH = 128, 4, 512


def network(n_in, n_out):
    """Two hidden layers."""
    hidden = (nn.Linear(n_in, 128), nn.Tanh(), nn.Linear(128, 128), nn.Tanh())
    return nn.Sequential(*hidden, nn.Linear(128, n_out))


def train(steps, seed=0, n_homes=16):
    """Returns a policy and its learning curve: robot-hours, reward a minute."""
    torch.manual_seed(seed)
    drawn = [draw("quiet_work", 1000 + home) for home in range(n_homes)]
    homes = vector.make(drawn, seed=seed)
    size, n_behaviors = homes.single_observation_space.shape[0], len(homes.behaviors)
    env = TransformedEnv(
        GymWrapper(homes, categorical_action_encoding=True),
        DTypeCastTransform(torch.int8, torch.bool, in_keys=["action_mask"]),
    )
    logits = network(size, n_behaviors)
    actor = ProbabilisticActor(
        TensorDictModule(logits, in_keys=["observation"], out_keys=["logits"]),
        # The mask leaves a choice only when one is due: nothing is interrupted.
        in_keys={"logits": "logits", "mask": "action_mask"},
        distribution_class=MaskedCategorical,
        spec=env.full_action_spec,
        return_log_prob=True,
    )
    critic = ValueOperator(network(size, 1), in_keys=["observation"])
    loss_of = ClipPPOLoss(actor, critic, entropy_coeff=0.01, normalize_advantage=True)
    advantage_of = GAE(gamma=0.98, lmbda=0.95, value_network=critic)
    optimizer = torch.optim.Adam(loss_of.parameters(), lr=5e-4)
    n_frames = homes.num_envs * LENGTH
    collector = Collector(
        env, actor, frames_per_batch=n_frames, total_frames=steps // n_frames * n_frames
    )
    curve = []
    for batch in collector:
        hours = (len(curve) + 1) * n_frames / 3600
        curve.append((hours, 60 * batch["next", "reward"].mean().item()))
        for _ in range(EPOCHS):
            with torch.no_grad():
                advantage_of(batch)
            rows = batch.reshape(-1)
            for chosen in torch.randperm(n_frames).split(MINIBATCH):
                losses = loss_of(rows[chosen])
                named = ("loss_objective", "loss_critic", "loss_entropy")
                loss = sum(losses[name] for name in named)
                optimizer.zero_grad()
                loss.backward()
                nn.utils.clip_grad_norm_(loss_of.parameters(), 0.5)
                optimizer.step()
    collector.shutdown()
    return lambda seen, agent: int(logits(torch.from_numpy(seen)).argmax()), curve


if __name__ == "__main__":
    for hours, reward in train(200_000)[1]:
        print(f"{hours:5.1f} robot-hours: reward {reward:+.2f} a minute")

"""Social reinforcement learning on any hashable state; knows nothing of a household."""

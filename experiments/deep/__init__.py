"""Neural baselines (extra `deep`); nothing else imports PyTorch."""

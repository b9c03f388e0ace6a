"""How simulated people and baseline robots decide, and how a learner meets a robot."""

"""`household record`: data sets that Minari reads."""

import numpy as np
import pytest

from experiments.cli import main

EPISODES = ("record", "evening", "--episodes", "2", "--decisions", "30")


def test_a_learner_that_was_not_trained_is_refused(capsys):
    assert main([*EPISODES, "--policy", "designated"]) == 2
    assert "household train" in capsys.readouterr().err


def test_wrong_numbers_are_refused(capsys):
    assert main(["record", "evening", "--episodes", "0"]) == 2
    assert "--episodes must be at least 1" in capsys.readouterr().err


class TestWithMinari:
    @pytest.fixture(scope="class")
    def folder(self, tmp_path_factory):
        pytest.importorskip("minari", reason="the extra `minari` is not installed")
        folder = tmp_path_factory.mktemp("data")
        assert main([*EPISODES, "--out", str(folder)]) == 0
        return folder

    @pytest.fixture
    def stored(self, folder, monkeypatch):
        import minari

        monkeypatch.setenv("MINARI_DATASETS_PATH", str(folder))
        return minari.load_dataset("household/evening-v0")

    def test_minari_reads_an_episode_of_each_robot(self, stored):
        assert (stored.total_episodes, stored.total_steps) == (4, 120)
        for episode in stored.iterate_episodes():
            assert episode.observations.shape == (31, *stored.observation_space.shape)
            assert stored.action_space.contains(episode.actions[0])
            assert episode.truncations.tolist() == [False] * 29 + [True]
            assert not episode.terminations.any()
            assert episode.infos["action_mask"].shape == (31, 8)

    def test_what_minari_reads_is_what_robots_lived_through(self, stored):
        from experiments.scoring.batches import lived
        from experiments.scoring.policies import at_random
        from household import household_v0

        env = household_v0.parallel_env("evening", max_cycles=30)
        policy = at_random(np.random.default_rng(0))
        batches = [b for seed in (0, 1) for b in lived(env, policy, seed)]
        for episode, batch in zip(stored.iterate_episodes(), batches, strict=True):
            np.testing.assert_array_equal(episode.observations, batch.observations)
            np.testing.assert_array_equal(episode.actions, batch.actions)
            np.testing.assert_array_equal(episode.rewards, batch.rewards)

    def test_a_data_set_is_not_written_over(self, folder, capsys):
        assert main([*EPISODES, "--out", str(folder)]) == 2
        assert "household/evening-v0" in capsys.readouterr().err

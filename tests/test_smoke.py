"""A little of everything, through every dependency: what `make oldest` runs.

It takes the oldest versions that are allowed, so nothing here may need newer ones.
"""

import re
import tomllib
from pathlib import Path

import numpy as np
import pytest
from pettingzoo.test import api_test, parallel_api_test

import household
from experiments.cli import main
from household import household_v0, vector
from household.home.floorplan import load_floorplan
from household.home.saving import save_floorplan
from household.home.sources.generator import generate
from household.replay import RecordEpisodes
from household.replay.reading import read_replay

ROOT = Path(__file__).parents[1]


def test_the_oldest_versions_are_those_that_the_package_allows():
    with (ROOT / "pyproject.toml").open("rb") as file:
        needed = tomllib.load(file)["project"]["dependencies"]
    allowed = dict(re.match(r"([\w-]+)>=([\d.]+)", each).groups() for each in needed)
    lines = (ROOT / "tests" / "oldest.txt").read_text("utf-8").splitlines()
    oldest = dict(line.split("==") for line in lines if not line.startswith("#"))
    assert set(oldest) == set(allowed)
    for name, version in oldest.items():
        assert f"{version}.".startswith(f"{allowed[name]}.")


def test_pettingzoos_tests_pass():
    parallel_api_test(household_v0.parallel_env("evening", max_cycles=50))
    api_test(household_v0.env("evening", max_cycles=50))
    api_test(household.held(household_v0.env("evening", max_cycles=50)))


def test_many_homes_live_in_several_processes():
    envs = vector.make("evening", homes=2, workers=1, seed=1, max_cycles=3)
    envs.reset()
    for _ in range(3):
        observations, _, _, cuts, infos = envs.step(np.zeros(envs.num_envs, int))
    assert cuts.all()
    assert observations in envs.observation_space
    assert infos["_final_obs"].all()
    envs.close()


def test_an_episode_is_recorded_and_read_back(tmp_path):
    env = RecordEpisodes(household_v0.parallel_env("evening", max_cycles=20), tmp_path)
    env.reset(seed=1)
    while env.agents:
        env.step(dict.fromkeys(env.agents, 0))
    env.close()
    replay = read_replay(tmp_path / "episode_00000.rrd", tried=True)
    last = env.unwrapped.simulation.crowd.position
    assert np.array_equal(replay.snapshot(20).position, last)


def test_a_home_is_written_and_read_back(tmp_path):
    plan = generate(1, rooms=3)
    save_floorplan(plan, tmp_path / "home.toml")
    assert load_floorplan(str(tmp_path / "home.toml")) == plan


def test_an_experiment_runs_from_the_command_to_its_report(tmp_path, capsys):
    # What is there is not made again: films take longest and need an extra.
    film = tmp_path / "replays" / "experiment_1_seed_0.mp4"
    film.parent.mkdir()
    film.touch()
    words = ["reproduce", "1", "--seeds", "1", "--workers", "1", "--out", str(tmp_path)]
    assert main(words) == 0
    assert film.read_bytes() == b""
    assert (tmp_path / "report.html").read_text("utf-8").startswith("<!")
    assert "experiment" in capsys.readouterr().out
    with pytest.raises(SystemExit):
        main(["--help"])

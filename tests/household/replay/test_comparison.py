"""Two recordings of one seed: where they part, and both in one file."""

import subprocess
from pathlib import Path

import numpy as np
import pytest
import rerun_cli
from rerun.chunk import RrdReader

from household import household_v0
from household.errors import HouseholdError
from household.replay import RecordEpisodes
from household.replay.comparison import SIDES, join, parting
from household.replay.reading import read_replay

PARTS = 23
"""The decision at which the other robot chooses something else."""


@pytest.fixture(scope="module")
def record(tmp_path_factory):
    """Records an episode in which the robot changes its mind at a decision, if any."""

    def make(changes=None, *, seed=5, scenario="experiment_5"):
        base = household_v0.parallel_env(scenario, max_cycles=60)
        folder = tmp_path_factory.mktemp("run")
        env = RecordEpisodes(base, str(folder))
        env.reset(seed=seed)
        while env.agents:
            late = changes is not None and base.decision >= changes
            env.step(dict.fromkeys(env.agents, 1 if late else 0))
        env.close()
        return folder / "episode_00000.rrd"

    return make


@pytest.fixture(scope="module")
def one(record):
    return record()


@pytest.fixture(scope="module")
def other(record):
    return record(PARTS)


def test_recordings_of_one_seed_are_equal_also_to_reruns_own_comparison(record, one):
    again = record()
    assert parting(read_replay(one, tried=True), read_replay(again, tried=True)) is None
    assert compared(one, again).returncode == 0


def test_reruns_own_comparison_tells_others_apart(one, other):
    assert compared(one, other).returncode != 0


def compared(*files):
    """Rerun's comparison, without touches: what nobody saw is NaN, equal to nothing."""
    left = []
    for number, file in enumerate(files):
        left.append(file.with_name(f"without_{number}.rrd"))
        done = rerun("filter", "--drop-entity", "/touches", "-o", left[-1], file)
        assert done.returncode == 0, done.stderr
    return rerun("compare", "--unordered", *left)


def rerun(*words):
    binary = Path(rerun_cli.__file__).with_name("rerun")
    return subprocess.run([binary, "rrd", *words], capture_output=True, check=False)


def test_they_part_in_the_step_after_the_first_other_choice(one, other):
    replays = read_replay(one, tried=True), read_replay(other, tried=True)
    parted = parting(*replays)
    assert parted.decision == PARTS + 1
    assert parted.time == (PARTS + 1) * replays[0].scenario.decision_period
    assert {"behavior", "begun"} <= set(parted.what)
    names = replays[0].scenario.behaviors
    assert parted.behaviors == (("robot_0", names[0], names[1]),)
    assert f"robot_0: {names[0]} or {names[1]}" in str(parted)
    one_way, other_way = (replay.moments.position[: PARTS + 1] for replay in replays)
    assert np.array_equal(one_way, other_way)


def test_other_seeds_differ_from_the_beginning(record, one):
    parted = parting(
        read_replay(one, tried=True), read_replay(record(seed=6), tried=True)
    )
    assert parted.decision < 5
    assert parted.what


def test_both_are_in_one_file_with_the_moment_marked(one, other, tmp_path):
    out = tmp_path / "two.rrd"
    parted = join(one, other, out)
    chunks = list(RrdReader(str(out)).stream())
    paths = {chunk.entity_path.strip("/") for chunk in chunks}
    own = {
        chunk.entity_path.strip("/")
        for chunk in RrdReader(str(one)).stream()
        if "__properties" not in chunk.entity_path
    }
    for side in SIDES:
        assert {f"{side}/{path}" for path in own} <= paths
    (mark,) = [chunk for chunk in chunks if chunk.entity_path.strip("/") == "parting"]
    batch = mark.to_record_batch()
    assert batch.column("decision").to_pylist() == [parted.decision]


def test_both_sides_keep_their_own_exact_numbers(one, other, tmp_path):
    out = tmp_path / "two.rrd"
    join(one, other, out)
    for side, path in zip(SIDES, (one, other), strict=True):
        found = [
            chunk.to_record_batch()
            for chunk in RrdReader(str(out)).stream()
            if chunk.entity_path.strip("/") == f"{side}/state"
        ]
        own = [
            chunk.to_record_batch()
            for chunk in RrdReader(str(path)).stream()
            if chunk.entity_path.strip("/") == "state"
        ]
        assert sum(batch.num_rows for batch in found) == sum(b.num_rows for b in own)


def test_different_homes_are_refused_by_name(one, record, tmp_path):
    strange = record(scenario="experiment_1")
    with pytest.raises(HouseholdError, match=r"differ in person names .* be compared"):
        join(one, strange, tmp_path / "two.rrd")
    assert not (tmp_path / "two.rrd").exists()

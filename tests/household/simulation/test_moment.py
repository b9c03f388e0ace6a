"""The record of a moment, and what derives from its declaration."""

import re
from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest

from household.feedback import Feedback, reward
from household.simulation.moment import (
    DECISION,
    FIELDS,
    Moment,
    field_of,
    record_type,
    recorded,
    recorded_types,
)
from household.simulation.snapshot import snapshot

DOCS = Path(__file__).parents[3] / "docs" / "replay.md"


@pytest.fixture
def busy(busy_home, random_actions):
    """A household in the middle of an episode."""
    busy_home.reset(seed=3)
    for _, actions in zip(range(40), random_actions(busy_home, 0), strict=False):
        busy_home.step(actions)
    return busy_home


def test_the_parts_of_a_simulation_work_on_its_record(busy):
    simulation, record = busy.simulation, busy.simulation.record
    held = {
        "position": simulation.crowd.position,
        "heading": simulation.crowd.heading,
        "gaze": simulation.crowd.gaze,
        "half_view": simulation.half_view,
        "activity": simulation.people.appearance.activity,
        "attends": simulation.senses.relations.attends,
        "attention": simulation.senses.relations.attention,
        "mood": simulation.people.feelings.mood,
        "behavior": simulation.robots.present.behavior,
        "begun": simulation.robots.present.decision,
        "reward": simulation.robots.rewards,
    }
    assert held.keys() == FIELDS.keys()
    for name, array in held.items():
        assert np.shares_memory(array, record)
        assert array.flags.c_contiguous
        assert array.flags.aligned
        assert array.tolist() == record[name].tolist()
    assert record[DECISION] == busy.decision == 40


def test_a_copy_of_the_record_holds_the_moment(busy):
    before, record = snapshot(busy.simulation), busy.simulation.record.copy()
    for _ in range(10):
        busy.step(dict.fromkeys(busy.agents, 1))
    held = recorded(record, busy.scenario)
    assert all(held[name].tolist() == getattr(before, name).tolist() for name in FIELDS)
    assert (snapshot(busy.simulation).position != before.position).any()


def test_going_back_to_a_checkpoint_restores_the_record(busy):
    checkpoint, before = busy.checkpoint(), busy.simulation.record.copy()
    for _ in range(10):
        busy.step(dict.fromkeys(busy.agents, 1))
    assert busy.simulation.record != before
    busy.restore(checkpoint)
    assert busy.simulation.record == before
    assert busy.simulation.record[DECISION] == busy.decision == 40


def test_a_snapshot_has_the_declared_types_and_shapes(busy):
    n_people, n_robots = len(busy.scenario.people), len(busy.scenario.robots)
    kinds, now = recorded_types(busy.scenario), snapshot(busy.simulation)
    for name, kind in kinds.items():
        array = getattr(now, name)
        assert (array.dtype, array.shape) == (kind.base, kind.shape)
    assert [kinds[name].shape for name in ("half_view", "position", "reward")] == [
        (n_people,),
        (n_people + n_robots, 2),
        (n_robots,),
    ]
    assert kinds["attention"].base == np.float32


def test_records_hold_several_moments_with_the_moment_as_the_first_axis(busy):
    records = np.zeros(3, record_type(busy.scenario))
    records[1] = busy.simulation.record
    columns, now = recorded(records, busy.scenario), snapshot(busy.simulation)
    for name, kind in recorded_types(busy.scenario).items():
        assert columns[name].shape == (3, *kind.shape)
        assert columns[name][1].tolist() == getattr(now, name).tolist()
        assert not columns[name][0].any()


def test_expecting_another_shape_or_type_of_a_quantity_is_an_error(busy):
    record = np.zeros((), record_type(busy.scenario))
    n = len(busy.scenario.people) + len(busy.scenario.robots)
    assert field_of(record, "gaze", (n,)).shape == (n,)
    with pytest.raises(ValueError, match=r"gaze: .* float64 .* not float64"):
        field_of(record, "gaze", (n + 1,))
    with pytest.raises(ValueError, match=r"gaze: .* not int64"):
        field_of(record, "gaze", (n,), np.int64)


def test_the_reward_is_the_sum_of_the_touches_in_their_order(busy):
    values = [0.1, 0.2, -0.3, 0.4, -1.0]
    touches = [
        Feedback(
            "ann", "caress" if v > 0 else "tap", abs(v), 0.0, 0.0, True, None, None
        )
        for v in values
    ]
    assert reward(touches) == 0.1 + 0.2 - 0.3 + 0.4 - 1.0
    assert reward([]) == 0.0


def test_what_a_step_returns_as_reward_is_what_is_recorded(busy_home, random_actions):
    busy_home.reset(seed=3)
    felt = 0
    for actions in random_actions(busy_home, 0):
        _, rewards, *_ = busy_home.step(actions)
        touches = [busy_home.feedback(a) for a in busy_home.possible_agents]
        assert list(rewards.values()) == [reward(each) for each in touches]
        assert snapshot(busy_home.simulation).reward.tolist() == list(rewards.values())
        felt += sum(map(len, touches))
        if not busy_home.agents:
            break
    assert felt > 20


def test_the_documentation_lists_every_quantity_with_its_shape_and_unit():
    rows = re.findall(r"^\| `(\w+)` \| (.+?) \| (.*?) \|", DOCS.read_text(), re.M)
    documented = {name: (shape, unit) for name, shape, unit in rows}
    for name, (_, how) in FIELDS.items():
        shape = ", ".join(map(str, how.axes))
        assert documented[name] == (shape, "" if how.unit == "1" else how.unit)
    assert [field.name for field in fields(Moment)] == list(FIELDS)

import math
import sys

import numpy as np
import pytest
from pettingzoo.test import render_test
from pettingzoo.utils.wrappers.record_video_parallel import RecordVideoParallel

from household import household_v0
from household.config.toml import shipped
from household.errors import HouseholdError
from household.home.floorplan import load_floorplan
from household.simulation.simulation import PERSON_RADIUS, ROBOT_RADIUS
from household.simulation.snapshot import snapshot
from household.view.colors import (
    behavior_colors,
    ink_on,
    people_colors,
    rgb,
    robot_colors,
)
from household.view.cone import RAYS, gaze_cones
from household.view.floorplan_svg import size_of
from household.view.painter import SIGN, SIZE, Painter
from household.view.raster import rasterize
from household.view.signs import SIGNS

EDGE = np.array([0.0, 0.84 * PERSON_RADIUS])
"""From the middle of a person to where its sign ends [m]."""

RIM = np.array([0.0, 0.75 * ROBOT_RADIUS])
"""From the middle of a robot to between its own color and its edge [m]."""


@pytest.fixture(autouse=True)
def no_screen(monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")


def pixel(painter, point):
    """Column and row of a place in the picture."""
    x, y = painter._at(point)
    return round(x), round(y)


def close(pixel, color):
    """Whether a pixel has a color, up to smoothing."""
    return np.abs(np.subtract(pixel, rgb(color), dtype=int)).max() <= 12


def test_pettingzoos_render_test_passes():
    render_test(household_v0.env)


def test_pettingzoos_video_wrapper_films_an_episode(tmp_path):
    env = household_v0.parallel_env(render_mode="rgb_array", max_cycles=4)
    env = RecordVideoParallel(
        env, str(tmp_path / "films"), episode_trigger=lambda _: True
    )
    env.reset(seed=1)
    while env.agents:
        env.step(dict.fromkeys(env.agents, 0))
    env.close()
    assert [path.stat().st_size > 0 for path in tmp_path.glob("films/*.mp4")] == [True]


def test_a_picture_is_480_by_640_and_the_same_for_the_same_moment(make_busy_home):
    pictures = []
    for _ in range(2):
        env = make_busy_home(render_mode="rgb_array")
        env.reset(seed=2)
        first = env.render()
        for _ in range(20):
            env.step(dict.fromkeys(env.agents, 4))
        pictures.append((first, env.render()))
    (first, later), again = pictures[0], pictures[1]
    assert first.shape == (480, 640, 3) == (*SIZE[::-1], 3)
    assert first.dtype == np.uint8
    assert (first == again[0]).all()
    assert (later == again[1]).all()
    assert (first != later).any()


def test_rendering_changes_nothing_that_happens(make_busy_home):
    ends = []
    for mode in (None, "rgb_array"):
        env = make_busy_home(render_mode=mode)
        env.reset(seed=2)
        for _ in range(20):
            env.step(dict.fromkeys(env.agents, 1))
            env.render()
        ends.append(snapshot(env.simulation))
    assert (ends[0].position == ends[1].position).all()
    assert ends[0].touches == ends[1].touches


def test_people_wear_their_own_color_and_the_sign_of_what_they_do(busy_home):
    busy_home.reset(seed=2)
    painter = Painter(busy_home.scenario)
    now = snapshot(busy_home.simulation)
    frame = painter.pixels(now)
    for i, color in enumerate(people_colors(3)):
        stroke = SIGNS[now.activity[i]]
        middle = SIGN * PERSON_RADIUS * stroke[:2].mean(axis=0)
        x, y = pixel(painter, now.position[i] + middle)
        assert close(frame[y, x], ink_on(color))
        x, y = pixel(painter, now.position[i] + EDGE)
        assert close(frame[y, x], color)


def test_robots_wear_their_own_color_inside_that_of_their_behavior(busy_home):
    busy_home.reset(seed=2)
    busy_home.step({"robot_0": 0, "robot_1": 3})
    painter = Painter(busy_home.scenario)
    now = snapshot(busy_home.simulation)
    frame = painter.pixels(now)
    doing = behavior_colors(busy_home.behaviors)
    for j, behavior in enumerate((0, 3)):
        x, y = pixel(painter, now.position[3 + j])
        assert close(frame[y, x], robot_colors(2)[j])
        x, y = pixel(painter, now.position[3 + j] + RIM)
        assert close(frame[y, x], doing[behavior])


def test_without_a_render_mode_nothing_is_drawn():
    env = household_v0.parallel_env()
    env.reset()
    assert env.render() is None
    env.close()


def test_a_missing_library_is_named_with_the_extra_to_install(monkeypatch):
    env = household_v0.parallel_env(render_mode="rgb_array")
    env.reset()
    monkeypatch.setitem(sys.modules, "pygame", None)
    with pytest.raises(HouseholdError, match=r"polite-household\[render\]"):
        env.render()


def test_a_window_can_be_closed_and_opened_again():
    import pygame

    env = household_v0.parallel_env(render_mode="human")
    for _ in range(2):
        env.reset()
        assert pygame.display.get_surface().get_size() == SIZE
        assert env.render() is None
        env.close()
        assert not pygame.display.get_init()
    env.close()


def test_gaze_ends_at_the_wall_and_at_its_reach():
    wall = np.array([[3.0, 0.0, 3.0, 2.0]])
    at, ahead = np.array([[[1.0, 1.0]]]), np.zeros((1, 1))
    half = np.full((1, 1), math.pi / 2)
    outline = gaze_cones(at, ahead, half, wall, 2.5)[0, 0]
    assert outline.shape == (RAYS + 2, 2)
    assert outline[0].tolist() == outline[-1].tolist() == [1.0, 1.0]
    # The ray to the right, straight ahead into the wall, and the one to the left.
    assert outline[1] == pytest.approx([1.0, -1.5])
    assert outline[RAYS // 2 + 1] == pytest.approx([3.0, 1.0])
    assert outline[RAYS] == pytest.approx([1.0, 3.5])


def test_closed_eyes_look_nowhere():
    at = np.array([[[1.0, 1.0]]])
    closed = np.full((1, 1), -1.0)
    outline = gaze_cones(at, np.zeros((1, 1)), closed, np.zeros((0, 4)), 2.5)
    assert (outline == 1.0).all()


@pytest.mark.parametrize("name", sorted(shipped("home")))
@pytest.mark.parametrize("scale", [33.3, 100.0])
def test_every_home_has_a_picture_of_its_size(name, scale):
    plan = load_floorplan(name)
    raster = rasterize(plan, scale)
    width, height = np.ceil(size_of(plan) * scale)
    assert raster.pixels.shape == (height, width, 3)
    assert raster.left == pytest.approx(plan.lower[0] - 0.3)
    assert raster.top == pytest.approx(plan.upper[1] + 0.3)

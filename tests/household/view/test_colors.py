"""Colors are told apart, by the color-blind as well, computed as they see them."""

from itertools import combinations

import numpy as np
import pytest

from household.config.toml import shipped
from household.scenario.validation import load_scenario
from household.view.colors import (
    BEHAVIOR_COLORS,
    behavior_colors,
    ink_on,
    people_colors,
    rgb,
    robot_colors,
)

EYES = {
    "normal": np.eye(3),
    # Machado, Oliveira and Fernandes (2009), at full severity.
    "deuteranopia": [
        [0.367322, 0.860646, -0.227968],
        [0.280085, 0.672501, 0.047413],
        [-0.011820, 0.042940, 0.968881],
    ],
    "protanopia": [
        [0.152286, 1.052583, -0.204868],
        [0.114503, 0.786281, 0.099216],
        [-0.003882, -0.048116, 1.051998],
    ],
}

TO_XYZ = np.array(
    [
        [0.4124564, 0.3575761, 0.1804375],
        [0.2126729, 0.7151522, 0.0721750],
        [0.0193339, 0.1191920, 0.9503041],
    ]
)


def linear(color):
    share = np.array(rgb(color)) / 255
    return np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)


def lab(color, eyes):
    """CIE L*a*b* of a color as somebody sees it."""
    seen = TO_XYZ @ np.clip(np.array(eyes) @ linear(color), 0, 1) / TO_XYZ.sum(axis=1)
    x, y, z = np.where(seen > (6 / 29) ** 3, np.cbrt(seen), seen * 841 / 108 + 4 / 29)
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])


def closest(colors, eyes):
    """The least distance between two of some colors (CIE 1976)."""
    seen = [lab(color, EYES[eyes]) for color in colors]
    return min(np.linalg.norm(a - b) for a, b in combinations(seen, 2))


@pytest.mark.parametrize("eyes", EYES)
def test_behaviors_are_told_apart_by_the_color_blind(eyes):
    assert closest(BEHAVIOR_COLORS.values(), eyes) >= 15


@pytest.mark.parametrize("eyes", EYES)
def test_twelve_people_and_four_robots_are_told_apart_by_the_color_blind(eyes):
    assert closest(people_colors(12) + robot_colors(4), eyes) >= 20


def test_people_and_robots_are_seen_on_black_and_on_white():
    lightness = [lab(c, np.eye(3))[0] for c in people_colors(12) + robot_colors(4)]
    assert min(lightness) > 35
    assert max(lightness) < 87


@pytest.mark.parametrize("name", sorted(shipped("scenario")))
def test_a_behavior_has_the_same_color_in_every_scenario(name):
    behaviors = load_scenario(name).behaviors
    colors = behavior_colors(behaviors)
    assert len(set(colors)) == len(behaviors)
    for behavior, color in zip(behaviors, colors, strict=True):
        assert BEHAVIOR_COLORS[behavior] == color


def test_behaviors_of_ones_own_have_colors_that_no_shipped_one_has():
    colors = behavior_colors(["dance", "bark", "sing"])
    assert len({*colors}) == 3
    assert colors[1] == BEHAVIOR_COLORS["bark"]
    assert not {colors[0], colors[2]} & set(BEHAVIOR_COLORS.values())


@pytest.mark.parametrize("color", [*people_colors(12), *BEHAVIOR_COLORS.values()])
def test_ink_on_a_color_is_legible(color):
    """The contrast of WCAG is at least that of large text."""

    def luminance(each):
        return TO_XYZ[1] @ linear(each) + 0.05

    one, other = luminance(color), luminance(ink_on(color))
    assert max(one, other) / min(one, other) >= 3

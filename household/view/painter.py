"""Rendering: a household as a picture of pixels, with pygame.

Only snapshots are drawn, so that a replay file is rendered as its episode was.
"""

from types import ModuleType
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from household.compiled.arrays import Floats
from household.errors import HouseholdError
from household.scenario.scenario import Scenario
from household.simulation.simulation import PERSON_RADIUS, ROBOT_RADIUS
from household.simulation.snapshot import Snapshot
from household.view.colors import (
    CARESS,
    IDLE,
    TAP,
    behavior_colors,
    ink_on,
    people_colors,
    rgb,
    robot_colors,
)
from household.view.cone import gaze_cones
from household.view.floorplan_svg import size_of
from household.view.labels import place_labels
from household.view.raster import rasterize
from household.view.signs import SIGNS

if TYPE_CHECKING:
    import pygame

SIZE = (640, 480)
"""Width and height of pictures, unless asked for otherwise [pixels]."""

CAPTION = 22
"""Height of the line of text below the plan, in pictures of `SIZE` [pixels]."""

SHOWN = 3.0
"""How long a touch stays visible [s]."""

BODY, PAPER = (30, 30, 30), (255, 255, 255)

SIGN = 0.62
"""Size of the sign in a person's body, as a share of its radius."""

PAD = (6, 2)
"""By how much the background of a text is larger than the text [pixels]."""

Point = tuple[float, float]

Label = tuple[str, Point, float, tuple[int, int, int]]
"""A text, of what [m], how large that is [m], and the text's color."""


def load_pygame() -> ModuleType:
    """Imports pygame.

    Raises:
        HouseholdError: If it is not installed; says what to install.
    """
    try:
        import pygame
    except ImportError:
        raise HouseholdError(
            "rendering needs pygame: pip install 'polite-household[render]'"
        ) from None
    return pygame


class Painter:
    """Paints the moments of an episode one after another.

    Args:
        scenario: The household.
        size: Width and height of the pictures [pixels].

    Raises:
        HouseholdError: If pygame is not installed.
    """

    def __init__(self, scenario: Scenario, size: tuple[int, int] = SIZE) -> None:
        self._pygame = load_pygame()
        self._scenario = scenario
        self._radii = (PERSON_RADIUS, ROBOT_RADIUS)
        self._behaviors = behavior_colors(scenario.behaviors)
        people, robots = len(scenario.people), len(scenario.robots)
        self._colors = [rgb(c) for c in people_colors(people) + robot_colors(robots)]
        width, height = size_of(scenario.plan)
        self._size, self._unit = size, min(size[0] / SIZE[0], size[1] / SIZE[1])
        self._caption = round(CAPTION * self._unit)
        scale = min(size[0] / width, (size[1] - self._caption) / height)
        self._raster = rasterize(scenario.plan, float(scale))
        pixels = self._raster.pixels.swapaxes(0, 1)
        self._home = self._pygame.surfarray.make_surface(pixels)
        self._margin = (size[0] - self._home.get_width()) / 2
        self._font = font(11 * self._unit)
        self._recent: dict[str, tuple[float, Point, str]] = {}

    def paint(self, snapshot: Snapshot) -> "pygame.Surface":
        """A picture of a moment; touches stay visible for a while."""
        surface = self._pygame.Surface(self._size)
        surface.fill(PAPER)
        surface.blit(self._home, (self._margin, 0))
        self.remember(snapshot)
        self._draw_gazes(surface, snapshot)
        labels = self.words(snapshot)
        centers, _ = self.place(labels)
        self._draw_leaders(surface, labels, centers)
        self._draw_bodies(surface, snapshot)
        self._draw_touches(surface)
        for (text, _, _, color), center in zip(labels, centers, strict=True):
            self._write(surface, text, self._at(center), color)
        caption = f"{self._scenario.name}    {snapshot.time:.0f} s"
        text = f"{caption}    decision {snapshot.decision}"
        at = 8 * self._unit, self._size[1] - self._caption + 4 * self._unit
        surface.blit(self._font.render(text, True, BODY), at)
        return surface

    def pixels(self, snapshot: Snapshot) -> NDArray[np.uint8]:
        """The same as an array of shape (height, width, 3)."""
        return pixels_of(self.paint(snapshot))

    def _at(self, point: Floats | Point) -> Point:
        """Pixels of a place [m]."""
        raster = self._raster
        return (
            self._margin + (float(point[0]) - raster.left) * raster.scale,
            (raster.top - float(point[1])) * raster.scale,
        )

    def remember(self, snapshot: Snapshot) -> None:
        """Remembers the latest touch of each robot, and forgets touches long past."""
        now, first = snapshot.time, len(self._scenario.people)
        for robot, (time, _, _) in list(self._recent.items()):
            # Later than now means that a new episode has begun.
            if not now - SHOWN < time < now:
                del self._recent[robot]
        for touch in snapshot.touches:
            index = first + self._scenario.robot_names.index(touch.robot)
            spot = self._at(snapshot.position[index])
            self._recent[touch.robot] = (now, spot, touch.feedback.kind)

    def _draw_gazes(self, surface: "pygame.Surface", snapshot: Snapshot) -> None:
        n = len(self._scenario.people)
        cones = gaze_cones(
            snapshot.position[None, :n],
            snapshot.gaze[None, :n],
            snapshot.half_view[None],
            self._scenario.plan.opaque_segments,
            self._scenario.perception.distance,
        )[0]
        layer = self._pygame.Surface(self._size, self._pygame.SRCALPHA)
        for outline, color in zip(cones, self._colors, strict=False):
            points = [self._at(point) for point in outline]
            self._pygame.draw.polygon(layer, (*color, 45), points)
            self._pygame.draw.aalines(layer, (*color, 150), True, points)
        surface.blit(layer, (0, 0))

    def _draw_bodies(self, surface: "pygame.Surface", snapshot: Snapshot) -> None:
        n = len(self._scenario.people)
        for i in range(n):
            self._draw_body(surface, snapshot, i, self._colors[i])
            self._draw_sign(surface, snapshot, i)
        for j, doing in enumerate(snapshot.behavior.tolist()):
            color = rgb(self._behaviors[doing] if doing >= 0 else IDLE)
            self._draw_body(surface, snapshot, n + j, color)

    def _draw_leaders(
        self, surface: "pygame.Surface", labels: "list[Label]", centers: Floats
    ) -> None:
        """Lines from what is named to the names."""
        for (_, spot, _, _), center in zip(labels, centers, strict=True):
            ends = self._at(spot), self._at(center)
            self._pygame.draw.aaline(surface, BODY, *ends)

    def place(self, labels: "list[Label]") -> tuple[Floats, Floats]:
        """Centers of labels where they cover least, and sizes, each (n, 2) [m]."""
        scale, raster = self._raster.scale, self._raster
        texts = [self._font.size(text) for text, _, _, _ in labels]
        sizes = np.add(texts, PAD) / scale
        left, top = raster.left - self._margin / scale, raster.top
        width, height = self._size[0], self._size[1] - self._caption
        right, bottom = left + width / scale, top - height / scale
        centers = place_labels(
            np.array([[spot for _, spot, _, _ in labels]]),
            np.array([radius for _, _, radius, _ in labels]),
            sizes[None],
            np.array([left, bottom, right, top]),
        )
        return centers[0], sizes

    def words(self, snapshot: Snapshot) -> "list[Label]":
        """What is written: the text, of what, how large that is [m], and its color."""
        scenario, n = self._scenario, len(self._scenario.people)
        texts = [*scenario.person_names, *self._robot_texts(snapshot)]
        spots = [(float(x), float(y)) for x, y in snapshot.position]
        labels = [
            (text, spot, self._radii[i >= n], BODY)
            for i, (text, spot) in enumerate(zip(texts, spots, strict=True))
        ]
        for robot, (_, _, kind) in self._recent.items():
            spot = spots[n + scenario.robot_names.index(robot)]
            labels.append((kind, spot, 1.8 * ROBOT_RADIUS, _touch_color(kind)))
        return labels

    def _robot_texts(self, snapshot: Snapshot) -> list[str]:
        behaviors = [*self._scenario.behaviors, "-"]  # Before the first choice.
        pairs = zip(self._scenario.robot_names, snapshot.behavior.tolist(), strict=True)
        return [f"{name}: {behaviors[doing]}" for name, doing in pairs]

    def _draw_sign(self, surface: "pygame.Surface", snapshot: Snapshot, i: int) -> None:
        """What a person does, as a line drawing on its body."""
        sign = SIGN * self._radii[0] * SIGNS[snapshot.activity[i]]
        points = [self._at(point) for point in sign + snapshot.position[i]]
        ink = rgb(ink_on(people_colors(i + 1)[i]))
        width = max(1, round(2 * self._unit))
        self._pygame.draw.lines(surface, ink, False, points, width)

    def _draw_body(
        self,
        surface: "pygame.Surface",
        snapshot: Snapshot,
        i: int,
        color: tuple[int, int, int],
    ) -> None:
        """A disc with a nose where the head points; a robot's own color is in it."""
        draw, robot = self._pygame.draw, i >= len(self._scenario.people)
        at = self._at(snapshot.position[i])
        radius = self._radii[robot] * self._raster.scale
        angle = float(snapshot.heading[i] if robot else snapshot.gaze[i])
        nose = (
            at[0] + 1.5 * radius * np.cos(angle),
            at[1] - 1.5 * radius * np.sin(angle),
        )
        draw.line(surface, BODY, at, nose, max(2, round(4 * self._unit)))
        draw.aacircle(surface, BODY, at, radius + 1.5)
        draw.aacircle(surface, color, at, radius)
        if robot:
            side = radius * 0.8
            box = (at[0] - side / 2, at[1] - side / 2, side, side)
            draw.rect(surface, self._colors[i], box)
            draw.rect(surface, BODY, box, 1)

    def _draw_touches(self, surface: "pygame.Surface") -> None:
        """A ring where a robot was touched, green for a caress, red for a tap."""
        radius = self._radii[1] * self._raster.scale + 7
        for _, spot, kind in self._recent.values():
            self._pygame.draw.aacircle(surface, _touch_color(kind), spot, radius, 4)

    def _write(
        self,
        surface: "pygame.Surface",
        text: str,
        at: Point,
        color: tuple[int, int, int],
    ) -> None:
        """Writes text on a light background, centered, inside the picture."""
        words = self._font.render(text, True, color)
        box = words.get_rect(center=at)
        ground = self._pygame.Surface(box.inflate(PAD).size, self._pygame.SRCALPHA)
        ground.fill((255, 255, 255, 200))
        surface.blit(ground, box.inflate(PAD))
        surface.blit(words, box)


def _touch_color(kind: str) -> tuple[int, int, int]:
    return rgb(CARESS if kind == "caress" else TAP)


class Screen:
    """What ``render`` shows: a window, or an array.

    Args:
        scenario: The household.
        mode: "human" or "rgb_array".
        fps: The most pictures that a window shows in a second.
    """

    def __init__(self, scenario: Scenario, mode: str, fps: int) -> None:
        self._painter = Painter(scenario)
        self._pygame = load_pygame()
        self._human, self._fps = mode == "human", fps
        if self._human:
            self._pygame.display.init()
            self._window = self._pygame.display.set_mode(SIZE)
            self._pygame.display.set_caption(f"Household: {scenario.name}")
            self._clock = self._pygame.time.Clock()

    def show(self, snapshot: Snapshot) -> NDArray[np.uint8] | None:
        """Shows a moment; returns it as an array, or None if there is a window."""
        if not self._human:
            return self._painter.pixels(snapshot)
        self._window.blit(self._painter.paint(snapshot), (0, 0))
        self._pygame.event.pump()
        self._pygame.display.flip()
        self._clock.tick(self._fps)
        return None

    def close(self) -> None:
        """Closes the window."""
        if self._human:
            self._pygame.display.quit()


def pixels_of(surface: "pygame.Surface") -> NDArray[np.uint8]:
    """A surface as an array of shape (height, width, 3)."""
    # Six times as fast as pygame's arrays, whose first axis is the width.
    raw = load_pygame().image.tobytes(surface, "RGB")
    return np.frombuffer(raw, np.uint8).reshape(*surface.get_size()[::-1], 3).copy()


def font(height: float) -> "pygame.font.Font":
    """A font of Matplotlib's, as pygame's own is hard to read when small.

    Args:
        height: Of its letters [pixels].
    """
    from matplotlib.font_manager import findfont

    loaded = load_pygame()
    loaded.font.init()
    letters: pygame.font.Font = loaded.font.Font(findfont("DejaVu Sans"), round(height))
    return letters

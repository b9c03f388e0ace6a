"""Films: an episode as frames with a legend and captions of its touches."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from household.view.colors import (
    CARESS,
    IDLE,
    TAP,
    behavior_colors,
    people_colors,
    rgb,
    robot_colors,
)
from household.view.figure import role_in_words
from household.view.painter import (
    BODY,
    PAPER,
    Painter,
    font,
    load_pygame,
    pixels_of,
)

if TYPE_CHECKING:
    import pygame
    from numpy.typing import NDArray

    from household.scenario.scenario import Scenario
    from household.simulation.snapshot import Snapshot, Touch

SIZE = (1280, 720)
"""Width and height of films, unless asked for otherwise [pixels]; both even."""

SHORTEST, LONGEST = 20.0, 60.0
"""What a film lasts, unless its speed is given [s]."""

MOST_FPS = 30.0
"""Frames in a second; of faster films, some moments are left out."""

LEGEND = 0.2
"""Share of the width for the legend."""

SHADE = (120, 128, 138)


@dataclass(frozen=True)
class Pace:
    """How fast a film goes.

    Attributes:
        fps: Frames in a second of film.
        every: Of how many moments one is shown.
    """

    fps: float
    every: int


def pace_of(
    n_moments: int, period: float, speed: float | None = None, most: float = MOST_FPS
) -> Pace:
    """The pace of a film.

    Args:
        n_moments: Of the episode.
        period: From one moment to the next [s].
        speed: Seconds of the episode in one of the film; None: real time if that lasts
            20 s to 60 s, or else as near to it as these allow.
        most: Frames in a second.
    """
    lasts = n_moments * period
    if speed is None:
        speed = lasts / min(max(lasts, SHORTEST), LONGEST)
    every = max(1, int(np.ceil(speed / period / most)))
    return Pace(fps=speed / period / every, every=every)


class FilmPainter:
    """Paints frames: the home, who does what, and the last touches in words.

    Args:
        scenario: The household.
        size: Width and height [pixels].
    """

    def __init__(self, scenario: Scenario, size: tuple[int, int] = SIZE) -> None:
        self._pygame = load_pygame()
        self._scenario, self._size = scenario, size
        self._beside = round(size[0] * LEGEND)
        self._painter = Painter(scenario, (size[0] - self._beside, size[1]))
        lines = len(scenario.people) + len(scenario.robots) + 10
        self._line = min(size[1] / lines, size[1] / 30)
        self._font = font(0.62 * self._line)
        self._captions: deque[tuple[str, str]] = deque(maxlen=5)

    def frames(
        self, moments: Iterable[Snapshot], every: int = 1
    ) -> Iterator[NDArray[np.uint8]]:
        """Arrays of shape (height, width, 3), of each moment or of one in several."""
        for number, moment in enumerate(moments):
            self._painter.remember(moment)
            for touch in moment.touches:
                self._captions.append((self._caption(touch), touch.feedback.kind))
            if number % every == 0:
                yield self._paint(moment)

    def _caption(self, touch: Touch) -> str:
        felt, cause = touch.feedback, touch.cause
        meant = self._scenario.behaviors[cause.behavior]
        whose = "" if cause.robot == touch.robot else f" of {cause.robot}"
        return f"{felt.time:.0f} s  {felt.giver}: {felt.kind} for {meant}{whose}"

    def _paint(self, moment: Snapshot) -> NDArray[np.uint8]:
        surface = self._pygame.Surface(self._size)
        surface.fill(PAPER)
        surface.blit(self._painter.paint(moment), (0, 0))
        left, line = self._size[0] - self._beside, self._line
        y = self._draw_legend(surface, moment, left, line)
        for text, kind in self._captions:
            self._write(surface, (left, y), text, CARESS if kind == "caress" else TAP)
            y += line
        return pixels_of(surface)

    def _draw_legend(
        self, surface: pygame.Surface, moment: Snapshot, left: float, line: float
    ) -> float:
        """Who is who and does what; returns where it ends [pixels]."""
        scenario, y = self._scenario, line
        roles = [role_in_words(int(activity)) for activity in moment.activity]
        colors = people_colors(len(roles))
        y = self._draw_rows(
            surface,
            (left, y),
            list(zip(scenario.person_names, roles, colors, strict=True)),
        )
        behaviors = behavior_colors(scenario.behaviors)
        doing = [
            (scenario.behaviors[b], behaviors[b]) if b >= 0 else ("-", IDLE)
            for b in moment.behavior.tolist()
        ]
        names = zip(scenario.robot_names, doing, strict=True)
        rows = [(name, word, color) for name, (word, color) in names]
        y = self._draw_rows(
            surface, (left, y + line / 2), rows, robot_colors(len(rows))
        )
        return y + line / 2

    def _draw_rows(
        self,
        surface: pygame.Surface,
        at: tuple[float, float],
        rows: Sequence[tuple[str, str, str]],
        inner: Sequence[str] = (),
    ) -> float:
        """Rows of a disc, a name, and what is done; returns where they end."""
        (left, y), line = at, self._line
        for k, (name, word, color) in enumerate(rows):
            center = left + 0.6 * line, y + line / 2
            self._pygame.draw.aacircle(surface, rgb(color), center, 0.34 * line)
            if inner:
                side = 0.34 * line
                box = (center[0] - side / 2, center[1] - side / 2, side, side)
                self._pygame.draw.rect(surface, rgb(inner[k]), box)
            self._write(surface, (left + 1.2 * line, y), name)
            aside = left + 1.2 * line + 0.45 * self._beside
            self._write(surface, (aside, y), word, SHADE)
            y += line
        return y

    def _write(
        self,
        surface: pygame.Surface,
        at: tuple[float, float],
        text: str,
        color: str | tuple[int, int, int] = BODY,
    ) -> None:
        ink = rgb(color) if isinstance(color, str) else color
        surface.blit(self._font.render(text, True, ink), at)

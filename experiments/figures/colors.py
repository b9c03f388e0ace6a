"""Colors of figures: one for one thing, in all figures and in the replay.

Behaviors and touches have the colors that they have in the replay; conditions and
situations have colors that nothing else has.
"""

from __future__ import annotations

from household.view.colors import BEHAVIOR_COLORS, CARESS, TAP, behavior_colors

__all__ = ["CARESS", "CONDITIONS", "SITUATIONS", "TAP", "THEMED", "behavior_colors"]

CONDITIONS = ("#332288", "#a8324a", "#73731c", "#4d8080")
"""In the order in which an experiment compares them; after Tol, for the color-blind."""

SITUATIONS = ("#3b4754", "#6d7a88", "#98a4b0", "#bcc5ce")
"""In the order of their length; gray, as the place of an activity is colored as some
behaviors are."""

THEMED = (
    {color: f"--behavior-{name}" for name, color in BEHAVIOR_COLORS.items()}
    | {color: f"--condition-{index}" for index, color in enumerate(CONDITIONS)}
    | {color: f"--situation-{index}" for index, color in enumerate(SITUATIONS)}
    | {CARESS: "--caress", TAP: "--tap"}
)
"""What a page calls them, which lightens some on a dark ground."""

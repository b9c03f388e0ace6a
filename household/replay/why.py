"""The page that tells why a robot does what it does, for the viewer.

Its bars are made of characters that the viewer's font has; with others it stops.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from household.compiled.arrays import Floats

if TYPE_CHECKING:
    from household.replay.choices import Choice

HALF = 4
"""Length of the longest bar to each side of 0 [characters]."""

BAR, CHOSEN, REFERENCE = "■", "▶", "◆"

LONGEST = 240
"""Of a situation in words; what is longer is cut [characters]."""


def page(choice: "Choice", begun: "Choice", behaviors: Sequence[str]) -> str:
    """The page as Markdown.

    Args:
        choice: What was chosen, and from what.
        begun: The choice with which the behavior began, often the same.
        behaviors: Names of all behaviors.
    """
    best = int(choice.reference.argmax())
    return "\n\n".join(
        (
            _headline(choice, begun, behaviors),
            _table(choice, behaviors, best),
            f"**Sees** {_cut(choice.situation)}",
            f"**Takes it for** {_cut(choice.represented)}"
            if choice.represented
            else "**Takes it for** what it is: this situation, by name",
            f"**Reference** {REFERENCE} {behaviors[best]} "
            f"({choice.reference[best]:+.2f}); what it does: "
            f"{choice.reference[choice.behavior]:+.2f}",
            f"**Last taught by** {choice.taught or 'nothing yet'}",
        )
    )


def _headline(choice: "Choice", begun: "Choice", behaviors: Sequence[str]) -> str:
    name = behaviors[choice.behavior]
    how = "greedy" if begun.is_greedy else "explored"
    if begun.probabilities is not None:
        how += f", probability {begun.probabilities[choice.behavior]:.0%}"
    if choice.chosen:
        return f"**{name}**, {how}"
    return f"**{name}** goes on (chosen before: {how})"


def _table(choice: "Choice", behaviors: Sequence[str], best: int) -> str:
    """Bars with value, probability, touches and updates, one line for each behavior."""
    width = max(map(len, behaviors))
    span = max(float(abs(choice.values).max()), 0.25)
    # The first line is short, since the viewer has a button at its end.
    lines = [
        f"{CHOSEN} does   {REFERENCE} best for the people   n: touches",
        f"{'':{width + 3 + 2 * HALF}} value  prob  n upd",
    ]
    for k, name in enumerate(behaviors):
        mark = CHOSEN if k == choice.behavior else " "
        mark += REFERENCE if k == best else " "
        value = float(choice.values[k])
        length = round(abs(value) / span * HALF)
        left, right = (length, 0) if value < 0 else (0, length)
        bar = f"{BAR * left:>{HALF}}|{BAR * right:<{HALF}}"
        lines.append(
            f"{mark}{name:{width}}{bar} {value:+.2f} "
            f"{_share(choice.probabilities, k)} {_count(choice.touches, k)} "
            f"{_count(choice.updates, k)}"
        )
    return "\n".join(("```", *lines, "```"))


def _share(values: Floats | None, k: int) -> str:
    return "   - " if values is None else f"{100 * values[k]:3.0f} %"


def _count(values: Floats | None, k: int) -> str:
    return "  -" if values is None else f"{values[k]:3.0f}"


def _cut(text: str) -> str:
    return text if len(text) <= LONGEST else f"{text[:LONGEST]}..."

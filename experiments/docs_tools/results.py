"""The page docs/results.md: what came out of the paper's claims, and of our own.

Run as `python -m experiments.docs_tools.results RUNS/claims.json PAGE` after

    household reproduce --out RUNS

The typical seeds are those of the trials that are stored beside the claims.
"""

from __future__ import annotations

import json
import math
import sys
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from experiments.analysis.deciding import FAILS, HOLDS, UNDECIDED
from experiments.docs_tools.pages import render
from experiments.docs_tools.typical import Typical, typical
from experiments.report.format import format_number

Finding = Mapping[str, Any]
"""What came out of a claim in one condition, as stored."""

SILENCE: Mapping[str, str] = {
    "": "learned at once, one count (the paper)",
    "silence_apart": "counted apart from touches",
    "silence_held": "held back while somebody is on the way",
    "silence_apart_held": "both",
    "skip_silence": "never learned (skip_silence)",
}
"""Control -> what it makes of silence; "" is the condition that the claim is about."""

OURS = "6"
"""First letter of the claims that are not the paper's."""


def page(findings: Sequence[Finding], trials: Sequence[Typical]) -> str:
    """Returns the page.

    Args:
        findings: As `household reproduce` stores them, in the order of the claims.
        trials: The typical one of each experiment.
    """
    paper = [one for one in findings if not one["id"].startswith(OURS)]
    own = [one for one in findings if one["id"].startswith(OURS)]
    by_claim = {one["id"]: one for one in findings}
    return render(
        "results.md.j2",
        n=max(one["n"] for one in findings),
        tally=_tally(paper),
        claims=len(_verdicts(paper)),
        rows=[_row(one) for one in paper],
        own_tally=_tally(own) if own else "",
        own=[_row(one) for one in own],
        deciding=[_deciding(one) for one in paper if one["seeds_to_decide"]],
        watching=[_watching(by_claim[claim]) for claim in ("5a", "5b")],
        silence=[_silence(by_claim, control) for control in SILENCE],
        trials=trials,
    )


def _verdicts(findings: Sequence[Finding]) -> dict[str, str]:
    """Verdict by claim: fails if it fails anywhere, holds if it holds everywhere."""
    verdicts: dict[str, str] = {}
    for one in findings:
        met = {verdicts.get(one["id"], HOLDS), one["verdict"]}
        worst = next(v for v in (FAILS, UNDECIDED, HOLDS) if v in met)
        verdicts[one["id"]] = worst
    return verdicts


def _tally(findings: Sequence[Finding]) -> str:
    counted = Counter(_verdicts(findings).values())
    total = sum(counted.values())
    said = [f"{counted[HOLDS]} of {total} claims hold"]
    if n := counted[FAILS]:
        said.append(f"{n} fails" if n == 1 else f"{n} fail")
    if n := counted[UNDECIDED]:
        said.append(f"{n} is undecided" if n == 1 else f"{n} are undecided")
    return ", ".join(said)


def _row(one: Finding) -> dict[str, str]:
    marks = {FAILS: "**fails**", UNDECIDED: "*undecided*", HOLDS: "holds"}
    standing = f", {one['standing']}" if one["standing"] else ""
    floor, ceiling = one["floor"], one["ceiling"]
    references = "none"
    if floor and ceiling:
        bounds = _write(one, floor["value"], unit=False), _write(one, ceiling["value"])
        references = ", ".join(bounds)
    return {
        "id": one["id"],
        "text": one["text"],
        "condition": one["condition"],
        "value": _write(one, one["value"]),
        "interval": _interval(one, one),
        "references": references,
        "holds_if": _rule(one),
        "verdict": marks[one["verdict"]] + standing,
    }


def _rule(one: Finding) -> str:
    threshold = _write(one, one["threshold"])
    if one["least"] is not None:
        return f"{_write(one, one['least'], unit=False)} to {threshold}"
    for third in (1, 2):
        if math.isclose(one["threshold"], third / 3):
            threshold = f"{third}/3"
    return f"{one['rule']} {threshold}"


def _deciding(one: Finding) -> str:
    return f"{one['id']} about {one['seeds_to_decide']:,}"


def _watching(one: Finding) -> dict[str, str]:
    compared = one["compared"]
    return {
        "id": one["id"],
        "holds_if": _rule(one),
        **{
            kind: _estimate(one, compared[f"{kind}_watching"])
            for kind in ("swap", "random", "persona")
        },
    }


def _silence(by_claim: Mapping[str, Finding], control: str) -> dict[str, str]:
    return {
        "what": SILENCE[control],
        **{
            f"claim_{claim}": _estimate(
                by_claim[claim],
                by_claim[claim]["compared"][control] if control else by_claim[claim],
            )
            for claim in ("4a", "5b")
        },
    }


def _estimate(one: Finding, stored: Mapping[str, float]) -> str:
    return f"{_write(one, stored['value'])} ({_interval(one, stored)})"


def _interval(one: Finding, stored: Mapping[str, float | None]) -> str:
    low, high = stored["low"], stored["high"]
    if low is None or high is None or math.isnan(low):
        return str(one["interval"])
    return f"{_write(one, low, unit=False)} to {_write(one, high)}"


def _write(one: Finding, value: float, *, unit: bool = True) -> str:
    text = format_number(value, is_share=one["unit"].startswith("share"))
    text = text.replace("\N{MINUS SIGN}", "-")
    return text if unit else text.removesuffix(" %")


if __name__ == "__main__":
    claims, out = Path(sys.argv[1]), Path(sys.argv[2])
    stored = json.loads(claims.read_text("utf-8"))
    out.write_text(page(stored, typical(claims.parent)), encoding="utf-8")

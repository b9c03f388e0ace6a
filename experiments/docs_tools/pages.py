"""Pages of the documentation that are made from stored results."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined


def render(template: str, **values: object) -> str:
    """Returns a page.

    Args:
        template: Name of a file in `templates`.
        **values: What it says. Its filters write numbers and estimates, as they are
            stored in JSON.
    """
    templates = FileSystemLoader(Path(__file__).parent / "templates")
    environment = Environment(
        loader=templates, undefined=StrictUndefined, keep_trailing_newline=True
    )
    environment.filters |= {
        "estimate": estimate,
        "interval": interval,
        "number": number,
        "whole": whole,
    }
    return environment.get_template(template).render(**values)


def estimate(stored: Mapping[str, Any]) -> str:
    """Returns a value with its interval: `0.42 [0.31, 0.50]`."""
    return f"{number(stored['value'])} [{interval(stored)}]"


def interval(stored: Mapping[str, Any]) -> str:
    """Returns the interval of an estimate; nothing where there is none."""
    if stored["low"] is None:
        return ""
    return f"{number(stored['low'])}, {number(stored['high'])}"


def number(value: float | None) -> str:
    """Returns a number with two digits; nothing where it is unknown."""
    return "" if value is None else f"{value:z.2f}"


def whole(value: float) -> str:
    """Returns a number without digits."""
    return f"{value:.0f}"

"""A Sphinx extension: docstrings of attributes as they are written here."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

if TYPE_CHECKING:
    from sphinx.application import Sphinx

BEFORE_NAPOLEON = 400
"""Priority of what is done first; Napoleon's is 500."""


def keep_colons(
    _app: object, what: str, _name: str, _obj: object, _given: object, lines: list[str]
) -> None:
    """Else Napoleon takes what stands before a colon for the type of an attribute.

    It looks at the first line alone, which from now on is an empty comment.
    """
    if what in ("attribute", "data", "property"):
        lines[:0] = ["..", ""]


def leave_out(
    _app: object, _what: str, _name: str, obj: object, *_others: object
) -> Literal[True] | None:
    """Fields of named tuples are told of in the docstring of their class."""
    return True if type(obj).__name__ == "_tuplegetter" else None


def setup(app: Sphinx) -> dict[str, Any]:
    """Listens to Sphinx as it reads docstrings."""
    app.connect("autodoc-process-docstring", keep_colons, BEFORE_NAPOLEON)
    app.connect("autodoc-skip-member", leave_out)
    return {"parallel_read_safe": True, "parallel_write_safe": True}

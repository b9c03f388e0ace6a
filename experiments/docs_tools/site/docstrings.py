"""A Sphinx extension: docstrings and signatures as people want to read them."""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING, Any, Literal, get_type_hints

from sphinx.util.inspect import stringify_signature

if TYPE_CHECKING:
    from collections.abc import Callable

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


def without_bounds(
    _app: object,
    _what: str,
    _name: str,
    obj: Callable[..., object],
    _given: object,
    shown: str,
    *_others: object,
) -> tuple[str, str] | None:
    """Signatures say what a value is; its bounds and shape are in the docstring."""
    if "Annotated[" not in (shown or ""):
        return None
    hints, signature = get_type_hints(obj), inspect.signature(obj)
    parameters = [
        one.replace(annotation=hints.get(name, one.annotation))
        for name, one in signature.parameters.items()
    ]
    returned = hints.get("return", signature.return_annotation)
    plain = signature.replace(parameters=parameters, return_annotation=returned)
    return stringify_signature(plain, unqualified_typehints=True), ""


def setup(app: Sphinx) -> dict[str, Any]:
    """Listens to Sphinx as it reads docstrings."""
    app.connect("autodoc-process-docstring", keep_colons, BEFORE_NAPOLEON)
    app.connect("autodoc-skip-member", leave_out)
    app.connect("autodoc-process-signature", without_bounds)
    return {"parallel_read_safe": True, "parallel_write_safe": True}

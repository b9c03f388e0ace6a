"""Docstrings reach the API reference as they are written."""

from typing import NamedTuple

from sphinx.ext.napoleon import Config
from sphinx.ext.napoleon.docstring import GoogleDocstring

from experiments.docs_tools.site.docstrings import keep_colons, leave_out


class Pair(NamedTuple):
    """Two of a kind."""

    one: int
    other: int = 0


def test_a_colon_in_the_docstring_of_an_attribute_is_no_type():
    lines = ["In place of a seed: a home goes on."]
    keep_colons(None, "data", "room.GO_ON", -1, None, lines)
    read = GoogleDocstring(lines, Config(), what="data", name="room.GO_ON")
    assert "In place of a seed: a home goes on." in str(read)
    assert ":type:" not in str(read)


def test_fields_of_named_tuples_are_left_out_and_nothing_else():
    assert leave_out(None, "attribute", "one", Pair.one, False, None)
    assert leave_out(None, "method", "count", Pair.count, False, None) is None

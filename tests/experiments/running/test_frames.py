"""Facts about frames that are made of rows."""

import polars as pl
from hypothesis import given
from hypothesis import strategies as st

from experiments.running.frames import frame_of

KINDS = {
    "when": pl.Float64,
    "who": pl.String,
    "touches": pl.List(pl.Struct({"giver": pl.String, "value": pl.Float64})),
    "places": pl.List(pl.String),
    "values": pl.Struct({"read": pl.Float64, "follow": pl.Float64}),
}

TOUCHES = st.fixed_dictionaries(
    {"giver": st.none() | st.text(max_size=3), "value": st.floats(-1, 1)}
)
ROWS = st.fixed_dictionaries(
    {
        "when": st.none() | st.floats(0, 9),
        "who": st.text(max_size=3),
        "touches": st.lists(TOUCHES, max_size=3),
        "places": st.lists(st.text(max_size=2), max_size=2),
        "values": st.none()
        | st.fixed_dictionaries({"read": st.floats(0, 1), "follow": st.floats(0, 1)}),
        "not a column": st.none(),
    }
)


@given(rows=st.lists(ROWS, max_size=6))
def test_a_frame_of_rows_is_the_one_that_polars_makes(rows):
    theirs = pl.DataFrame(rows, KINDS, orient="row", strict=True)

    assert frame_of(rows, KINDS).equals(theirs, null_equal=True)


def test_no_rows_are_a_frame_without_rows():
    empty = frame_of([], KINDS)

    assert empty.schema == pl.Schema(KINDS)
    assert empty.height == 0

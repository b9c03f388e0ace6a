"""A heat map shows a text in each cell and a frame where a claim holds."""

import pytest

from experiments.figures import Column, Panel, inline
from experiments.figures.heat_map import HeatMap, Spot


@pytest.fixture
def chart():
    def spot(x, y):
        return Spot(text=f"{x}{y}", shade=x / 2, framed=x == y, dotted=x > y)

    return HeatMap(
        across=("a", "b", "c"),
        up=("d", "e"),
        spots=tuple(tuple(spot(x, y) for x in range(3)) for y in range(2)),
    )


def test_every_cell_has_its_text_and_each_claim_that_holds_its_frame(chart):
    from matplotlib.figure import Figure

    axes = Figure().subplots()
    chart.draw(axes)
    texts = {text.get_text(): text.get_position() for text in axes.texts}
    assert texts["21"] == (2, 1)
    assert len(texts) == 6
    frames = [one for one in axes.patches if one.get_linewidth() == 1.6]
    assert [one.get_xy() for one in frames] == [(-0.46, -0.46), (0.54, 0.54)]
    assert len(axes.lines) == 3
    assert [label.get_text() for label in axes.get_xticklabels()] == ["a", "b", "c"]


def test_in_a_page_it_keeps_its_levels_and_takes_the_colors_of_the_page(chart):
    panel = Panel(label="up", draw=chart.draw, height=chart.height)
    column = Column(title="map", panels=(panel,), across="across", is_scale=False)
    (svg,) = inline((column,), "map")
    assert "fill: var(--ink)" in svg
    assert "#1b1f24" not in svg

"""Formulas of the site are drawings, which need no script and no font."""

from types import SimpleNamespace
from xml.etree import ElementTree

import pytest
from docutils import nodes

from experiments.docs_tools.site.formulas import block, drawn, inline


def test_a_formula_is_a_drawing_in_the_color_of_the_text():
    picture = ElementTree.fromstring(drawn(r"\frac{1}{(1+t)^w} < 1", inline=True))
    assert picture.attrib["aria-label"] == r"\frac{1}{(1+t)^w} < 1"
    assert float(picture.attrib["width"]) > 20
    fills = {part.attrib.get("fill") for part in picture} - {None}
    assert fills == {"currentColor"}


@pytest.mark.parametrize(
    ("write", "node", "around"),
    [(inline, nodes.math, "<svg"), (block, nodes.math_block, '<div class="math"><svg')],
)
def test_a_formula_stands_in_its_sentence_or_below(write, node, around):
    writer = SimpleNamespace(body=[])
    with pytest.raises(nodes.SkipNode):
        write(writer, node("", "a + b"))
    (text,) = writer.body
    assert text.startswith(around)

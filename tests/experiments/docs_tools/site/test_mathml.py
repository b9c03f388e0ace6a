"""Formulas of the site become MathML, which needs no script."""

from types import SimpleNamespace

import pytest
from docutils import nodes

from experiments.docs_tools.site.mathml import block, inline


@pytest.mark.parametrize(
    ("write", "node", "display"),
    [(inline, nodes.math, "inline"), (block, nodes.math_block, "block")],
)
def test_a_formula_is_written_as_mathml(write, node, display):
    writer = SimpleNamespace(body=[])
    with pytest.raises(nodes.SkipNode):
        write(writer, node("", r"\frac{1}{(1+t)^w}"))
    (text,) = writer.body
    assert f'display="{display}"' in text
    assert "<mfrac>" in text

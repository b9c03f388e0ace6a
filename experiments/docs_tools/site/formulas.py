"""A Sphinx extension: formulas as drawings, the same everywhere without any script."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING, Any

from docutils import nodes
from ziamath import Latex

if TYPE_CHECKING:
    from sphinx.application import Sphinx
    from sphinx.writers.html5 import HTML5Translator

SIZE = 18
"""Of the letters [px]; as large as those of the text look."""


def drawn(formula: str, *, inline: bool) -> str:
    """Returns a formula as SVG in the color of the text around it.

    Args:
        formula: In LaTeX; screen readers get it as it is.
        inline: Whether it stands within a sentence, on its line.
    """
    math = Latex(formula, size=SIZE, color="currentColor", inline=inline)
    label = f'<svg role="img" aria-label="{escape(formula)}" '
    style = f'style="vertical-align: {math.getyofst():.2f}px" ' if inline else ""
    return math.svg().replace("<svg ", label + style, 1)


def inline(writer: HTML5Translator, node: nodes.math) -> None:
    """Writes a formula within a sentence."""
    writer.body.append(drawn(node.astext(), inline=True))
    raise nodes.SkipNode


def block(writer: HTML5Translator, node: nodes.math_block) -> None:
    """Writes a formula in a paragraph of its own."""
    formula = " ".join(node.astext().split())
    writer.body.append(f'<div class="math">{drawn(formula, inline=False)}</div>')
    raise nodes.SkipNode


def setup(app: Sphinx) -> dict[str, Any]:
    """Makes it known as the renderer `drawn`."""
    app.add_html_math_renderer("drawn", (inline, None), (block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}

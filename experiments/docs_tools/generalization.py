"""The page docs/generalization.md: what carries over, and when analogy harms.

Run as `python -m experiments.docs_tools.generalization RUNS PAGE` after
`household study NAME --out RUNS` for each study that it is to show; its figures are put
into the folder `pictures` beside the page.
"""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

from experiments.docs_tools.pages import render
from experiments.report.generalization import context


def page(runs: Path, out: Path) -> None:
    """Writes the page and its pictures.

    Args:
        runs: Where the studies lie.
        out: The page.
    """
    known = context(runs)
    pictures = out.parent / "pictures"
    pictures.mkdir(exist_ok=True)
    drawn = []
    for part in known["parts"]:
        name = part.name.replace(" ", "_")
        figure = runs / name / "figure.png"
        if figure.is_file():
            shutil.copyfile(figure, pictures / f"generalization_{name}.png")
            drawn.append(part.name)
    out.write_text(render("generalization.md.j2", **known, drawn=drawn), "utf-8")


if __name__ == "__main__":
    page(Path(sys.argv[1]), Path(sys.argv[2]))

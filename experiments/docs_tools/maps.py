"""The page docs/maps.md: where claims hold over two constants, and two ideas apart.

Run as `python -m experiments.docs_tools.maps RUNS PAGE` after

    household maps --out RUNS

Its figures are put into the folder `pictures` beside the page.
"""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

from experiments.docs_tools.pages import render
from experiments.report.maps import ablation_tables, drawn_maps, teacher_table


def page(runs: Path, out: Path) -> None:
    """Writes the page and its pictures.

    Args:
        runs: What `household maps --out` was given.
        out: The page.
    """
    maps = drawn_maps(runs)
    pictures = out.parent / "pictures"
    pictures.mkdir(exist_ok=True)
    for one in maps:
        svg = next(file for file in one.figure.files if file.suffix == ".svg")
        shutil.copyfile(svg, pictures / svg.name)
    text = render(
        "maps.md.j2",
        maps=maps,
        ablations=ablation_tables(runs),
        teachers=teacher_table(runs),
    )
    out.write_text(text, "utf-8")


if __name__ == "__main__":
    page(Path(sys.argv[1]), Path(sys.argv[2]))

"""The page docs/generalization.md: what carries over, and when analogy harms.

Run as `python -m experiments.docs_tools.generalization RUNS PAGE` after
`household study NAME --out RUNS` for each study that is new; what the page says of
others stays. Figures are put into the folder `pictures` beside the page.
"""

from __future__ import annotations

import re
import shutil
import sys
from pathlib import Path

from experiments.docs_tools.pages import render
from experiments.generalization.names import NAMES
from experiments.report.generalization import context

MISSING = "Not run, or not finished:"


GRID = "Representation and pooling"
"""The section that is made from a study and is not called as it is."""


def page(runs: Path, out: Path) -> None:
    """Writes the page and its pictures.

    Args:
        runs: Where the studies lie.
        out: The page. Sections of studies that lie elsewhere stay as they are.
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
    new = _sections(render("generalization.md.j2", **known, drawn=drawn))
    old = _sections(out.read_text("utf-8")) if out.is_file() else {}
    headings = {name: name.replace("_", " ").capitalize() for name in NAMES}
    del headings["tuning"]
    beginning, *sections = (
        new.get(heading, old.get(heading, ""))
        for heading in ("", GRID, *headings.values())
    )
    missing = [name for name, each in headings.items() if each not in new | old]
    beginning = beginning.partition(MISSING)[0].rstrip()
    if missing:
        beginning += f"\n\n{MISSING} {', '.join(missing)}."
    out.write_text("\n\n".join(filter(None, (beginning, *sections))) + "\n", "utf-8")


def _sections(text: str) -> dict[str, str]:
    """The sections of a page by heading; what stands before the first has none."""
    tidy = re.sub(r"\n{3,}", "\n\n", text)
    beginning, *sections = re.split(r"^(?=## )", tidy, flags=re.MULTILINE)
    named = {each.partition("\n")[0].removeprefix("## "): each for each in sections}
    return {
        heading: each.strip() for heading, each in ({"": beginning} | named).items()
    }


if __name__ == "__main__":
    page(Path(sys.argv[1]), Path(sys.argv[2]))

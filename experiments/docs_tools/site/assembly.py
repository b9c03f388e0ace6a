"""All pages of the site in one folder, each of them in the navigation."""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from experiments.docs_tools.site.families import write_families
from experiments.docs_tools.site.homes import write_homes
from experiments.docs_tools.site.reference import write_reference

SECTIONS: Mapping[str, Sequence[str]] = {
    "Tutorials": ("tutorials/*",),
    "The simulation": ("environment", "scenarios", "homes", "people"),
    "Homes and families": ("suite", "families/index", "homes/index"),
    "Learning": ("learners", "equations", "many_people", "generalization"),
    "Findings": ("results", "generalization", "maps", "deviations", "validation"),
    "Tools": ("replay", "performance", "reliability", "scale"),
    "Examples": ("examples/index", "examples/*", "libraries"),
    "Reference": ("reference/index", "architecture", "dependencies"),
    "More": ("*", "*/*"),
}
"""Part of the navigation -> its pages in order; a pattern takes what is not named."""

OUTSIDE = re.compile(r"(?<=\]\()(?P<up>(?:\.\./)+)(?P<name>[\w/-][\w./-]*)(?=[)#])")
"""A link from a page of docs/ to a file that is not in docs/."""


def assemble(root: Path, folder: Path) -> None:
    """Writes what Sphinx builds the site from.

    Args:
        root: Folder of the project.
        folder: Where to write; what was there is removed.
    """
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(root / "docs", folder)
    write_families(folder)
    write_homes(folder)
    write_reference(folder / "reference")
    for page in folder.rglob("*.md"):
        _bring_along(page, root, folder)
    index = folder / "index.md"
    pages = [path.relative_to(folder).with_suffix("") for path in folder.rglob("*.md")]
    index.write_text(index.read_text("utf-8") + navigation(pages), "utf-8")


def navigation(pages: Iterable[Path]) -> str:
    """Returns the tables of contents that make up the sidebar.

    Args:
        pages: All pages of the site, without their endings.
    """
    left = {page.as_posix() for page in pages} - {"index"}
    nested = {name for name in left if name.startswith(("families/", "homes/"))}
    left -= {name for name in nested if not name.endswith("/index")}
    left -= {name for name in left if re.fullmatch(r"reference/(?!index).*", name)}
    parts = []
    for caption, patterns in SECTIONS.items():
        found = []
        for pattern in patterns:
            taken = sorted(name for name in left if Path(name).match(pattern))
            found += taken
            left -= set(taken)
        if found:
            parts.append(toctree(found, caption))
    return "".join(parts)


def toctree(pages: Sequence[str], caption: str = "") -> str:
    """Returns a table of contents that only the sidebar shows."""
    title = f":caption: {caption}\n" if caption else ""
    return f"\n```{{toctree}}\n:hidden:\n{title}\n" + "\n".join(pages) + "\n```\n"


def _bring_along(page: Path, root: Path, folder: Path) -> None:
    """Lets the links of a page that leave docs/ lead to a page of the site.

    A Python file gets a page that shows it, a folder is its README or index; of the
    project's README the first page is the counterpart. Others come along as they are.
    """
    up = "../" * (len(page.relative_to(folder).parts) - 1)

    def inside(match: re.Match[str]) -> str:
        name = match["name"]
        if match["up"] != up + "../":
            return match[0]
        if name == "README.md":
            return f"{up}index.md"
        return f"{up}{_shown(root / name, folder / 'files' / name, folder)}"

    text = page.read_text("utf-8")
    changed = OUTSIDE.sub(inside, text)
    if changed != text:
        page.write_text(changed, "utf-8")


def _shown(file: Path, copy: Path, folder: Path) -> str:
    """Copies a file into the site; returns where it, or the page that shows it, is."""
    copy.parent.mkdir(parents=True, exist_ok=True)
    if file.suffix != ".py":
        shutil.copyfile(file, copy)
        return copy.relative_to(folder).as_posix()
    page = copy.with_suffix(".md")
    page.write_text(
        f"---\norphan: true\n---\n\n# {file.name}\n\n"
        f"~~~~~~python\n{file.read_text('utf-8')}~~~~~~\n",
        "utf-8",
    )
    return page.relative_to(folder).as_posix()

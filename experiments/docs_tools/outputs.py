"""Renews what pages show of what their programs print.

    python -m experiments.docs_tools.outputs README.md docs/tutorials/1_first_episode.md

runs the Python of each page from top to bottom, in an empty folder, and writes what a
block prints into the block of output after it. Tests compare the two.
"""

from __future__ import annotations

import contextlib
import io
import re
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

BLOCK = re.compile(r"^```(python|output)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def renewed(text: str) -> str:
    """Returns a page with what its programs print now.

    Args:
        text: The page; a block of output follows the Python that prints it.
    """
    names: dict[str, Any] = {}
    printed = ""

    def block(match: re.Match[str]) -> str:
        nonlocal printed
        if match[1] == "output":
            return f"```output\n{printed}```"
        with contextlib.redirect_stdout(io.StringIO()) as out:
            exec(match[2], names)  # A page of the project's own.
        printed = out.getvalue()
        return match[0]

    return BLOCK.sub(block, text)


def main(pages: list[Path]) -> None:
    """Renews pages in place."""
    for page in pages:
        path = page.resolve()
        with TemporaryDirectory() as folder, contextlib.chdir(folder):
            text = renewed(path.read_text("utf-8"))
        path.write_text(text, "utf-8")


if __name__ == "__main__":
    main([Path(name) for name in sys.argv[1:]])

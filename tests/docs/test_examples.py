"""What the pages show is run: Python, commands, and scenarios in TOML.

The blocks of a page are run from top to bottom in a folder of their own, where a page
finds the files that its earlier blocks wrote. A block of output shows exactly what the
Python before it prints.
"""

import contextlib
import io
import re
import shlex
import subprocess
import textwrap
import tomllib
from functools import cache
from pathlib import Path

import pytest
from sybil import Sybil
from sybil.evaluators.python import PythonEvaluator
from sybil.example import SybilFailure
from sybil.parsers.markdown import CodeBlockParser

from experiments.cli import _parse, main

QUICK = ("check", "scenarios", "train")
"""Commands that are run, but for a whole suite; of others it is checked that they
understand the words."""


def run_commands(example):
    """Runs each line; where something is wrong, says what."""
    faults = (_fault(shlex.split(line, comments=True)) for line in lines(example))
    return next(filter(None, faults), None)


def lines(example):
    """The commands of a block, one a line."""
    return [line for line in example.parsed.splitlines() if line.strip()]


def _fault(words):
    program, *arguments = words
    if program == "make":
        return _fault_of_make(arguments)
    if program == "household":
        return _fault_of_household(arguments)
    if program == "source":  # What make sets up is entered, and nothing else.
        made = (ROOT / "Makefile").read_text("utf-8")
        entered = arguments == [".venv/bin/activate"] and "-m venv .venv" in made
        return None if entered else f"{program}: {arguments}"
    return f"{program}: not a command that this test knows"


def _fault_of_make(arguments):
    done = subprocess.run(
        ["make", "--dry-run", "--directory", str(ROOT), *arguments],
        capture_output=True,
        text=True,
        check=False,
    )
    return done.stderr if done.returncode else None


def _fault_of_household(arguments):
    quick = arguments[0] in QUICK and "--suite" not in arguments
    if quick or "--picture" in arguments:
        status = main(arguments)
        return f"{shlex.join(arguments)}: status {status}" if status else None
    _parse(arguments)
    return None


def check_scenario(example):
    """Writes the scenario to a file that has its name, and checks it."""
    path = Path(f"{tomllib.loads(example.parsed)['name']}.toml")
    path.write_text(example.parsed, "utf-8")
    return _fault_of_household(["check", str(path)])


ROOT = Path(__file__).parents[2]


class Printing(PythonEvaluator):
    """Runs Python and keeps what it prints, for a block of output after it."""

    def __call__(self, example):
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            super().__call__(example)
        example.namespace["printed"] = printed.getvalue()


def compare(example):
    """Says what was printed, if it is not what the page shows."""
    printed = example.namespace["printed"]  # Sybil takes common indents away.
    same = example.parsed == textwrap.dedent(printed)
    return None if same else f"printed was:\n{printed}"


RUN = Sybil(
    parsers=[
        CodeBlockParser("python", Printing()),
        CodeBlockParser("output", compare),
        CodeBlockParser("sh", run_commands),
        CodeBlockParser("toml", check_scenario),
    ]
)


@pytest.fixture(scope="module")
def run_page(tmp_path_factory, root):
    """Runs a page's blocks, once, and returns what its Python printed.

    In an empty folder but for a scenario of one's own: that of docs/scenarios.md.
    """

    @cache
    def run(page):
        printed = []
        with contextlib.chdir(tmp_path_factory.mktemp("page")):
            for example in RUN.parse(root / "docs" / "scenarios.md"):
                if example.region.evaluator is check_scenario:
                    example.evaluate()
            # The Python of pages on examples is that of files: tests/examples runs it.
            elsewhere = PythonEvaluator if page.parent.name == "examples" else ()
            for example in RUN.parse(page):
                if not isinstance(example.region.evaluator, elsewhere):
                    example.evaluate()
                if isinstance(example.region.evaluator, Printing):
                    printed.append(example.namespace.get("printed", ""))
        return "".join(printed)

    return run


def test_every_block_says_its_language(page, tokens):
    """Else it would not be run; as text are commands of other programs alone."""
    languages = {token.info for token in tokens(page) if token.type == "fence"}
    assert languages <= {"python", "output", "sh", "text", "toml"}


def test_the_blocks_of_a_page_run_from_top_to_bottom(page, run_page):
    run_page(page)


def test_output_that_is_not_what_was_printed_is_found(tmp_path):
    page = tmp_path / "page.md"
    page.write_text("```python\nprint(1 + 1)\n```\n\n```output\n3\n```\n", "utf-8")
    shown, output = RUN.parse(page)
    shown.evaluate()
    with pytest.raises(SybilFailure, match="printed was:\n2"):
        output.evaluate()


def test_the_fifteen_lines_of_the_readme_are_fifteen(root):
    text = (root / "README.md").read_text("utf-8")
    (code,) = re.findall(r"## Fifteen lines.*?```python\n(.*?)```", text, re.DOTALL)
    assert len(code.splitlines()) == 15


def test_in_the_tutorial_on_training_taps_become_fewer(root, run_page):
    printed = run_page(root / "docs" / "tutorials" / "5_training.md")
    found = dict(re.findall(PART, printed))
    taps = [float(found[part]) for part in "1234"]
    assert len(taps) == 4
    assert sum(taps[1:]) / 3 < 0.8 * taps[0]


PART = r"part (\d): .* caresses, ([\d.]+) taps a minute"

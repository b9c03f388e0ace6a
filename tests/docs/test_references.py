"""Files, functions and modules that the pages name in code spans are there.

A code span names a file or a folder (`household/environment.py`), something inside a
file (`household/environment.py: Household.step`), something to import
(`household.replay.RecordEpisodes`, whatever it is called with), or part of a class
(`Household.step`).
"""

import ast
import pkgutil
import re
from functools import cache

import pytest

PACKAGES = ("household", "learners", "policies", "experiments")
PATH = re.compile(rf"(?:{'|'.join(PACKAGES)}|docs|tests)/[\w/.]*")
INSIDE = re.compile(rf"({PATH.pattern}\.py): (\w+(?:\.\w+)*)")
PART = re.compile(r"[A-Z]\w+\.\w+")
MODULE = re.compile(rf"((?:{'|'.join(PACKAGES)})(?:\.\w+)+)(?:\(.*\))?")


@pytest.fixture(scope="module")
def spans(page, tokens):
    """The code spans of a page; a changelog may name what is no longer there."""
    if page.name == "CHANGELOG.md":
        return []
    return [token.content for token in tokens(page) if token.type == "code_inline"]


@pytest.fixture(scope="session")
def names_in():
    """Returns a function that lists what a Python file defines, "Class.method" too."""

    @cache
    def read(path):
        return set(_defined(ast.parse(path.read_text("utf-8")).body))

    return read


def _defined(body, prefix=""):
    for node in body:
        match node:
            case ast.FunctionDef(name=name):
                yield prefix + name
            case ast.ClassDef(name=name, body=inside):
                yield prefix + name
                yield from _defined(inside, f"{prefix}{name}.")
            case ast.Assign(targets=targets):
                yield from (prefix + t.id for t in targets if isinstance(t, ast.Name))
            case ast.AnnAssign(target=ast.Name(id=name)):
                yield prefix + name


def test_files_and_folders_named_on_a_page_are_there(spans, root):
    paths = [span for span in spans if PATH.fullmatch(span)]
    assert [path for path in paths if not (root / path).exists()] == []


def test_what_a_page_names_inside_a_file_is_defined_there(spans, root, names_in):
    named = [match.groups() for span in spans if (match := INSIDE.fullmatch(span))]
    lost = [
        f"{path}: {name}"
        for path, name in named
        if not (root / path).is_file() or name not in names_in(root / path)
    ]
    assert lost == []


def test_parts_of_our_classes_that_a_page_names_are_there(spans, root, names_in):
    """What belongs to classes of others (`Space.step`) is not looked at."""
    files = [file for package in PACKAGES for file in (root / package).rglob("*.py")]
    defined = set().union(*map(names_in, files))
    parts = [span for span in spans if PART.fullmatch(span)]
    ours = [part for part in parts if part.partition(".")[0] in defined]
    assert [part for part in ours if part not in defined] == []


def test_modules_and_functions_named_on_a_page_can_be_imported(spans):
    lost = []
    for match in filter(None, map(MODULE.fullmatch, spans)):
        try:
            pkgutil.resolve_name(match.group(1))
        except (ImportError, AttributeError):
            lost.append(match.group(1))
    assert lost == []

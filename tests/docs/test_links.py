"""Every link and picture inside the project leads to what is there."""

import re
from itertools import pairwise

import pytest


@pytest.fixture(scope="module")
def targets(page, tokens):
    """What a page links to or shows, without addresses on the web."""
    found = [
        str(token.attrs.get("href") or token.attrs.get("src"))
        for token in tokens(page)
        if token.type in ("link_open", "image")
    ]
    return [target for target in found if not re.match(r"[a-z]+:", target)]


@pytest.fixture(scope="session")
def anchors(tokens):
    """Returns a function that lists a page's headings as a link would name them."""

    def read(page):
        parts = tokens(page)
        headings = [
            part.content
            for before, part in pairwise(parts)
            if before.type == "heading_open"
        ]
        kept = (re.sub(r"[^\w\- ]", "", heading.lower()) for heading in headings)
        return {heading.replace(" ", "-") for heading in kept}

    return read


def test_links_lead_to_files_and_headings_that_are_there(page, targets, anchors):
    lost = []
    for target in targets:
        name, _, anchor = target.partition("#")
        file = page.parent / name if name else page
        if not file.exists() or (anchor and anchor not in anchors(file)):
            lost.append(target)
    assert lost == []


def test_every_page_and_picture_of_the_documentation_is_linked_to(root, tokens):
    """So that a reader of the README finds each of them."""
    linked = set()
    for page in (root / "README.md", *root.glob("docs/**/*.md")):
        for token in tokens(page):
            target = str(token.attrs.get("href") or token.attrs.get("src") or "")
            linked.add((page.parent / target.partition("#")[0]).resolve())
    kinds = (".md", ".svg", ".png", ".gif", ".mp4", ".webp")
    files = {path for path in (root / "docs").rglob("*") if path.suffix in kinds}
    assert {path.name for path in files - linked} == set()


def test_every_table_has_its_rule_below_the_first_row(page):
    lines = ["", *page.read_text("utf-8").splitlines()]
    first = [
        number
        for number, (above, line) in enumerate(pairwise(lines), start=1)
        if line.startswith("|") and not above.startswith("|")
    ]
    assert [lines[n] for n in first if not lines[n + 1].startswith("| --")] == []

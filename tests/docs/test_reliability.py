"""Each demand on reliability has tests, and they are there."""

import re

NAMED = re.compile(r"`(tests/[\w/]+\.py): (test_\w+)`")
DEMANDS = 16


def test_each_demand_has_tests_that_are_there(root):
    page = (root / "docs" / "reliability.md").read_text("utf-8")
    rows = dict(re.findall(r"^\| (\d+) \|(.*)$", page, re.MULTILINE))
    assert list(rows) == [str(i + 1) for i in range(DEMANDS)]
    for number, row in rows.items():
        named = NAMED.findall(row)
        assert named, number
        for file, test in named:
            source = (root / file).read_text("utf-8")
            assert f"\ndef {test}(" in source, (number, file, test)

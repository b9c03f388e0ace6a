"""Tests stand in the same rooms as what they test."""

from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PACKAGES = ("experiments", "household", "learners", "policies")


@pytest.mark.parametrize("package", PACKAGES)
def test_every_folder_of_tests_is_named_after_a_room(package):
    folders = {
        file.parent.relative_to(ROOT / "tests")
        for file in (ROOT / "tests" / package).rglob("test_*.py")
    }
    assert len(folders) > 1
    assert {folder for folder in folders if not (ROOT / folder).is_dir()} == set()

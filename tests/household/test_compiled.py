"""Compiling: what is kept on disk, and when it is thrown away."""

import os

from household.compiled import forget_outdated


def test_what_was_compiled_before_any_source_changed_is_forgotten(tmp_path):
    """A change in one file also counts for functions of others, which may call it."""
    kept = []
    for package, changed in (("one", 100), ("other", 200)):
        source = tmp_path / package / "loops.py"
        index = tmp_path / package / "inner" / "__pycache__" / "loops.f.nbi"
        index.parent.mkdir(parents=True)
        for file, when in ((source, changed), (index, 150)):
            file.touch()
            os.utime(file, (when, when))
        kept.append(index)
    forget_outdated([tmp_path / "one"])
    assert [index.exists() for index in kept] == [True, True]
    forget_outdated([tmp_path / "one", tmp_path / "other"])
    assert [index.exists() for index in kept] == [False, False]

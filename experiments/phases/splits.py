"""Which people, homes and role assignments are for training, and which for the end.

The lists lie in `lists/`, one file for each split, and each is read only if its hash is
the one that stands here. What is tested is read by the final evaluation alone: whoever
reads it has to say so, and only `experiments.phases.trial` does.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Literal

import msgspec

from experiments.errors import ExperimentError, unknown

LISTS = Path(__file__).parent / "lists"

Split = Literal["train", "validation", "test", "out_of_distribution"]

HASHES: Mapping[str, str] = {
    "train": ("a12180e864f9c2122cd8d4557f808ffd2c6cbb0cbc8d573c6ffb66071b313322"),
    "validation": ("af645049010860a80726e8bc64de34c8c48fd9837bc3120e63fa1d1edd9056d7"),
    "test": ("f5600abe7fe273bb7fa52f9cb37b259a6f4d7904e748f591702f79aaf6002b74"),
    "out_of_distribution": (
        "f2f6ccd9bb8102656559f6003c03f531448b97fe1d860768e29004ce47cfa45a"
    ),
}
"""Split -> SHA-256 of its file."""

OPEN = ("train", "validation")
"""Splits that anybody may read at any time."""


class SplitLists(msgspec.Struct, frozen=True, kw_only=True):
    """The lists of one split."""

    people: tuple[int, ...]
    """Numbers of the population, in order."""

    homes: tuple[int, ...]
    """Seeds of homes."""

    roles: tuple[tuple[int, int], ...]
    """The days of two people (indices of `experiments.phases.days.DAYS`)."""


def read(split: Split, *, final: bool = False) -> SplitLists:
    """Returns the lists of a split.

    Args:
        split: Which one.
        final: Whether this is the final evaluation, of what no result goes back into a
            choice.

    Raises:
        ExperimentError: If there is no such split, it is of the test and this is not
            the final evaluation, or its file is not the one that was committed.
    """
    if split not in HASHES:
        raise unknown("split", split, HASHES)
    if split not in OPEN and not final:
        raise ExperimentError(
            f"split {split!r} is for the final evaluation alone; choose what to run by "
            "'validation'."
        )
    return _read(split)


@cache
def _read(split: str) -> SplitLists:
    content = (LISTS / f"{split}.json").read_bytes()
    if hashlib.sha256(content).hexdigest() != HASHES[split]:
        raise ExperimentError(
            f"{LISTS / f'{split}.json'}: not the list that was committed (its hash is "
            "another). Get it back from the repository."
        )
    return msgspec.json.decode(content, type=SplitLists)

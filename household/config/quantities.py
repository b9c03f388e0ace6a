"""Numbers and texts as files hold them, each with limits.

Without limits a number that is merely absurd overflows a clock, hangs a loop or fills
the memory, long after the file was called correct. The limits are far from what anybody
needs.
"""

from typing import Annotated

from msgspec import Meta

Coordinate = Annotated[float, Meta(ge=-1e4, le=1e4)]
"""[m]; the origin of a plan may lie far away from the home."""

Position = tuple[Coordinate, Coordinate]
"""A `Point` as files hold it [m]."""

Length = Annotated[float, Meta(gt=0, le=1e4)]
"""[m]"""

Angle = Annotated[float, Meta(ge=-3600, le=3600)]
"""[degrees]"""

Seconds = Annotated[float, Meta(gt=0, le=1e8)]
"""[s]; up to three years."""

Share = Annotated[float, Meta(ge=0, le=1)]
Count = Annotated[int, Meta(ge=1, le=10**9)]
Seed = Annotated[int, Meta(ge=0, le=2**63 - 1)]

# `\Z`, not `$`, which lets a line break pass at the end.
Name = Annotated[
    str,
    Meta(
        pattern=r"^[^\x00-\x1f\x7f-\x9f\u2028\u2029\ud800-\udfff]+\Z",
        max_length=100,
        description="1 to 100 characters on one line",
    ),
]
"""What something is called in files, messages and pictures."""

Text = Annotated[
    str,
    Meta(
        pattern=r"^[^\x00-\x08\x0b-\x1f\x7f-\x9f\ud800-\udfff]*\Z",
        max_length=2000,
        description="up to 2000 characters that can be printed",
    ),
]
"""A description."""

FileName = Annotated[
    str,
    Meta(
        pattern=r"^[^\x00\n\r]+\Z",
        max_length=4096,
        description="a name or a path, on one line",
    ),
]
"""Of something that is shipped, or of a file."""

"""One finished trial as a Parquet file that says which trial it is.

Its metadata name study, configuration, condition and seed, so that a file copied from
elsewhere is not taken for this trial's; its pages carry checksums, so that damage is
noticed. Nothing in such a file is run, and how much it holds is looked up before it is
read.
"""

from __future__ import annotations

import io
from pathlib import Path
from typing import TYPE_CHECKING, Any

import msgspec

from experiments.errors import ExperimentError

if TYPE_CHECKING:
    import polars

FORMAT = 3
"""Version of what is stored; results of another version are refused, never converted.

1: situations were text alone. 2: roles, attention and factors are columns. 3: a trial
says which trial it is.
"""

LARGEST, MOST_VALUES = 2**30, 10**8
"""Of a trial [bytes, values in all columns]; those of the paper have a thousandth."""

_KEY = b"household"


class Identity(msgspec.Struct, frozen=True, kw_only=True):
    """Which trial a file holds."""

    format: int = FORMAT
    """Version of the format."""

    study: str
    """Name of the study."""

    configuration: str
    """Digest of everything that fixes the study's results but the seeds."""

    condition: str
    """Name of the condition."""

    seed: int
    """The trial's seed."""


def encoded(frame: polars.DataFrame, identity: Identity) -> bytes:
    """Returns the content of a trial's file.

    Args:
        frame: The trial's table.
        identity: Which trial it is.
    """
    from pyarrow import parquet

    table = frame.to_arrow()
    named = table.replace_schema_metadata({_KEY: msgspec.json.encode(identity)})
    file = io.BytesIO()
    parquet.write_table(named, file, compression="zstd", write_page_checksum=True)
    return file.getvalue()


def fault_of(path: Path, identity: Identity) -> str | None:
    """Returns why a file cannot be this trial's, in one line; None if it can.

    Looks only at the file's end, which tells whether it is whole and which trial it is.

    Args:
        path: The file.
        identity: Which trial it should hold.
    """
    from pyarrow import ArrowException, parquet

    try:
        if path.stat().st_size > LARGEST:
            return f"larger than {LARGEST} bytes"
        metadata = parquet.read_metadata(path)
        return _misfit(metadata, identity)
    except (OSError, ValueError, ArrowException) as error:
        return _damaged(error)


def _misfit(metadata: Any, identity: Identity) -> str | None:  # noqa: ANN401 - Arrow
    """What is wrong with a file by what its end says of it."""
    said = (metadata.metadata or {}).get(_KEY)
    if said is None:
        return "not a trial's table, or one of an older version"
    found = msgspec.json.decode(said, type=Identity)
    if found != identity:
        return f"holds another trial ({_difference(found, identity)})"
    groups = [metadata.row_group(i) for i in range(metadata.num_row_groups)]
    columns = [group.column(i) for group in groups for i in range(group.num_columns)]
    if metadata.num_rows < 1:
        return "holds no rows"
    if sum(column.num_values for column in columns) > MOST_VALUES:
        return f"holds more than {MOST_VALUES} values"
    return None


def _difference(found: Identity, wanted: Identity) -> str:
    from household.errors import shown

    name = next(
        name
        for name in Identity.__struct_fields__
        if getattr(found, name) != getattr(wanted, name)
    )
    if name == "configuration":
        return "of another configuration"
    return f"{name} {shown(getattr(found, name))}"


def decoded(path: Path, identity: Identity) -> polars.DataFrame:
    """Returns the table of a trial's file.

    Args:
        path: The file.
        identity: Which trial it should hold.

    Raises:
        ExperimentError: If it is damaged or another trial's.
    """
    import polars as pl
    from polars.exceptions import PolarsError
    from pyarrow import ArrowException, parquet

    fault = fault_of(path, identity)
    if fault is None:
        try:
            table = parquet.read_table(path, page_checksum_verification=True)
            return pl.DataFrame(table)
        except (OSError, ValueError, ArrowException, PolarsError) as error:
            fault = _damaged(error)
    raise ExperimentError(
        f"{path}: {fault}. Delete it, and the command that made it runs that trial "
        "again."
    )


def _damaged(error: Exception) -> str:
    return f"damaged ({' '.join(str(error).split())[:200].rstrip('. ')})"

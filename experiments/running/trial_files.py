"""One finished trial as a Parquet file that says which trial it is.

Its metadata name study, configuration, condition and seed, so that a file copied from
elsewhere is not taken for this trial's; and they hold a digest of the whole file, so
that damage is noticed. Nothing in such a file is run, and how much it holds is looked
up before it is read.
"""

from __future__ import annotations

import hashlib
import io
from pathlib import Path
from typing import TYPE_CHECKING, Any

import msgspec

from experiments.errors import ExperimentError

if TYPE_CHECKING:
    import polars
    import pyarrow

FORMAT = 3
"""Version of what is stored; results of another version are refused, never converted.

1: situations were text alone. 2: roles, attention and factors are columns. 3: a trial
says which trial it is.
"""

LARGEST, MOST_VALUES = 2**28, 10**8
"""Of a trial [bytes, values in all columns]; those of the paper have a thousandth."""

LARGEST_UNPACKED, MOST_TEXT = 2**30, 2**36
"""Of a trial's table, and of the texts in lists, if each were as long as all that are
stored [bytes]."""

_KEY = b"household"

_BLANK = "0" * 64
"""In place of the digest, while that is worked out."""


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


class _Said(msgspec.Struct, frozen=True, kw_only=True):
    """What a file says of itself."""

    trial: Identity
    digest: str


class _Fault(Exception):  # noqa: N818 - it never leaves this module
    """Why a file cannot be used."""


def encoded(frame: polars.DataFrame, identity: Identity) -> bytes:
    """Returns the content of a trial's file.

    Args:
        frame: The trial's table.
        identity: Which trial it is.
    """
    from pyarrow import parquet

    said = msgspec.json.encode(_Said(trial=identity, digest=_BLANK))
    named = frame.to_arrow().replace_schema_metadata({_KEY: said})
    file = io.BytesIO()
    parquet.write_table(named, file, compression="zstd")
    content = file.getvalue()
    digest = hashlib.sha256(content).hexdigest()
    return content.replace(said, said.replace(_BLANK.encode(), digest.encode()))


def fault_of(path: Path, identity: Identity) -> str | None:
    """Returns why a file cannot be this trial's, in one line; None if it can.

    Args:
        path: The file.
        identity: Which trial it should hold.
    """
    try:
        content = path.read_bytes() if path.stat().st_size <= LARGEST else b""
        if not _is_as_written(content, identity):
            _checked(path, identity)
    except _Fault as fault:
        return str(fault)
    except OSError as error:
        return _damaged(error)
    return None


def _is_as_written(content: bytes, identity: Identity) -> bool:
    """Whether a file is byte for byte what was written for this trial.

    That is looked up without reading it as Parquet, so that 10^5 files are listed in
    seconds; whoever reads its table checks more.
    """
    begins, ends = msgspec.json.encode(_Said(trial=identity, digest=_BLANK)).split(
        _BLANK.encode()
    )
    at = content.find(begins) + len(begins)
    digest = content[at : at + len(_BLANK)]
    if at < len(begins) or not content.startswith(ends, at + len(_BLANK)):
        return False
    blank = content.replace(begins + digest, begins + _BLANK.encode())
    return hashlib.sha256(blank).hexdigest().encode() == digest


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

    try:
        return pl.DataFrame(arrow_table(path, identity))
    except (ValueError, PolarsError) as error:
        if isinstance(error, ExperimentError):
            raise
        raise _unusable(path, _damaged(error)) from error


def arrow_table(path: Path, identity: Identity) -> pyarrow.Table:
    """Returns the table of a trial's file as Arrow has it.

    Raises:
        ExperimentError: If it is damaged or another trial's.
    """
    from pyarrow import ArrowException, BufferReader, parquet

    try:
        content = path.read_bytes() if path.stat().st_size <= LARGEST else b""
        if not _is_as_written(content, identity):
            content = _checked(path, identity)
        file = parquet.ParquetFile(BufferReader(content))
        _check_size(file.metadata)
        return _unpacked(file).replace_schema_metadata(None)
    except _Fault as error:
        fault = str(error)
    except (OSError, ValueError, ArrowException) as error:
        fault = _damaged(error)
    raise _unusable(path, fault)


def _unusable(path: Path, fault: str) -> ExperimentError:
    return ExperimentError(
        f"{path}: {fault}. Delete it, and the command that made it runs that trial "
        "again."
    )


def _checked(path: Path, identity: Identity) -> bytes:
    """The content of a file that is whole, not too large, and this trial's."""
    from pyarrow import ArrowException, BufferReader, parquet

    try:
        with path.open("rb") as file:
            content = file.read(LARGEST + 1)
        if len(content) > LARGEST:
            raise _Fault(f"larger than {LARGEST} bytes")
        metadata = parquet.read_metadata(BufferReader(content))
        written = (metadata.metadata or {}).get(_KEY)
        if written is None:
            raise _Fault("not a trial's table, or one of an older version")
        said = msgspec.json.decode(written, type=_Said)
    except (OSError, ValueError, ArrowException) as error:
        raise _Fault(_damaged(error)) from None
    blank = written.replace(said.digest.encode(), _BLANK.encode())
    if hashlib.sha256(content.replace(written, blank)).hexdigest() != said.digest:
        raise _Fault("damaged (its content does not match its digest)")
    if said.trial != identity:
        raise _Fault(f"holds another trial ({_difference(said.trial, identity)})")
    _check_size(metadata)
    return content


def _check_size(metadata: Any) -> None:  # noqa: ANN401 - Arrow has no type information
    """Refuses a file that holds nothing, or too much to be read."""
    if metadata.num_rows < 1:
        raise _Fault("holds no rows")
    if _values(metadata) > MOST_VALUES:
        raise _Fault(f"holds more than {MOST_VALUES} values")


def _unpacked(file: Any) -> Any:  # noqa: ANN401 - Arrow has no type information
    """The table of a file, of which texts that come often are stored but once.

    A few bytes can stand for one long text in a million rows. No text is longer than
    its column, so that as few rows are read at a time as are sure to have room.
    """
    from pyarrow import Table

    longest, worst = _texts(file.metadata)
    if worst <= LARGEST_UNPACKED:
        return file.read(use_threads=False)
    found, size = [], 0
    for batch in file.iter_batches(max(1, LARGEST_UNPACKED // longest)):
        found.append(batch)
        size += batch.nbytes
        if size > LARGEST_UNPACKED:
            raise _Fault(f"holds more than {LARGEST_UNPACKED} bytes when unpacked")
    return Table.from_batches(found)


def _texts(metadata: Any) -> tuple[int, int]:  # noqa: ANN401 - likewise
    """How long a text can be, and all of them, if all are that long [bytes].

    Raises:
        _Fault: If one row alone could be too large.
    """
    longest, worst = 1, 0
    for i in range(metadata.num_row_groups):
        group = metadata.row_group(i)
        for j in range(group.num_columns):
            column = group.column(j)
            if column.physical_type == "BYTE_ARRAY":
                most = column.total_uncompressed_size * column.num_values
                if metadata.schema.column(j).max_repetition_level and most > MOST_TEXT:
                    raise _Fault("holds lists of texts that are too long")
                longest = max(longest, column.total_uncompressed_size)
                worst += most
    return longest, worst


def _values(metadata: Any) -> int:  # noqa: ANN401 - Arrow has no type information
    """How many values a file says that it holds, in all columns."""
    groups = [metadata.row_group(i) for i in range(metadata.num_row_groups)]
    return sum(g.column(i).num_values for g in groups for i in range(g.num_columns))


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


def _damaged(error: Exception) -> str:
    return f"damaged ({' '.join(str(error).split())[:200].rstrip('. ')})"

"""Chunks: the exact columns of a recording, read back as tables of arrays."""

import shutil
import struct
import tempfile
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from household.config.toml import is_file
from household.errors import HouseholdError, shown_path

Table = dict[str, NDArray[Any]]

LARGEST = 2**33
"""Of a file that is read [bytes]: a week of a crowded home."""

HEADER, MESSAGE = 12, struct.Struct("<QQ")
"""Length of a file's header; kind and length before each of its messages."""


EXACT = frozenset({"state", "touches", "credits", "choices"})
"""Entities with exact columns; so have robots' values, whose names begin with q/."""


def read_tables(path: Path) -> dict[str, Table]:
    """Reads a recording, also one that a kill cut off.

    Args:
        path: The file.

    Returns:
        A table for each entity: its columns in order of time, ``decision`` among them.
        A column with one number or text in each row has shape (n,), others (n, width).

    Raises:
        HouseholdError: If it cannot be read.
    """
    if not is_file(path):
        raise HouseholdError(f"{shown_path(path)}: no such file")
    if path.stat().st_size > LARGEST:
        raise HouseholdError(f"{shown_path(path)}: larger than {LARGEST} bytes")
    parts: dict[str, list[Table]] = {}
    with _whole_part(path) as whole:
        for entity, table in _pieces(whole, path):
            parts.setdefault(entity, []).append(table)
    try:
        return {entity: _merged(tables) for entity, tables in parts.items()}
    except (ValueError, KeyError, IndexError, TypeError) as error:
        raise _unreadable(path, error) from None


def _unreadable(path: Path, error: Exception) -> HouseholdError:
    reason = (str(error).splitlines() or [""])[0]
    return HouseholdError(f"{shown_path(path)}: damaged ({shown_path(reason)})")


def _pieces(whole: Path, path: Path) -> Iterator[tuple[str, Table]]:
    from rerun.chunk import RrdReader

    with warnings.catch_warnings():
        # A file that was cut off has no index at its end, and Rerun says so.
        warnings.simplefilter("ignore")
        try:
            size = 0
            for chunk in RrdReader(str(whole)).stream():
                entity = chunk.entity_path.strip("/")
                if entity == "__properties/household" or (
                    not chunk.is_static and _is_exact(entity)
                ):
                    batch = chunk.to_record_batch()
                    size += batch.nbytes
                    if size > LARGEST:  # Messages are packed.
                        raise ValueError(f"more than {LARGEST} bytes when unpacked")
                    batch.validate(full=True)  # Else forged lengths lead astray.
                    yield entity, _table(batch)
        except (RuntimeError, ValueError, KeyError, TypeError) as error:
            raise _unreadable(path, error) from None


def _is_exact(entity: str) -> bool:
    return entity in {"state", "touches", "credits", "choices"} or entity.startswith(
        "q/"
    )


def _table(batch: Any) -> Table:  # noqa: ANN401 - Arrow has no type information
    columns: Table = {}
    for field in batch.schema:
        kind = (field.metadata or {}).get(b"rerun:kind")
        name = field.name.rpartition(":")[2]
        if kind == b"data":
            columns[name] = _array(batch.column(field.name))
        elif name == "decision":
            columns[name] = batch.column(field.name).to_numpy()
    return columns


def _array(column: Any) -> NDArray[Any]:  # noqa: ANN401 - Arrow
    """Numbers as they were, texts as objects; an axis of length one is dropped."""
    import pyarrow as pa

    rows = len(column)
    while pa.types.is_nested(column.type):
        column = column.flatten()
    text = pa.types.is_string(column.type)
    flat = np.array(column.to_pylist(), object) if text else column.to_numpy()
    return flat if len(flat) == rows else flat.reshape(rows, -1)


def _merged(tables: list[Table]) -> Table:
    if "decision" in tables[0]:
        tables.sort(key=lambda table: int(table["decision"][0]))
    return {name: np.concatenate([t[name] for t in tables]) for name in tables[0]}


@contextmanager
def _whole_part(path: Path) -> Iterator[Path]:
    """The file, or a copy without its last message if a kill cut that off."""
    with path.open("rb") as file:
        size = path.stat().st_size
        end = _end_of_messages(file, size)
        if end == size:
            yield path
            return
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder) / "whole.rrd"
            file.seek(0)
            with copy.open("wb") as part:
                shutil.copyfileobj(file, part)
                part.truncate(end)
            yield copy


def _end_of_messages(file: BinaryIO, size: int) -> int:
    """Where the last complete message of a file ends [bytes]."""
    end = HEADER
    while end + MESSAGE.size <= size:
        file.seek(end)
        _, length = MESSAGE.unpack(file.read(MESSAGE.size))
        if end + MESSAGE.size + length > size:
            return end
        end += MESSAGE.size + length
    return min(end, size)

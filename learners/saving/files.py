"""Files of saved learners: a header line and a line of tagged JSON."""

import contextlib
import gc
import hashlib
import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from learners.errors import LearnerError, SavedFileError, shown
from learners.saving.codec import Decoder, encode

FORMAT = "household-learner"
VERSION = 2
READABLE = (1, VERSION)

LARGEST = 2**28
"""Of a file that is read [bytes]: a learner of some 500,000 situations. What it holds
takes twenty times as much memory."""


def write(path: str | Path, learner: object) -> None:
    """Write a learner to a file, whole or not at all.

    Raises:
        SavedFileError: if it holds something that is not registered with `saved`.
    """
    with _no_collection():
        payload = json.dumps(encode(learner), separators=(",", ":"))
    header = {"format": FORMAT, "version": VERSION, "sha256": _digest(payload)}
    path = Path(path)
    unfinished = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        with unfinished.open("w", encoding="utf-8", newline="\n") as file:
            file.write(f"{json.dumps(header)}\n{payload}\n")
            file.flush()
            os.fsync(file.fileno())
        unfinished.replace(path)
    except OSError as error:  # Which may not say itself what could not be written.
        raise OSError(error.errno, error.strerror, str(path)) from error
    finally:
        unfinished.unlink(missing_ok=True)


def load(path: str | Path, **attached: object) -> Any:  # noqa: ANN401 - what was saved
    """Read what `write` wrote; the learner goes on exactly where the saved one was.

    Args:
        path: the file.
        **attached: callables that are not written, by the name of their field, such
            as `ask` of the credit rule Advice.

    Raises:
        SavedFileError: if the file is damaged, cut short, of another version or not a
            saved learner, or if a class or a callable it needs is missing.
    """
    try:
        header_line, payload, end = _text(Path(path)).split("\n")
        header = json.loads(header_line)
        name, version, digest = (header[k] for k in ("format", "version", "sha256"))
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        if isinstance(error, SavedFileError):
            raise
        raise SavedFileError(f"{path} is not a saved learner, or cut short") from error
    if name != FORMAT:
        raise SavedFileError(
            f"{path} is not a saved learner: its format is {shown(name)}"
        )
    if version not in READABLE:
        raise SavedFileError(
            f"{path} was saved in version {shown(version)} of the format; this is "
            f"{VERSION}"
        )
    if end or digest != _digest(payload):
        raise SavedFileError(
            f"{path} is damaged: its content does not match its digest"
        )
    decoder = Decoder(attached, older=version < VERSION)
    try:
        with _no_collection():
            return decoder.decode(json.loads(payload))
    except LearnerError as error:
        raise SavedFileError(f"{path}: {error}") from error
    # A digest tells damage, not who wrote the file: it may hold anything.
    except (
        ArithmeticError,
        AttributeError,
        LookupError,
        MemoryError,
        RecursionError,
        StopIteration,
        TypeError,
        ValueError,
    ) as error:
        reason = " ".join(str(error).split())[:200]
        kind = type(error).__name__
        raise SavedFileError(f"{path} holds no learner ({kind}: {reason})") from error


@contextlib.contextmanager
def _no_collection() -> Iterator[None]:
    """Without looking for circles among a million new objects, again and again.

    There are none, and it would take as long as making the objects.
    """
    if not gc.isenabled():
        yield
        return
    gc.disable()
    try:
        yield
    finally:
        gc.enable()


def _text(path: Path) -> str:
    with path.open("rb") as file:
        content = file.read(LARGEST + 1)
    if len(content) > LARGEST:
        raise SavedFileError(f"{path} is larger than {LARGEST} bytes")
    return content.decode("utf-8")


def _digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()

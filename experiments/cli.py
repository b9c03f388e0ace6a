"""The command `household`: reads what was asked, says in one line what is wrong.

Everything heavy is imported by the command that needs it, so `--help` is quick.
"""

from __future__ import annotations

import contextlib
import io
import re
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from experiments.commands import COMMANDS
from experiments.errors import ExperimentError, unknown

if TYPE_CHECKING:
    from experiments.commands import Command

DESCRIPTION = """How a robot learns to be polite in a home with several people.

Begin with: household reproduce --out runs/paper"""

WRONG_INPUT, INTERRUPTED = 2, 130

LONGEST = 2000
"""So much of a message is shown [characters]."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs one command.

    Args:
        arguments: Words of the command line; None: those of the process.

    Returns:
        Exit status: 0 done, 2 wrong input (one line on stderr), 130 stopped by Ctrl-C.
    """
    words = list(sys.argv[1:] if arguments is None else arguments)
    try:
        command = _parse(words)
        command.run()
    except KeyboardInterrupt as stop:
        print(str(stop) or "Stopped.", file=sys.stderr)
        return INTERRUPTED
    except (ValueError, OSError) as error:
        if not _is_users(error):
            raise
        print(f"household: {_one_line(error)}", file=sys.stderr)
        return WRONG_INPUT
    return 0


def _parse(words: list[str]) -> Command:
    """Returns the command that the words ask for; ends the process after `--help`."""
    import tyro

    if words and not words[0].startswith("-") and words[0] not in COMMANDS:
        raise unknown("command", words[0], COMMANDS)
    complaint = io.StringIO()
    try:
        with contextlib.redirect_stderr(complaint):
            command: Command = tyro.extras.subcommand_cli_from_dict(
                dict[str, Any](COMMANDS),
                prog="household",
                description=DESCRIPTION,
                args=words,
                config=(tyro.conf.FlagCreatePairsOff,),
            )
            return command
    except SystemExit as end:
        if not end.code:
            raise
        raise ExperimentError(_unboxed(complaint.getvalue())) from None


def _unboxed(complaint: str) -> str:
    """Returns the parser's complaint, a box of several lines, as one line."""
    inside = [line.strip("│ \n") for line in complaint.splitlines()[1:]]
    blocks = re.split(r"[─╭╮╰╯]{3,}", " ".join(inside))
    sentences = (" ".join(block.split()).rstrip(".") for block in blocks)
    return ". ".join(sentence for sentence in sentences if sentence) + "."


def _is_users(error: Exception) -> bool:
    """Returns whether an error is the user's to mend, not a fault of this program."""
    from household.errors import HouseholdError
    from learners.errors import LearnerError

    return isinstance(error, (ExperimentError, HouseholdError, LearnerError, OSError))


def _one_line(error: Exception) -> str:
    from household.errors import printable, shown_path

    if isinstance(error, OSError) and error.strerror:
        return f"{shown_path(error.filename or 'file')}: {error.strerror}."
    text = printable(" ".join(str(error).split()))
    return text if len(text) <= LONGEST else f"{text[:LONGEST]}..."

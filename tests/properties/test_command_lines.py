"""Command lines: done, or one line that says what is wrong."""

import contextlib
import io

import pytest
from hypothesis import strategies as st

from experiments.cli import main

from .inputs import scenarios, written
from .plain_data import ODD_TEXTS

COMPILING = "household: compiling for this machine"
"""Said once per installation, whatever the command."""

LONG = 2400
"""No message is longer [characters]."""

WORDS = st.one_of(
    st.sampled_from([text for text in ODD_TEXTS if "\x00" not in text]),
    st.sampled_from(
        ("evening", "q_social", "phone", "random", "actors", "1", "5", "ray")
    ),
    st.sampled_from(("--help", "--out", "--seeds", "-1", "0", "1e9", "9" * 5000, "½")),
    st.text(st.characters(exclude_characters="\x00"), max_size=6),
)

NUMBERS = (
    "--seeds",
    "--decisions",
    "--seed",
    "--training",
    "--workers",
    "--households",
)
NAMES = ("--learner", "--suite", "--engine", "--out", "--picture", "--video")

OPTIONS = st.one_of(
    st.tuples(st.sampled_from(NUMBERS), st.sampled_from(("0", "-3", "x", "1e3", "½"))),
    st.tuples(st.sampled_from(NAMES), WORDS),
    st.tuples(WORDS),
)

CHEAP = ("check", "scenarios", "report", "replay", "train")
"""Commands that come to an end soon, given what they are given here."""

DEAR = ("reproduce", "evaluate", "study", "bench")
"""Commands that can work for hours; here their results have no place to go."""


@st.composite
def command_lines(draw):
    """A command with a few words; the last ones see to it that it ends soon."""
    name = draw(st.sampled_from((*CHEAP, *DEAR, "train ", "", "[b]")))
    words = draw(st.lists(WORDS, max_size=2))
    options = [word for pair in draw(st.lists(OPTIONS, max_size=2)) for word in pair]
    return [name, *words, *options]


@pytest.fixture
def run(tmp_path, monkeypatch):
    """Runs a command in a folder of its own; says what came of it."""
    monkeypatch.chdir(tmp_path)
    nowhere = tmp_path / "a file"
    nowhere.write_text("no directory", encoding="utf-8")
    last = {
        "train": ["--out", "trained", "--decisions", "20"],
        **{name: ["--out", str(nowhere)] for name in DEAR},
    }

    def run(words):
        words = words + last.get(words[0], [])
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            try:
                status = main(words)
            except SystemExit as end:  # After --help.
                status = end.code or 0
        told = err.getvalue().splitlines()
        lines = [line for line in told if not line.startswith(COMPILING)]
        assert status in (0, 2)
        assert all(line.isprintable() and len(line) < LONG for line in lines)
        if status == 0:
            return "done"
        assert lines[-1].startswith("household: ")
        assert words[0] == "check" or len(lines) == 1
        return "refused"

    return run


def test_a_command_line_is_done_or_refused_in_one_line(explore, run):
    explore(command_lines(), run, few=25)


def test_a_scenario_file_is_checked_and_trained_in_or_refused_in_one_line(
    explore, run, tmp_path
):
    path = tmp_path / "a household.toml"

    def check(data):
        if not written(data, path):
            return "not TOML"
        came = run(["check", str(path)])
        if came == "done" and "robots" in data:  # Else it is a file of another kind.
            assert run(["train", str(path)]) == "done"
        return came

    explore(scenarios(), check, few=3)

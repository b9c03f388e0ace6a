import io
import subprocess
import sys

import pytest

from experiments.cli import _unboxed, main
from experiments.commands import COMMANDS
from experiments.commands.terminal import new_console

LONG = "a" * 5000


def say(capsys, *words):
    """Runs a command; returns status, stdout, stderr."""
    try:
        status = main(words)
    except SystemExit as end:
        status = end.code
    written = capsys.readouterr()
    return status, written.out, written.err


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["reproduce", "7"], "unknown experiment '7'"),
        (["reproduce", "one"], "unknown experiment 'one'"),
        (["reproduce", "9" * 5000], "unknown experiment '999"),
        (["reproduce", "\u0661"], "unknown experiment"),
        (["reproduce", "1", "--seeds", "9" * 5000], "--seeds"),
        (["check", LONG + ".toml"], "aaa"),
        (["train", LONG + ".toml"], "no such scenario file"),
        (["report", LONG], "File name too long"),
        (["replay", LONG], "aaa"),
        (["train", "experiment_1", "--out", LONG], "cannot be written to"),
        (["report", "two\nlines"], "two lines: nothing to report"),
        (["replay", "two\nlines"], "two\\nlines: no replay"),
        (["check", "two\nlines.toml"], "two\\nlines.toml"),
        (["train", "two\nlines"], "unknown scenario 'two\\nlines'"),
        (["check", "nul\0.toml"], "nul"),
        (["reproduc"], "did you mean 'reproduce'?"),
        (["reproduce", "1", "--seeds", "0"], "--seeds must be at least 1, got 0"),
        (["reproduce", "1", "--seeds", "-3"], "--seeds must be at least 1, got -3"),
        (["reproduce", "1", "--seeds", "many"], "--seeds"),
        (["reproduce", "1", "--sensitivity-seeds", "31"], "from 1 to --seeds, got 31"),
        (["reproduce", "1", "--sedes", "3"], "--seeds"),
        (["reproduce", "1", "--engine", "dsk"], "did you mean 'dask'?"),
        (["reproduce", "1", "--workers", "0"], "--workers must be at least 1"),
        (["report"], "DIR"),
        (["report", "/nowhere"], "/nowhere: nothing to report"),
        (["check", "evning"], "did you mean 'evening'?"),
        (["check", "no.toml"], "no.toml"),
        (["train", "evning"], "did you mean 'evening'?"),
        (["train", "evening", "--learner", "q_socail"], "did you mean 'q_social'?"),
        (["train", "evening", "--decisions", "0"], "--decisions must be at least 1"),
        (["train", "evening", "--seed", "-1"], "--seed must be 0 or larger"),
        (["replay", "/nowhere"], "/nowhere: no replay"),
        (
            ["replay", "/nowhere", "--picture", "a.jpg"],
            "--picture a.jpg: the name must end in .png or .svg or .pdf",
        ),
        (["replay", "/nowhere", "--size", "big"], "--size big: allowed: WIDTHxHEIGHT"),
        (["replay", "/nowhere", "--speed", "0"], "--speed 0: allowed: 0.1 to 1000"),
        (["replay", "/nowhere", "--video", "no/a.mp4"], "no is not a directory"),
        ([], "reproduce"),
        (["--foo"], "--foo"),
    ],
)
def test_wrong_input_is_one_clear_line_and_status_2(
    capsys, tmp_path, monkeypatch, words, said
):
    monkeypatch.chdir(tmp_path)
    status, out, err = say(capsys, *words)
    assert status == 2
    assert said in err
    assert err.startswith("household: ")
    assert err.count("\n") == 1
    assert len(err) < 1000
    assert "Traceback" not in err
    assert out == ""
    assert list(tmp_path.iterdir()) == []


def test_an_output_that_is_a_file_is_refused_and_left_alone(capsys, tmp_path):
    file = tmp_path / "out"
    file.write_text("precious")
    for out in (file, file / "inside"):
        status, _, err = say(
            capsys, "reproduce", "1", "--seeds", "1", "--out", str(out)
        )
        assert status == 2
        assert err.count("\n") == 1
        assert "is a file, must be a directory" in err
    assert file.read_text() == "precious"


def test_a_fault_in_a_scenario_file_is_told_with_file_and_path(capsys, tmp_path):
    file = tmp_path / "mine.toml"
    file.write_text('name = "mine"\nbehaviours = ["bark", "play"]\n')
    status, _, err = say(capsys, "check", str(file))
    assert status == 2
    assert "mine.toml" in err
    assert "did you mean 'behaviors'?" in err
    assert err.count("\n") == 1


def test_a_correct_scenario_is_said_to_be_so(capsys):
    status, out, _ = say(capsys, "check", "experiment_1")
    assert (status, out) == (0, "experiment_1: correct; 1 person, 1 robot.\n")


def test_every_shipped_scenario_is_listed(capsys):
    from household.config.toml import shipped

    status, out, _ = say(capsys, "scenarios")
    assert status == 0
    assert all(name in out for name in shipped("scenario"))


def test_help_names_every_command_and_ends_well(capsys):
    status, out, err = say(capsys, "--help")
    assert status == 0
    assert all(name in out for name in COMMANDS)
    assert err == ""


HEAVY = (
    "gymnasium household.environment jinja2 matplotlib numba numpy pettingzoo polars "
    "pymunk ray rerun rich.progress scipy distributed"
)


def test_help_imports_nothing_heavy():
    source = (
        "import sys\nfrom experiments.cli import main\n"
        "try: main(['--help'])\nexcept SystemExit: pass\n"
        f"print([m for m in {HEAVY.split()!r} if m in sys.modules], file=sys.stderr)"
    )
    done = subprocess.run(
        [sys.executable, "-c", source], capture_output=True, text=True, check=True
    )
    assert done.stderr == "[]\n"


def test_python_m_experiments_is_the_same_command():
    done = subprocess.run(
        [sys.executable, "-m", "experiments", "reproduce", "9"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2
    assert done.stderr.startswith("household: unknown experiment '9'")


def test_a_check_mark_that_the_terminal_lacks_does_not_end_the_command(monkeypatch):
    written = io.BytesIO()
    monkeypatch.setattr("sys.stdout", io.TextIOWrapper(written, encoding="latin-1"))
    new_console().print("✓ holds")
    sys.stdout.flush()
    assert written.getvalue() == b"? holds\n"


def test_a_fault_of_the_program_is_not_blamed_on_the_user(monkeypatch):
    class Broken:
        def run(self):
            raise ValueError("a bug")

    monkeypatch.setattr("experiments.cli._parse", lambda words: Broken())
    with pytest.raises(ValueError, match="a bug"):
        main([])


def test_a_box_becomes_one_line_without_losing_a_word():
    box = (
        "╭─ Value error ─────────╮\n"
        "│ Error parsing --seeds │\n"
        "│ ───────────────────── │\n"
        "│ See household --help  │\n"
        "╰───────────────────────╯\n"
    )
    assert _unboxed(box) == "Error parsing --seeds. See household --help."


def test_training_keeps_learner_table_and_replay(capsys, tmp_path):
    import polars as pl

    from learners.saving import load

    words = ["train", "experiment_1", "--decisions", "60", "--out", str(tmp_path)]
    status, out, err = say(capsys, *words)
    assert (status, err) == (0, "")
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "replay.rrd",
        "robot_0.json",
        "trial.parquet",
    ]
    table = pl.read_parquet(tmp_path / "trial.parquet")
    assert table["next_time"][-1] == 60.0
    learner = load(tmp_path / "robot_0.json")
    assert learner.n_behaviors == 2
    assert "60 of 60 decisions" in out

"""Figures are drawn, and trials recorded, by processes that may die."""

import pytest

NAMES = ("one", "two")

DRAWER = f"""
    import os, sys
    from pathlib import Path
    from experiments.errors import ExperimentError
    from experiments.report.beside import beside

    def doomed(folder, names):
        marker = Path(os.environ["MARKER"])
        if marker.exists():
            if marker.read_text() == "once":
                marker.unlink()
            os._exit(9)
        for name in names:
            (folder / name).write_text(name)
        return names

    if __name__ == "__main__":
        try:
            with beside() as helpers:
                done = helpers.begin("figures", doomed, Path(sys.argv[1]), {NAMES})
                print(len(done()), "figures")
        except ExperimentError as error:
            sys.exit(f"refused: {{error}}")
"""


@pytest.fixture
def draw(program, tmp_path, monkeypatch):
    """Writes figures by processes that die once or always."""

    def start(dies):
        marker, folder = tmp_path / "marker", tmp_path / "figures"
        folder.mkdir()
        monkeypatch.setenv("MARKER", str(marker))
        marker.write_text(dies)
        process = program(DRAWER, folder)
        said, complaint = process.communicate(timeout=120)
        assert marker.exists() == (dies == "always")
        drawn = {path.name: path.read_text() for path in folder.glob("*")}
        return process.returncode, said, complaint, drawn

    return start


def test_figures_that_a_dying_process_took_with_it_are_drawn_again(draw):
    assert draw("once") == (0, "2 figures\n", "", dict(zip(NAMES, NAMES, strict=True)))


def test_figures_whose_process_dies_each_time_are_one_line(draw):
    status, _, complaint, drawn = draw("always")
    last = complaint.splitlines()[-1]
    assert status == 1
    assert last.startswith("refused: figures: the process that makes it dies each time")
    assert "Traceback" not in complaint
    assert drawn == {}

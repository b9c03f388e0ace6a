"""Figures are drawn, and trials recorded, by processes that may die."""

import pytest

DRAWER = """
    import os, sys
    from pathlib import Path
    from experiments.errors import ExperimentError
    from experiments.paper import EXPERIMENTS
    from experiments.report.beside import beside

    def doomed(number, out):
        marker = Path(os.environ["MARKER"])
        if marker.exists():
            if marker.read_text() == "once":
                marker.unlink()
            os._exit(9)
        names = [figure.name for figure in EXPERIMENTS[number].figures]
        for name in names:
            (out / "figures" / f"{name}.svg").write_text(name)
        return names

    if __name__ == "__main__":
        try:
            with beside() as helpers:
                finished = helpers.begin("figures", doomed, 1, Path(sys.argv[1]))
                print(len(finished()), "figures")
        except ExperimentError as error:
            sys.exit(f"refused: {error}")
"""


@pytest.fixture
def draw(program, stored, tmp_path, monkeypatch):
    """Writes figures by processes that die once, always or never."""

    def start(dies):
        marker, folder = tmp_path / "marker", stored / "figures"
        folder.mkdir(exist_ok=True)
        monkeypatch.setenv("MARKER", str(marker))
        if dies != "never":
            marker.write_text(dies)
        process = program(DRAWER, stored)
        said, complaint = process.communicate(timeout=120)
        drawn = {path.name: path.read_bytes() for path in folder.glob("*")}
        for path in folder.glob("*"):
            path.unlink()
        if dies == "once":
            assert not marker.exists()
        return process.returncode, said, complaint, drawn

    return start


def test_figures_that_a_dying_process_took_with_it_are_drawn_again(draw):
    status, said, complaint, undisturbed = draw("never")
    assert status == 0, complaint
    assert undisturbed
    assert draw("once") == (0, said, complaint, undisturbed)


def test_figures_whose_process_dies_each_time_are_one_line(draw):
    status, _, complaint, _ = draw("always")
    last = complaint.splitlines()[-1]
    assert status == 1
    assert last.startswith("refused: figures: the process that makes it dies each time")
    assert "Traceback" not in complaint

"""The typical trial of an experiment, to be looked at.

DIR/replays/experiment_1_seed_12.rrd     the recording
DIR/replays/experiment_1_seed_12.html    the same in any browser, without installation
DIR/replays/experiment_1_seed_12.mp4     the same as a film
DIR/replays/experiment_1_seed_12.svg     a moment of it
DIR/replays/viewer_0.41.0/               the viewer of the pages
"""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory

from experiments.paper import EXPERIMENTS
from experiments.report.records import Played
from experiments.running.replays import record
from experiments.running.study import Trial

FILM_SIZE = (960, 540)
"""Width and height [pixels]."""

FILM_SPEED, FILM_FPS = 30.0, 10.0
"""How many times as fast as the trial its film is, and frames in a second: 40 s for the
20 minutes of most experiments."""


def play(number: int, seed: int, out: Path) -> Played:
    """Records the typical trial, and makes film, picture and page; each if not there.

    Args:
        number: Of the experiment.
        seed: The typical one.
        out: The directory of all results, in which `replays` is.
    """
    from household.replay.page import write_page
    from household.replay.rendering import can_film, write_film, write_picture
    from household.replay.web_viewer import recorded_by, viewer_version

    experiment, folder = EXPERIMENTS[number], out / "replays"
    stem = f"{experiment.name}_seed_{seed}"
    drop_others(folder, experiment.name, stem)
    recording, page, film, picture = (
        folder / f"{stem}{kind}" for kind in (".rrd", ".html", ".mp4", ".svg")
    )
    # A page holds recording and viewer of one version.
    if not recording.exists() or recorded_by(recording) != viewer_version():
        condition = experiment.condition(experiment.reference)
        record(Trial(condition=condition, seed=seed), recording)
        page.unlink(missing_ok=True)
    with TemporaryDirectory(dir=folder, prefix=".", suffix=".tmp") as made:
        if not picture.exists():
            drawn = Path(made) / picture.name
            write_picture(recording, drawn, _moment(recording))
            drawn.replace(picture)
        if can_film() and not film.exists():
            shot = Path(made) / film.name
            write_film(recording, shot, FILM_SIZE, FILM_SPEED, fps=FILM_FPS)
            shot.replace(film)
            page.unlink(missing_ok=True)
    shown = film if film.exists() else None
    if not page.exists():
        title = f"Experiment {number}: {experiment.title}, seed {seed}"
        write_page(recording, page, title, shown, _moment(recording))
    return Played(recording=recording, page=page, film=shown, picture=picture)


def drop_others(folder: Path, name: str, stem: str) -> None:
    """Removes what is typical no more, now that there are other seeds.

    Args:
        folder: Of all replays.
        name: Of the experiment.
        stem: Of the files that stay.
    """
    for other in folder.glob(f"{name}_seed_*"):
        if other.stem != stem:
            other.unlink()


def _moment(recording: Path) -> int:
    """The decision of the touch that is nearest to the middle, or the middle."""
    from household.replay.reading import read_replay

    replay = read_replay(recording)
    middle = len(replay) // 2
    touched = sorted(replay.touches, key=lambda decision: abs(decision - middle))
    return touched[0] if touched else middle

"""Files are whole or not there; where there is no room for them, one line says so."""

import errno
import os
from collections import namedtuple

import pytest

from experiments.errors import ExperimentError
from experiments.running import files
from experiments.running.files import ask_for_space, remove_remains, write_whole


@pytest.mark.parametrize("number", [errno.ENOSPC, errno.EDQUOT, errno.EFBIG])
def test_a_full_disk_is_told_with_file_and_need(tmp_path, number):
    def write(path):
        path.write_bytes(b"x" * 1000)
        raise OSError(number, os.strerror(number))

    with pytest.raises(ExperimentError) as caught:
        write_whole(tmp_path / "study.json", write)
    assert str(tmp_path / "study.json") in str(caught.value)
    assert "needs more than 1000 bytes" in str(caught.value)
    assert list(tmp_path.iterdir()) == []


def test_space_is_asked_for_before_it_is_needed(tmp_path, monkeypatch):
    usage = namedtuple("usage", "total used free")
    monkeypatch.setattr(files.shutil, "disk_usage", lambda _: usage(9e6, 7e6, 2e6))
    ask_for_space(tmp_path, 1.9e6, "a trial")
    with pytest.raises(ExperimentError) as caught:
        ask_for_space(tmp_path, 3e6, "a trial")
    said = f"--out {tmp_path}: 2.0 MB are free, a trial needs about 3.0 MB"
    assert said in str(caught.value)


def test_remains_of_a_killed_run_are_removed_whether_files_or_folders(tmp_path):
    (tmp_path / "replays" / ".half.tmp").mkdir(parents=True)
    (tmp_path / "replays" / ".half.tmp" / "a.rrd").write_text("half")
    (tmp_path / ".report.html.7.tmp").write_text("half")
    (tmp_path / "report.html").write_text("whole")
    (tmp_path / "replays" / "b.rrd").write_text("whole")
    remove_remains(tmp_path)
    left = sorted(str(p.relative_to(tmp_path)) for p in tmp_path.rglob("*"))
    assert left == ["replays", "replays/b.rrd", "report.html"]

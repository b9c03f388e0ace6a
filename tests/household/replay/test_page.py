"""A replay as a page, and the viewer beside it."""

import base64
import gzip
import json
import re
import shutil
import subprocess
from urllib.request import urlopen

import pytest

from household import household_v0
from household.errors import HouseholdError
from household.replay import RecordEpisodes, page, web_viewer
from household.replay.page import write_page
from household.replay.process import LOOPBACK, free_ports
from household.replay.web_viewer import (
    LOADER,
    PROGRAM,
    VARIABLE,
    place_viewer,
    recorded_by,
    viewer_version,
)

BROWSER = shutil.which("chromium")

needs_browser = pytest.mark.skipif(BROWSER is None, reason="no chromium")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A folder with a replay and two pages of it, one of them with a film."""
    folder = tmp_path_factory.mktemp("pages")
    env = RecordEpisodes(household_v0.parallel_env("experiment_1"), folder)
    env.reset(seed=1)
    for _ in range(5):
        env.step(dict.fromkeys(env.agents, 0))
    env.close()
    path = (folder / "episode_00000.rrd").rename(folder / "busy.rrd")
    (folder / "a film.mp4").write_bytes(b"moving")
    write_page(path, folder / "plain.html", 'Who is "polite" <here>?')
    write_page(path, folder / "filmed.html", film=folder / "a film.mp4", at=3)
    return folder


@pytest.fixture
def viewer(folder):
    """Where the viewer is that the pages share."""
    return folder / f"viewer_{viewer_version()}"


def test_the_viewer_is_of_the_version_that_recorded(folder, viewer):
    assert recorded_by(folder / "busy.rrd") == viewer_version()
    assert viewer.is_dir()


def test_the_viewers_program_is_whole(viewer):
    text = (viewer / PROGRAM).read_text()
    packed = re.fullmatch(rf'window\.{VARIABLE} = "(.*)";\n', text)[1]
    program = gzip.decompress(base64.b64decode(packed))
    assert program[:4] == b"\0asm"
    assert b"re_viewer" in program
    assert "wasm_bindgen" in (viewer / LOADER).read_text()


def test_a_page_holds_the_recording_bit_for_bit(folder):
    text = (folder / "plain.html").read_text()
    held = re.search(r'<script id="recording" type="text/plain">(.*?)</script>', text)
    assert base64.b64decode(held[1]) == (folder / "busy.rrd").read_bytes()


def test_a_page_fetches_nothing_but_what_is_beside_it(folder, viewer):
    for name in ("plain.html", "filmed.html"):
        text = (folder / name).read_text()
        assert "://" not in text
        assert "connect-src 'none'" in text
        for script in (LOADER, PROGRAM):
            assert f'loaded("{viewer.name}/{script}")' in text


def test_a_pages_title_is_shown_as_it_is(folder):
    text = (folder / "plain.html").read_text()
    assert "<h1>Who is &quot;polite&quot; &lt;here&gt;?</h1>" in text
    assert "<title>busy</title>" in (folder / "filmed.html").read_text()


def test_a_page_has_its_film_only_if_there_is_one(folder):
    assert 'src="a%20film.mp4"' in (folder / "filmed.html").read_text()
    assert "<video" not in (folder / "plain.html").read_text()


def test_a_viewer_that_is_there_is_not_asked_for_again(folder, viewer, monkeypatch):
    monkeypatch.setattr(web_viewer, "start_viewer", None)
    assert place_viewer(folder) == viewer


def test_a_page_whose_folder_is_missing_is_one_line(folder):
    with pytest.raises(HouseholdError, match=r"page\.html: cannot be written"):
        write_page(folder / "busy.rrd", folder / "nowhere" / "page.html")


def test_nothing_unfinished_stays(folder):
    assert not list(folder.rglob(".*"))


def test_a_page_opens_at_its_moment_and_else_at_the_first_touch(folder, monkeypatch):
    assert "asked ? asked[1] : 3)" in (folder / "filmed.html").read_text()
    monkeypatch.setattr(page, "first_touch", lambda path: 41)
    write_page(folder / "busy.rrd", folder / "touched.html")
    assert "asked ? asked[1] : 41)" in (folder / "touched.html").read_text()


TELLS = """<script>
const seen = at("viewer");
new MutationObserver(() => { document.title = "shows " + seen.dataset.decision; })
  .observe(seen, { attributeFilter: ["data-decision"] });
</script>"""
"""Makes a page say in its title, which can be asked for, which moment it shows."""


@pytest.fixture
def title(tmp_path):
    """Opens a page in a browser without a screen; returns what asks for its title."""
    graphics = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
    command = [BROWSER, "--headless=new", "--no-sandbox", *graphics]
    command += [f"--user-data-dir={tmp_path}", "--disable-dev-shm-usage"]
    started = []

    def asked(address):
        (port,) = free_ports(1)
        started.append(
            subprocess.Popen(
                [*command, f"--remote-debugging-port={port}", address],
                stderr=subprocess.DEVNULL,
            )
        )

        def pages():
            with urlopen(f"http://{LOOPBACK}:{port}/json/list") as answer:
                return [each["title"] for each in json.load(answer)]

        return pages

    yield asked
    for process in started:
        process.kill()
        process.wait(20)


@needs_browser
@pytest.mark.parametrize(("link", "decision"), [("", 3), ("#when=decision@2", 2)])
def test_the_viewer_in_a_page_goes_to_the_moment(folder, title, until, link, decision):
    telling = folder / f"telling_{decision}.html"
    telling.write_text((folder / "filmed.html").read_text() + TELLS)
    titles = title(telling.as_uri() + link)
    until(lambda: f"shows {decision}" in titles(), 120.0)

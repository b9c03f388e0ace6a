import json
import re
import shutil
from html.parser import HTMLParser
from pathlib import Path

import polars as pl
import pytest

from experiments.analysis.claims import overall, verdicts
from experiments.analysis.evaluation import evaluations
from experiments.errors import ExperimentError
from experiments.paper import EXPERIMENTS
from experiments.paper.quotes import QUOTES
from experiments.report import publish as publishing
from experiments.report.publish import publish
from experiments.report.records import Played
from experiments.report.replays import drop_others
from experiments.report.terminal import show
from experiments.running.engine import open_engine
from experiments.running.store import Results
from experiments.running.study import Trial
from household.replay.web_viewer import viewer_version

E1 = EXPERIMENTS[1]


@pytest.fixture(scope="module")
def published(tmp_path_factory, play_trial):
    """What is published of experiment 1, four seeds, in the toy home."""
    out = tmp_path_factory.mktemp("out")
    study = E1.study((0, 1, 2, 3))
    results = Results(out / E1.name)
    results.prepare(study, {"conditions": {"made": "up"}})
    for trial in study.trials():
        results.write(trial, play_trial(trial, steps=200))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(publishing, "play", scribbled)
        yield publish(out, engine=open_engine("here"))


def scribbled(number, seed, out):
    """Stands for a replay: files of the right names."""
    stem = out / "replays" / f"experiment_{number}_seed_{seed}"
    drop_others(stem.parent, f"experiment_{number}", stem.name)
    files = [stem.with_suffix(kind) for kind in (".rrd", ".html", ".mp4", ".svg")]
    for file in files:
        file.write_text(file.suffix)
    names = ("recording", "page", "film", "picture")
    return Played(**dict(zip(names, files, strict=True)))


@pytest.fixture
def out(published):
    """The directory that it is published in."""
    return published.report_file.parent


def test_everything_lies_where_it_is_said_to(published, out):
    made = {str(p.relative_to(out)) for p in out.rglob("*") if p.is_file()}
    names = ("figure_3", "figure_3_synchronous", "experiment_1_rewards")
    assert {
        f"figures/{name}.{kind}" for name in names for kind in ("svg", "png")
    } <= made
    assert {"claims.json", "report.html"} <= made
    seed = published.reproduced[0].typical_seed
    for kind in ("rrd", "html", "mp4", "svg"):
        assert f"replays/experiment_1_seed_{seed}.{kind}" in made
    assert f"replays/viewer_{viewer_version()}/re_viewer.js" in made
    assert not [name for name in made if name.endswith(".tmp")]


def test_claims_json_holds_every_claim_with_value_interval_threshold_verdict(out):
    claims = json.loads((out / "claims.json").read_text())
    assert [(c["id"], c["condition"]) for c in claims] == [
        (id, condition)
        for condition in ("asynchronous", "synchronous")
        for id in ("1a", "1b", "1c")
    ]
    for claim in claims:
        keys = {"id", "text", "value", "low", "high", "threshold", "holds"}
        assert keys <= set(claim)
        assert claim["low"] <= claim["value"] <= claim["high"]
        assert claim["n"] == 4
        assert claim["verdict"] in ("holds", "fails", "undecided")
        if claim["id"] == "1c":  # about what a learner believes
            assert claim["floor"] is claim["ceiling"] is claim["standing"] is None
        else:
            learned = {"1a": (0.0, 1.0), "1b": (1.0, 0.0)}
            reached = claim["floor"]["value"], claim["ceiling"]["value"]
            assert reached == learned[claim["id"]]


def test_publishing_again_gives_the_same_files_and_drops_old_replays(out):
    before = {p: p.read_bytes() for p in out.rglob("*") if p.is_file()}
    old = out / "replays" / "experiment_1_seed_999.rrd"
    old.write_text("typical no more")
    publish(out, engine=open_engine("here"))
    assert {p: p.read_bytes() for p in out.rglob("*") if p.is_file()} == before


def test_without_results_there_is_nothing_to_report(tmp_path):
    with pytest.raises(ExperimentError, match="nothing to report"):
        publish(tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_an_unfinished_experiment_is_left_out_and_said_to_be(out, tmp_path):
    shutil.copytree(out / E1.name, tmp_path / E1.name)
    study = E1.study((0, 1, 2, 3))
    Results(tmp_path / E1.name).file(study.trials()[0]).unlink()
    with pytest.raises(ExperimentError, match="1 of 16 trials are missing"):
        publish(tmp_path)


class Page(HTMLParser):
    VOID = ("meta", "br", "img", "link")

    def __init__(self):
        super().__init__()
        self.open, self.ids, self.links, self.sources, self.text = [], [], [], [], []

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag not in self.VOID:
            self.open.append(tag)
        self.ids.append(attributes.get("id"))
        if tag == "a":
            self.links.append(attributes["href"])
        if tag in ("img", "script", "link", "iframe", "video"):
            self.sources.append(attributes.get("src", tag))

    def handle_startendtag(self, tag, attributes):
        self.ids.append(dict(attributes).get("id"))

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.text.append(data)


@pytest.fixture
def page(out):
    page = Page()
    page.feed((out / "report.html").read_text())
    assert page.open == []
    return page


def test_the_report_needs_no_network_and_no_files_but_films_and_pictures(out, page):
    assert {Path(one).suffix for one in page.sources} == {".svg", ".mp4"}
    assert all((out / one).is_file() for one in page.sources)
    html = (out / "report.html").read_text()
    fetched = re.findall(r"(?:src|@import|url\()\s*=?\s*[\"']?(?!#)([^\"')\s]+)", html)
    assert [target for target in fetched if not target.startswith("#")] == page.sources


def test_the_reports_links_lead_somewhere(out, page):
    for link in page.links:
        if link.startswith("#"):
            assert link[1:] in page.ids
        else:
            assert (out / link).is_file()


def test_no_id_is_used_twice_in_the_report(page):
    ids = [one for one in page.ids if one]
    assert len(ids) == len(set(ids)) > 50


def test_the_report_says_each_claim_its_verdict_and_the_configuration(page, published):
    text = " ".join(" ".join(page.text).split())
    for claim in E1.claims:
        assert claim.text in text
        assert claim.reading in text
    signs = {"holds": "✓ holds", "fails": "✗ fails", "undecided": "? undecided"}
    for verdict in overall(published.findings).values():
        assert signs[verdict] in text
    assert "seeds would decide" in text
    assert "A random robot has" in text
    assert QUOTES["1a"].words in text
    assert '"made": "up"' in text
    assert "Seeds 0 to 3." in text
    for method in ("Cumulative reward", "Frequency of rewards", "Q-table", "opinion"):
        assert method in text


def test_the_terminal_shows_the_claims_and_where_everything_lies(published):
    from rich.console import Console

    console = Console(record=True, width=100, force_terminal=False)
    show(console, published)
    said = console.export_text()
    assert "1a" in said
    assert "report.html" in said
    assert "household replay" in said
    assert re.search(r"\d of 3 claims hold", said)


def test_evaluations_cover_all_methods_and_conditions(out):
    frame = Results(out / E1.name).read(E1.study((0, 1, 2, 3)))
    found = evaluations(frame, ("asynchronous", "synchronous"), E1.target_situations)
    assert {one.method for one in found} == {
        "Cumulative reward",
        "Frequency of rewards",
        "Q-table",
        "Human opinion",
        "Beyond the paper",
    }
    reward = next(one for one in found if one.method == "Cumulative reward")
    one = frame.filter(pl.col("condition") == "asynchronous")
    assert reward.estimate.value == pytest.approx(one["reward"].sum() / 4)


def test_the_verdict_of_a_claim_needs_all_its_conditions(published):
    findings = published.findings
    for id, holds in verdicts(findings).items():
        assert holds == all(f.holds for f in findings if f.claim.id == id)


def test_experiment_1_compares_nothing_but_the_learning_rate():
    from experiments.running.trial import describe_condition

    one, other = (describe_condition(condition) for condition in E1.conditions)
    assert one["scenario"] == other["scenario"]
    assert one["settings"].pop("rate") != other["settings"].pop("rate")
    assert one["settings"] == other["settings"]


def test_conditions_with_the_same_seed_share_the_peoples_luck():
    """Until the first touch the robot's choices cannot change what people do."""
    from experiments.running.trial import play
    from policies.learning import Observer

    class Gaze(Observer):
        def __init__(self):
            self.first, self.over = [], False

        def stepped(self, env, actions, robots):
            self.over |= bool(env.feedback("robot_0"))
            if not self.over:
                self.first.append(env.attended("robot_0"))

    seen = []
    for condition in E1.conditions:
        gaze = Gaze()
        play(Trial(condition=condition, seed=3), [gaze])
        seen.append(gaze.first)
    n = min(map(len, seen))
    assert n > 0
    assert seen[0][:n] == seen[1][:n]

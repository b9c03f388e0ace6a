"""Generalization studies: what they run, and what they say about it."""

import json
from dataclasses import replace
from itertools import product

import polars as pl
import pytest

from experiments.cli import main
from experiments.errors import ExperimentError
from experiments.generalization import extras, heterogeneity, suite, tuning
from experiments.generalization.findings import findings
from experiments.generalization.inquiry import studies
from experiments.generalization.learners import GRID, LEARNERS, NETWORKS, tuned
from experiments.generalization.names import NAMES, inquiry
from experiments.phases import splits
from experiments.phases.drawing import probed_in, trained_in
from experiments.phases.trial import describe_training, run
from experiments.running.study import Trial

OWN = """
from experiments.analysis.preregistered import Contrast
from experiments.generalization.building import every
from experiments.generalization.drawing import bars, curves
from experiments.generalization.inquiry import Inquiry
from experiments.phases.records import Probing, Training
from experiments.phases.world import World

WORLD = World(people=2)
CASES = {
    (name,): (
        Training(world=WORLD, households=1, decisions=300),
        Probing(world=WORLD, new=new, split="validation", households=1, touches=(0, 2)),
    )
    for name, new in {"the same": (), "new people": ("people",)}.items()
}
INQUIRY = Inquiry(
    name="mine",
    question="Does it run?",
    conditions=every(("canonical", "within hearing, full"), CASES, ("new",)),
    contrasts=(
        Contrast(
            text="Views serve strangers better.",
            more={"learner": "within hearing, full", "new": "new people"},
            less={"learner": "canonical", "new": "new people"},
        ),
    ),
    draw=lambda frame: curves(frame, "touches", "new", label="touches"),
)
"""


@pytest.fixture
def own_study(tmp_path):
    file = tmp_path / "mine.py"
    file.write_text(OWN)
    return file


@pytest.mark.parametrize("name", NAMES)
def test_a_study_has_a_question_contrasts_and_conditions_that_can_be_run(name):
    asked = inquiry(name)
    assert asked.name == name
    assert asked.question.endswith("?")
    assert len(asked.contrasts) <= 6
    named = [condition.factors for condition in asked.conditions]
    for contrast in asked.contrasts:
        for side in (contrast.more, contrast.less):
            wanted = {k: v for k, v in side.items() if k != "touches"}
            touches = {
                t
                for condition in asked.conditions
                for t in condition.probing.touches
                if wanted.items() <= condition.factors.items()
            }
            assert any(wanted.items() <= each.items() for each in named), contrast.text
            assert side.get("touches", 0) in touches
    for condition in asked.conditions:
        trained_in(condition.training, 0)
        assert len(probed_in(condition, 0)) == condition.probing.households


@pytest.mark.parametrize("name", [n for n in NAMES if n != "tuning"])
def test_studies_have_as_many_seeds_as_the_protocol_wants(name):
    few = ("homes", "teachers", "robots", "cross_play", "deep")
    assert inquiry(name).seeds == (10 if name in few else 20)


def test_conditions_that_begin_alike_share_one_training():
    trainings, trials = studies(inquiry("transfer"), (0,))
    known = {each.name: each for each in trainings.conditions}
    used = set()
    for trial in trials.trials():
        start = trials.start(trial)
        if start is not None:
            folder, training = start
            assert folder == trainings.name
            used.add(training.condition.name)
            assert describe_training(training.condition) == describe_training(
                trial.condition
            )
    assert used == set(known)
    # Three of the four cases are the same people, who agree; the fourth has its own.
    assert len(known) == len(LEARNERS)


def test_a_study_of_ones_own_is_run_stored_drawn_and_said(own_study, tmp_path, capsys):
    words = ["study", str(own_study), "--seeds", "2", "--workers", "1"]
    out = tmp_path / "runs"
    assert main([*words, "--out", str(out)]) == 0
    said = capsys.readouterr().out
    assert "Views serve strangers better." in said
    document = json.loads((out / "mine" / "findings.json").read_text())["findings"]
    assert document["seeds"] == 2
    assert len(document["conditions"]) == 2 * 2 * 2 + 3 * 2
    assert (out / "mine" / "figure.svg").read_text().startswith("<?xml")
    # Two learners whose two cases share their training: 2 x 2 seeds.
    assert len(list((out / "mine" / "training").rglob("*.parquet"))) == 4
    assert main([*words, "--out", str(out)]) == 0
    assert "20 trials, 20 are stored" in capsys.readouterr().out


def test_a_plan_says_how_long_it_takes_and_stores_nothing(own_study, tmp_path, capsys):
    words = ["study", str(own_study), "--seeds", "1", "--plan", "--cores", "8"]
    assert main([*words, "--out", str(tmp_path / "runs")]) == 0
    said = capsys.readouterr().out
    assert "mine: 10 trials, 0 are stored already." in said
    assert "on 8 cores" in said
    assert not (tmp_path / "runs").exists()


def test_a_file_without_an_inquiry_is_one_line(tmp_path, capsys):
    (tmp_path / "empty.py").write_text("")
    assert main(["study", str(tmp_path / "empty.py")]) == 2
    assert "has no INQUIRY" in capsys.readouterr().err


def test_an_unknown_study_names_the_nearest(capsys):
    assert main(["study", "hetrogeneity"]) == 2
    assert "heterogeneity" in capsys.readouterr().err


def test_too_many_contrasts_are_refused():
    asked = inquiry("transfer")
    with pytest.raises(ExperimentError, match="at most 6"):
        replace(asked, contrasts=asked.contrasts * 2)


def test_tuning_reads_nothing_of_the_test(monkeypatch):
    asked = set()
    original = splits._read

    def watched(split):
        asked.add(split)
        return original(split)

    monkeypatch.setattr(splits, "_read", watched)
    condition = tuning.conditions(1)[0]
    short = replace(condition, training=replace(condition.training, decisions=50))
    short = replace(short, probing=replace(short.probing, decisions=100))
    run(Trial(condition=short, seed=0))
    assert asked == {"train", "validation"}
    assert {each.probing.split for each in tuning.conditions()} == {"validation"}


def test_every_learner_is_tuned_by_the_same_budget():
    conditions = tuning.conditions()
    tried = {name: set() for name in (*LEARNERS, *NETWORKS)}
    for each in conditions:
        tried[each.factors["learner"]].add(each.factors["setting"])
    assert {len(settings) for settings in tried.values()} == {tuning.DRAWS}
    assert tuning.drawn(5) == tuning.drawn(64)[:5]
    assert set(tuned()) == {*LEARNERS, *NETWORKS}


@pytest.mark.parametrize("name", NETWORKS)
def test_a_network_is_tried_with_settings_of_its_own(name):
    few, many = tuning.drawn_for(name, 5), tuning.drawn_for(name)
    assert few == many[:5]
    assert len({str(each) for each in many}) == tuning.DRAWS
    assert tuned()[name] in many


def test_the_winner_is_who_scores_highest_on_what_it_holds_and_does():
    rows = [
        {"learner": name, "setting": str(i), "seed": s, "greedy": g, "deployed": d}
        for name in LEARNERS
        for s in (0, 1)
        for i, (g, d) in enumerate([(0.9, 0.1), (0.8, 0.7), (0.2, 0.9)])
    ]
    document = tuning.winners(pl.DataFrame(rows))
    assert set(map(str, document["winners"].values())) == {str(tuning.drawn()[1])}
    assert (document["draws"], document["seeds"]) == (3, 2)


def scores(value_of):
    """A table of the heterogeneity study with scores by hand."""
    rows = [
        {
            "condition": condition.name,
            "seed": seed,
            **condition.factors,
            "people": str(seed % 4),
            "home": seed % 3,
            "touches": touches,
            "greedy": value_of(condition.factors, seed),
        }
        for condition in inquiry("heterogeneity").conditions
        for seed in range(6)
        for touches in condition.probing.touches
    ]
    return pl.DataFrame(rows)


def test_the_turn_from_gain_to_harm_is_read_off_the_scores():
    def value(factors, seed):
        h = float(factors["heterogeneity"])
        gain = {"canonical": 0.3 - 0.6 * h, "within hearing, full": 0.2}
        return 0.4 + gain.get(factors["learner"], 0.0) + 0.001 * seed

    found = heterogeneity.crossings(scores(value), 0)
    assert found["swap", "canonical"].value == pytest.approx(0.5)
    said = heterogeneity.in_words(found["swap", "canonical"])
    assert said == "turns from gain to harm at h = 0.50 [0.50, 0.50]"
    assert "never" in heterogeneity.in_words(found["swap", "within hearing, full"])


def test_networks_stand_on_the_leaderboard_with_the_budget_of_others():
    known = {
        (each.factors["learner"], each.factors["family"]): each
        for each in suite.INQUIRY.conditions
    }
    assert len(known) == len(suite.INQUIRY.conditions)
    for family, name in product(suite.FAMILIES, NETWORKS):
        table, network = known["nested", family], known[name, family]
        assert (network.training, network.probing) == (table.training, table.probing)


def test_apart_from_that_networks_are_trained_with_plenty():
    known = {
        (each.factors["learner"], each.factors["budget"]): each
        for each in inquiry("deep").conditions
    }
    for name in NETWORKS:
        plenty, same = known[name, "plenty"], known[name, "as the others"]
        assert plenty.probing == same.probing
        more, less = (
            each.training.households * each.training.decisions
            for each in (plenty, same)
        )
        assert more > 10 * less


@pytest.fixture
def without_networks(monkeypatch):
    """Neither of the packages of the extra `deep` is installed."""
    monkeypatch.setattr(extras, "find_spec", lambda package: None)


def test_without_their_extra_networks_are_left_out_and_it_is_said(without_networks):
    asked = inquiry("suite")
    rest, line = extras.runnable(asked)
    names = {each.factors["learner"] for each in rest.conditions}
    assert names == {*LEARNERS, *suite.REFERENCES}
    assert len(rest.contrasts) == len(asked.contrasts) - 2
    assert "without network per person and PPO" in line
    assert "pip install 'polite-household[deep]'" in line
    assert "\n" not in line
    assert extras.runnable(inquiry("transfer")) == (inquiry("transfer"), "")


def test_a_study_of_networks_alone_needs_their_extra(without_networks):
    asked = inquiry("suite")
    networks = tuple(filter(extras.needs_extra, asked.conditions))
    with pytest.raises(ExperimentError, match=r"polite-household\[deep\]"):
        extras.runnable(replace(asked, conditions=networks, contrasts=()))


def test_the_command_says_what_it_leaves_out(
    own_study, tmp_path, capsys, without_networks
):
    own_study.write_text(OWN.replace("within hearing, full", "PPO"))
    words = ["study", str(own_study), "--seeds", "1", "--plan"]
    assert main([*words, "--out", str(tmp_path / "runs")]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "mine: without PPO, 2 of 10 conditions; pip install" in said
    assert "mine: 8 trials, 0 are stored already." in said


def test_a_lived_score_is_between_random_and_lookahead():
    values = {"random": -2.0, "lookahead": 4.0, "canonical": 1.0}
    frame = pl.DataFrame(
        [
            {"learner": name, "family": family, "verdicts_per_minute": value}
            for name, value in values.items()
            for family in suite.FAMILIES
        ]
    )
    assert suite.lived_share(frame, "canonical") == pytest.approx(0.5)


def test_every_place_in_the_table_of_results_is_one_learner():
    assert set(GRID) <= set(LEARNERS)
    assert len(set(GRID.values())) == len(GRID)


def test_findings_leave_out_households_in_which_nothing_matters(own_study):
    from experiments.generalization.inquiry import inquiry_of

    asked = inquiry_of(own_study)
    rows = [
        {
            "condition": condition.name,
            "seed": seed,
            **condition.factors,
            "people": str(seed),
            "home": seed,
            "touches": 0,
            "greedy": float("nan") if seed == 0 else 0.5,
            "deployed": 0.4,
            "best_constant": 0.3,
            "verdicts_per_minute": None,
            "trained_touches": 3,
            "met": None,
        }
        for condition in asked.conditions
        for seed in range(4)
    ]
    frame = pl.DataFrame(rows, schema_overrides={"met": float})
    found = findings(asked, frame)
    assert found.conditions[0].greedy.value == 0.5
    assert found.conditions[0].greedy.n == 3

import numpy as np
import polars as pl
import pytest

from experiments.commands.reproducing import Reproduce
from experiments.paper import EXPERIMENTS
from experiments.report.study_tables import summarize_factorial, summarize_sensitivity
from experiments.running.store import Results
from experiments.running.study import Condition, Trial
from experiments.running.trial import describe_condition
from experiments.studies import factorial, sensitivity
from experiments.studies.factorial import Combination


def grid(values):
    """A table of one outcome: (levels, seed) -> value."""
    return pl.DataFrame(
        [
            {"seed": seed, "right": value, **Combination(*levels)._asdict()}
            for (levels, seed), value in values.items()
        ]
    )


def test_the_36_conditions_combine_every_level_and_can_all_be_made():
    study = factorial.study(5, (0,))
    assert len(study.conditions) == 36
    settings = [describe_condition(c)["settings"] for c in study.conditions]
    assert all(one not in settings[:index] for index, one in enumerate(settings))


@pytest.mark.parametrize("number", EXPERIMENTS)
def test_what_the_paper_ran_is_among_the_combinations(number):
    ran = {Combination(**one.factors) for one in factorial.conditions(number)}
    assert factorial.PAPER[number] <= ran


@pytest.mark.parametrize(
    ("number", "levels", "condition"),
    [
        (1, ("asynchronous", "immediate", "none"), "asynchronous"),
        (2, ("social", "immediate", "none"), "social"),
        (3, ("social", "trace", "none"), "trace"),
        (4, ("social", "designated", "none"), "designated"),
        (5, ("social", "designated", "swap"), "swap"),
        (5, ("skip_silence", "designated", "swap"), "skip_silence"),
    ],
)
def test_a_combination_is_the_learner_of_the_plain_run(number, levels, condition):
    combinations = {Combination(**c.factors): c for c in factorial.conditions(number)}
    plain = EXPERIMENTS[number].condition(condition)
    assert (
        describe_condition(combinations[levels])["settings"]
        == (describe_condition(plain)["settings"])
    )


def test_a_level_is_averaged_over_the_other_factors():
    frame = grid(
        {
            (("social", "trace", "none"), 1): 0.4,
            (("social", "trace", "swap"), 1): 0.6,
            (("social", "immediate", "none"), 1): 0.0,
            (("social", "trace", "none"), 0): 1.0,
            (("asynchronous", "trace", "none"), 0): 0.0,
        }
    )
    found = factorial.level_means(frame, "right", {"rate": "social", "credit": "trace"})
    assert found.tolist() == [1.0, 0.5]


def test_a_contrast_is_paired_by_seed():
    contrast = factorial.FINDINGS[1]
    frame = grid(
        {
            (("social", "immediate", "none"), 0): 0.9,
            (("social", "immediate", "none"), 1): 0.8,
            (("asynchronous", "immediate", "none"), 0): 0.5,
            (("asynchronous", "immediate", "none"), 1): 0.6,
        }
    )
    finding = contrast.claims()[0].check(frame)
    assert finding.estimate.value == pytest.approx(0.3)
    assert finding.holds


def test_every_finding_contrasts_levels_that_exist():
    for contrast in factorial.FINDINGS:
        assert {contrast.more, contrast.less} <= set(factorial.FACTORS[contrast.factor])
        levels = {**contrast.fixed, contrast.factor: contrast.more}
        assert set(levels) == set(factorial.FACTORS)
        ran = Combination(**levels) in factorial.PAPER[contrast.number]
        assert ran or contrast.number == 1


def test_a_combination_that_is_run_keeps_its_outcomes_alone():
    condition = factorial.study(3, (0,)).conditions[0]
    short = Condition(
        name="short",
        scenario=condition.scenario,
        learner=condition.learner,
        learner_overrides=condition.learner_overrides,
        scenario_overrides={"max_cycles": 300},
    )
    frame = factorial.run_combination(Trial(condition=short, seed=0), 3)
    assert frame.columns == list(factorial.OUTCOMES)
    assert len(frame) == 1
    assert 0.0 <= frame["right"][0] <= 1.0


@pytest.fixture
def out(tmp_path, play_trial):
    """The plain run of experiment 1 and its factorial, in a toy home."""
    seeds = (0, 1)
    plain = EXPERIMENTS[1].study(seeds)
    cells = factorial.study(1, seeds)
    for study in (plain, cells):
        results = Results(tmp_path / study.name)
        results.prepare(study, {})
        for index, trial in enumerate(study.trials()):
            made = pl.DataFrame({"right": [0.5 + index / 1000], "reward": 1.0})
            frame = play_trial(trial, 60) if study is plain else made
            results.write(trial, frame)
    return tmp_path


def test_what_was_run_of_the_factorial_is_shown(out):
    (shown,) = summarize_factorial(out)
    assert (shown.number, shown.n_seeds) == (1, 2)
    assert len(shown.table.rows) == 9
    marked = [
        (heading, cell.text)
        for heading, cells in shown.table.rows
        for cell in cells
        if cell.marked
    ]
    assert marked == [("asynchronous, immediate", "52 %")]
    assert len(shown.findings) == len(shown.silence) == 2


def test_a_factorial_with_missing_trials_is_not_shown(out):
    next((out / "factorial").rglob("*.parquet")).unlink()
    assert summarize_factorial(out) == ()


def variant(name, direction="up"):
    every = sensitivity.variants([EXPERIMENTS[1]])
    return next(
        one for one in every if one.constant.name == name and one.direction == direction
    )


def test_a_variant_runs_only_the_conditions_that_it_changes():
    changed = variant("SynchronousRate: exponent").conditions
    assert [condition.name for condition in changed] == ["synchronous"]
    assert len(variant("learner: gamma").conditions) == 2
    assert variant("persona: sanction").conditions == ()


def test_an_impossible_constant_is_said_to_be_impossible():
    every = sensitivity.variants([EXPERIMENTS[2]])
    center = [one for one in every if one.constant.name == "SocialRate: center"]
    assert {one.direction: bool(one.refusal) for one in center} == {
        "down": True,
        "up": False,
    }
    assert "smallest exponent" in center[0].refusal


def test_only_conditions_that_a_claim_is_about_are_varied():
    names = [c.name for c in sensitivity.claimed(EXPERIMENTS[2])]
    assert names == ["social", "asynchronous"]


@pytest.fixture
def varied(out, play_trial):
    """A variant whose trials are there; the toy home does not change with it."""
    one = variant("learner: gamma")
    study = one.study((0, 1))
    results = Results(out / study.name)
    results.prepare(study, {})
    for trial in study.trials():
        results.write(trial, play_trial(trial, 60))
    return one


def base(out):
    study = EXPERIMENTS[1].study((0, 1))
    return Results(out / study.name).read(study)


def test_verdicts_of_a_variant_are_kept_until_the_seeds_change(out, varied):
    frame = base(out)
    first = sensitivity.holding(varied, frame, out, (0, 1))
    assert first == sensitivity.holds(EXPERIMENTS[1], frame)  # the toy home is the same
    kept = out / varied.name / "verdicts.json"
    kept.write_text(kept.read_text().replace("true", "false"))
    assert not any(sensitivity.holding(varied, frame, out, (0, 1)).values())
    one = frame.filter(pl.col("seed") == 0)
    again = sensitivity.holding(varied, one, out, (0,))
    assert again == sensitivity.holds(EXPERIMENTS[1], one)


def test_a_variant_that_is_not_finished_has_no_verdicts(out, varied):
    next((out / varied.name).rglob("*.parquet")).unlink()
    assert sensitivity.holding(varied, base(out), out, (0, 1)) is None


def test_the_sensitivity_table_marks_verdicts_that_change(out, varied):
    frame = base(out)
    assert summarize_sensitivity(out, {1: frame}).firm == ("1a", "1b", "1c")
    kept = out / varied.name / "verdicts.json"
    held = sensitivity.holding(varied, frame, out, (0, 1))
    word = str(held["1a"]).lower(), str(not held["1a"]).lower()
    kept.write_text(kept.read_text().replace(f'"1a": {word[0]}', f'"1a": {word[1]}'))
    shown = summarize_sensitivity(out, {1: frame})
    assert shown.firm == ("1b", "1c")
    row = dict(shown.table.rows)["learner: gamma"]
    assert [cell.marked for cell in row] == [True, False, False]
    assert row[0].text == ("?|✗" if held["1a"] else "?|✓")
    assert list(dict(shown.table.rows)) == ["learner: gamma"]


def test_without_a_sensitivity_run_there_is_no_table(tmp_path):
    assert summarize_sensitivity(tmp_path, {}) is None


def test_a_nan_in_a_cell_leaves_its_seed_out():
    levels = ("social", "trace", "none")
    frame = grid({(levels, 0): None, (levels, 1): 0.5})
    found = factorial.estimates(frame, "right")[levels]
    assert (found.n, found.value) == (1, 0.5)
    assert np.isnan(found.low)


def test_the_command_adds_what_it_is_asked_for_with_the_same_seeds():
    def studies(**asked):
        command = Reproduce(experiments=("1",), seeds=3, **asked)
        return command._studies((EXPERIMENTS[1],))

    assert [study.name for study in studies()] == ["experiment_1"]
    names = [study.name for study in studies(factorial=True)]
    assert names == ["experiment_1", "factorial/experiment_1"]
    varied = studies(sensitivity=True, sensitivity_seeds=2)[1:]
    assert len({study.name for study in varied}) == len(varied) > 50
    assert {study.seeds for study in varied} == {(0, 1)}
    assert {study.seeds for study in studies(sensitivity=True)} == {(0, 1, 2)}

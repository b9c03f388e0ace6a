import polars as pl

from experiments.paper import EXPERIMENTS
from experiments.studies import sensitivity


def test_a_variant_runs_only_the_conditions_that_it_changes(variant):
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


def test_verdicts_of_a_variant_are_kept_until_the_seeds_change(
    stored, varied, plain_table
):
    first = sensitivity.holding(varied, plain_table, stored, (0, 1))
    # The toy home does not change with the constant.
    assert first == sensitivity.holds(EXPERIMENTS[1], plain_table)
    kept = stored / varied.name / "verdicts.json"
    kept.write_text(kept.read_text().replace("true", "false"))
    assert not any(sensitivity.holding(varied, plain_table, stored, (0, 1)).values())
    one = plain_table.filter(pl.col("seed") == 0)
    again = sensitivity.holding(varied, one, stored, (0,))
    assert again == sensitivity.holds(EXPERIMENTS[1], one)


def test_a_variant_that_is_not_finished_has_no_verdicts(stored, varied, plain_table):
    next((stored / varied.name).rglob("*.parquet")).unlink()
    assert sensitivity.holding(varied, plain_table, stored, (0, 1)) is None

"""Why claims do not hold: two sentences, made from the numbers alone."""

from dataclasses import replace

import numpy as np
import pytest

from experiments.analysis.claims import Claim, Finding
from experiments.analysis.measures import StudyMeasure
from experiments.analysis.statistics import Estimate
from experiments.paper import EXPERIMENTS
from experiments.paper.quotes import QUOTES
from experiments.report.reasons import reasons

CLAIM = Claim(
    id="9a",
    text="It is so.",
    reading="Measured.",
    measure=StudyMeasure(label="c", conditions=(), values=lambda frame: np.zeros(0)),
    rule="at least",
    threshold=0.9,
)


def estimate(value, low, high):
    return Estimate(value=value, low=low, high=high, n=30, method="bootstrap")


@pytest.fixture
def found():
    """A finding of so much, beside a random robot and the persona reference."""

    def make(value, low, high, floor=0.1, ceiling=1.0):
        return Finding(
            claim=CLAIM,
            estimate=estimate(value, low, high),
            holds=value >= CLAIM.threshold,
            floor=estimate(floor, floor, floor),
            ceiling=estimate(ceiling, ceiling, ceiling),
        )

    return make


def test_what_holds_needs_no_reasons(found):
    assert reasons(found(0.97, 0.93, 1.0)) == ()


def test_a_claim_that_fails_is_told_by_distance_and_by_the_references(found):
    distance, standing = reasons(found(0.55, 0.4, 0.7))
    assert "55 %, lies 35 percentage points below the threshold" in distance
    assert "30 seeds, 40 to 70 %" in distance
    assert "a random robot (10 %) and the persona reference (100 %)" in standing
    assert "it has come 50 %" in standing


def test_what_no_robot_attains_is_said(found):
    _, standing = reasons(found(0.3, 0.2, 0.4, ceiling=0.6))
    assert standing.startswith("Nothing between a random robot (10 %)")


def test_without_references_the_other_conditions_speak(found):
    alone = replace(found(0.3, 0.2, 0.4), floor=None, ceiling=None)
    assert reasons(alone)[1] == "No other condition was measured beside it."
    beside = {"one": estimate(0.95, 0.9, 1.0), "other": estimate(0.2, 0.1, 0.3)}
    met = reasons(replace(alone, compared=beside))[1]
    assert met == "Of the conditions beside it, this meets it: one (95 %)."


def test_an_undecided_claim_says_how_many_seeds_would_decide(found):
    straddling, deciding = reasons(found(0.93, 0.8, 1.0))
    assert "is within what the claim allows" in straddling
    assert "reaches across the threshold" in straddling
    assert deciding.startswith("About ")


def test_quotes_belong_to_claims_of_the_paper():
    ids = {
        claim.id
        for each in EXPERIMENTS.values()
        if each.of_paper
        for claim in each.claims
    }
    assert set(QUOTES) <= ids
    assert ids - set(QUOTES) == {"4c"}  # a table, and no words

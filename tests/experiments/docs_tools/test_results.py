"""The page of results says what is stored of the claims."""

import pytest

from experiments.docs_tools.results import page
from experiments.docs_tools.typical import Typical
from experiments.paper import EXPERIMENTS

CONTROLS = (
    *("silence_apart", "silence_held", "silence_apart_held", "skip_silence"),
    *("swap_watching", "random_watching", "persona_watching"),
)

TRIALS = [
    Typical(experiment=EXPERIMENTS[number], seed=16, caresses=42, taps=18)
    for number in (1, 4)
]


def finding(claim, verdict="holds", value=0.8, **more):
    stored = {"value": value, "low": value - 0.1, "high": value + 0.1}
    usual = {
        **stored,
        "id": claim,
        "text": f"Claim {claim}.",
        "condition": "social",
        "verdict": verdict,
        "rule": "at least",
        "threshold": 0.9,
        "least": None,
        "floor": None,
        "ceiling": None,
        "standing": None,
        "seeds_to_decide": None,
        "unit": "share of seeds",
        "interval": "bootstrap",
        "n": 30,
        "compared": dict.fromkeys(CONTROLS, stored),
    }
    return usual | more


@pytest.fixture
def findings():
    return [
        finding("1a", "fails"),
        finding("1a", "holds"),
        finding("4a", "undecided", seeds_to_decide=69),
        finding("5a", threshold=0.5, least=0.3),
        finding("5b", standing="unattainable"),
        finding("6a", "fails", unit="choices", value=2.5),
    ]


def test_a_claim_fails_if_it_fails_in_any_condition(findings):
    assert "2 of 4 claims hold, 1 fails, 1 is undecided" in page(findings, TRIALS)


def test_each_claim_and_condition_is_a_row_with_its_verdict(findings):
    said = page(findings, TRIALS)
    row = "| 4a | Claim 4a. | social | 80 % | 70 to 90 % | none | at least 90 % |"
    assert f"{row} *undecided* |" in said
    assert "4a about 69" in said
    assert "| 30 to 50 % | holds |" in said
    assert "| holds, unattainable |" in said


def test_our_own_claims_are_counted_apart(findings):
    assert "0 of 1 claims hold, 1 fails" in page(findings, TRIALS)
    assert "| 6a | Claim 6a. | social | 2.50 | 2.40 to 2.60 |" in page(findings, TRIALS)
    assert "A sixth experiment" not in page(findings[:-1], TRIALS)


def test_references_are_the_random_robot_and_the_persona(findings):
    known = finding("2a", floor={"value": 0.12}, ceiling={"value": 0.58})
    assert "| 12, 58 % |" in page([*findings, known], TRIALS)


def test_each_experiment_says_how_its_typical_trial_is_watched(findings):
    said = page(findings, TRIALS)
    record, watch = TRIALS[1].commands
    row = "| designated | 16 | 42, 18 | `experiment_4_seed_16.html` |"
    assert f"{row} `{record}`<br>`{watch}` |" in said
    assert "\n".join(("```sh", *TRIALS[0].commands, "```")) in said

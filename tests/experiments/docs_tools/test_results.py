"""The page of results says what is stored of the claims."""

import pytest

from experiments.docs_tools.results import page

CONTROLS = (
    *("silence_apart", "silence_held", "silence_apart_held", "skip_silence"),
    *("swap_watching", "random_watching", "persona_watching"),
)


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
    assert "2 of 4 claims hold, 1 fails, 1 is undecided" in page(findings)


def test_each_claim_and_condition_is_a_row_with_its_verdict(findings):
    said = page(findings)
    row = "| 4a | Claim 4a. | social | 80 % | 70 to 90 % | none | at least 90 % |"
    assert f"{row} *undecided* |" in said
    assert "4a about 69" in said
    assert "| 30 to 50 % | holds |" in said
    assert "| holds, unattainable |" in said


def test_our_own_claims_are_counted_apart(findings):
    assert "0 of 1 claims hold, 1 fails" in page(findings)
    assert "| 6a | Claim 6a. | social | 2.50 | 2.40 to 2.60 |" in page(findings)
    assert "A sixth experiment" not in page(findings[:-1])


def test_references_are_the_random_robot_and_the_persona(findings):
    known = finding("2a", floor={"value": 0.12}, ceiling={"value": 0.58})
    assert "| 12, 58 % |" in page([*findings, known])

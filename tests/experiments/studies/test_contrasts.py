import polars as pl
import pytest

from experiments.studies import contrasts, factorial
from experiments.studies.factorial import Combination


def test_a_contrast_is_paired_by_seed():
    contrast = contrasts.FINDINGS[1]
    values = {"social": (0.9, 0.8), "asynchronous": (0.5, 0.6)}
    frame = pl.DataFrame(
        [
            {"rate": rate, "credit": "immediate", "analogy": "none"}
            | {"seed": seed, "right": value}
            for rate, seeds in values.items()
            for seed, value in enumerate(seeds)
        ]
    )
    finding = contrast.claims()[0].check(frame)
    assert finding.estimate.value == pytest.approx(0.3)
    assert finding.holds


def test_every_finding_contrasts_levels_that_exist():
    for contrast in contrasts.FINDINGS:
        assert {contrast.more, contrast.less} <= set(factorial.FACTORS[contrast.factor])
        levels = {**contrast.fixed, contrast.factor: contrast.more}
        assert set(levels) == set(factorial.FACTORS)
        ran = Combination(**levels) in factorial.PAPER[contrast.number]
        assert ran or contrast.number == 1

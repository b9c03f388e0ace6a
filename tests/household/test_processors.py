"""One seed is one history on every processor.

NumPy has code of its own for processors with AVX-512, which rounds the last digit of
some functions otherwise. A household uses those of the C library, alone or in compiled
code.
"""

import numpy as np
import pytest

from household.household_v0 import parallel_env
from household.scenario.family import draw

VARYING = """
    arccos arccosh arcsin arcsinh arctan arctan2 arctanh cbrt cos cosh dot einsum exp
    exp2 expm1 float_power inner log log10 log1p log2 matmul power sin sinh tan tanh
"""


def lived_in(family, seed):
    env = parallel_env(draw(family, seed), max_cycles=150)
    env.reset(seed=seed)
    rng = np.random.default_rng(seed)
    while env.agents:
        env.step({agent: int(rng.integers(len(env.behaviors))) for agent in env.agents})


@pytest.mark.parametrize("family", ["phone", "party"])
def test_no_household_asks_numpy_what_processors_round_differently(family, monkeypatch):
    lived_in(family, 0)  # What is compiled, is compiled now.

    def refuse(name):
        def function(*args, **kwargs):
            raise AssertionError(f"np.{name} was asked")

        return function

    for name in VARYING.split():
        monkeypatch.setattr(np, name, refuse(name))
    lived_in(family, 1)

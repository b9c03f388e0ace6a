import numpy as np
import pytest

from learners.analogy import Propagation, RemoveEntity, SwapRoles
from learners.baselines.skip_silence import SkipSilence
from learners.catalog import make_learner
from learners.components import COMPONENTS, made, name_of
from learners.credit.rules import Designated, Trace
from learners.errors import ParameterError, UnknownNameError
from learners.representation import Canonical
from learners.tabular.rates import SocialRate

PAIRS = [(setting, name) for setting, known in COMPONENTS.items() for name in known]


@pytest.mark.parametrize(("setting", "name"), PAIRS)
def test_every_named_component_fits_into_a_learner(setting, name, live):
    rng = np.random.default_rng(1)
    posterior = name == "thompson"  # a Q-learner has none
    kind = "hierarchical_thompson" if posterior else "q_social"
    learner = make_learner(kind, 3, rng, **made({setting: name}))
    live(learner, 30, np.random.default_rng(2))


def test_skipping_silence_combines_with_credit_and_analogy(live):
    settings = made({"credit": "designated", "analogy": "swap_remove"})
    learner = make_learner("skip_silence", 3, np.random.default_rng(1), **settings)
    assert isinstance(learner, SkipSilence)
    assert learner.credit == Designated()
    assert learner.analogy.operators == (SwapRoles(), RemoveEntity())
    live(learner, 60, np.random.default_rng(2))
    assert learner.table.updates > 0


def test_a_component_takes_its_own_settings():
    found = made({"rate": {"name": "social", "center": 1.2}, "gamma": 0.5})
    assert found == {"rate": SocialRate(center=1.2), "gamma": 0.5}


def test_lists_of_a_file_are_tuples_in_a_component():
    named = {"name": "nested_views", "coarser": [["plays"], []]}
    (representation,) = made({"representation": named}).values()
    assert representation.coarser == (("plays",), ())
    assert hash(representation)


def test_a_component_that_is_made_already_is_left_alone():
    rate = SocialRate(mood=0.0)
    assert made({"rate": rate})["rate"] is rate


def test_no_two_learners_share_a_named_component_with_a_memory():
    one, other = made({"analogy": "swap"}), made({"analogy": "swap"})
    assert isinstance(one["analogy"], Propagation)
    assert one["analogy"] is not other["analogy"]


def test_what_is_not_known_is_refused_with_the_nearest_name():
    with pytest.raises(UnknownNameError, match="no credit called 'imediate'; did you"):
        made({"credit": "imediate"})
    with pytest.raises(ParameterError, match=r"rate 'social'.*centre"):
        made({"rate": {"name": "social", "centre": 1.0}})
    with pytest.raises(ParameterError, match="smallest exponent"):
        made({"rate": {"name": "social", "center": 0.75}})


def test_a_components_name_makes_one_of_its_type(rng):
    learner = make_learner("designated_adaptive", 2, rng)
    found = {
        setting: name_of(setting, getattr(learner, setting)) for setting in COMPONENTS
    }
    assert found == {
        "rate": "social",
        "credit": "designated",
        "representation": "named",
        "pooling": "none",
        "analogy": "adaptive",
        "exploration": "softmax",
        "silent_steps": "together",
    }
    with pytest.raises(UnknownNameError, match="no rate is made as str"):
        name_of("rate", "social")


def test_the_canonical_analogy_of_older_configurations_is_a_representation():
    found = made({"analogy": "canonical", "credit": "trace"})
    assert found == {"representation": Canonical(), "credit": Trace()}

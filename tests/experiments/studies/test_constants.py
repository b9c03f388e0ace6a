import pytest

from experiments.paper import EXPERIMENTS
from experiments.running.study import Condition
from experiments.running.trial import describe_condition
from experiments.studies.constants import Constant, constants, plain_scenario

SOCIAL = Condition(name="social", scenario="experiment_3", learner="q_social")
ASYNCHRONOUS = Condition(name="a", scenario="experiment_3", learner="q_asynchronous")
SKIP = Condition(
    name="s",
    scenario="experiment_5",
    learner="skip_silence",
    learner_overrides={"credit": "designated", "analogy": "swap"},
)


def named(name, *conditions):
    return next(one for one in constants(conditions) if one.name == name)


def changes(condition, constant, factor):
    """Paths at which a condition and its scaled form differ."""
    before = describe_condition(condition)
    after = describe_condition(constant.scaled(condition, factor))
    return sorted(_differences(before, after))


def _differences(one, other, path=""):
    if isinstance(one, dict):
        for key in one:
            yield from _differences(one[key], other[key], f"{path}.{key}")
    elif isinstance(one, (list, tuple)):
        for pair in zip(one, other, strict=True):
            yield from _differences(*pair, path)
    elif one != other:
        yield (path.removeprefix("."), one, other)


def written_out(found):
    """Without the scenario itself, where names are replaced by what they name."""
    return [one for one in found if not one[0].startswith("scenario.")]


@pytest.mark.parametrize("number", EXPERIMENTS)
def test_a_scenario_written_out_is_the_same_scenario(number):
    condition = EXPERIMENTS[number].conditions[0]
    plain = plain_scenario(condition.scenario)
    whole = Condition(
        name="whole",
        scenario=condition.scenario,
        learner=condition.learner,
        scenario_overrides={key: plain[key] for key in ("people", "norms", "behavior")},
    )
    before, after = describe_condition(condition), describe_condition(whole)
    for part in ("home", "personas", "behaviors", "norms"):
        assert before[part] == after[part]


def test_a_trait_is_scaled_in_all_people_and_nowhere_else():
    found = changes(SKIP, named("persona: habituation", SKIP), 1.25)
    assert written_out(found) == [("personas.habituation", 0.15, 0.1875)] * 2


def test_a_chance_is_not_scaled_beyond_1():
    found = changes(SOCIAL, named("persona: praise", SOCIAL), 1.25)
    assert written_out(found) == [("personas.praise", 0.9, 1.0)]
    assert named("persona: sanction", SOCIAL).scaled(SOCIAL, 1.25) is None


def test_norms_are_scaled_together_and_stay_within_1():
    size = named("norms: size", SKIP)
    found = written_out(changes(SKIP, size, 0.75))
    assert len(found) > 50
    assert all(after == pytest.approx(0.75 * before) for _, before, after in found)
    assert size.scaled(SOCIAL, 1.25) is None  # all are 1 or -1 there


def test_a_length_of_time_is_a_range_and_a_number_of_cycles_stays_whole():
    duration = named("script: duration", SOCIAL)
    people = duration.scaled(SOCIAL, 0.75).scenario_overrides["people"]
    assert [step["duration"] for step in people[0]["script"]] == [[30.0, 60.0]] * 2
    cycles = named("scenario: max_cycles", SOCIAL).scaled(SOCIAL, 1.25)
    assert cycles.scenario_overrides == {"max_cycles": 2250}


def test_a_part_of_the_learner_is_scaled_only_where_it_is():
    center = named("SocialRate: center", SOCIAL)
    assert changes(SOCIAL, center, 1.25) == [("settings.rate.center", 1.0, 1.25)]
    assert center.scaled(ASYNCHRONOUS, 1.25) is None


def test_scaling_a_part_keeps_the_other_parts():
    sigma = named("Designated: sigma_stm", SKIP)
    assert changes(SKIP, sigma, 0.75) == [
        ("settings.credit.sigma_stm", 1.6, pytest.approx(1.2))
    ]
    gamma = named("learner: gamma", SKIP)
    assert changes(SKIP, gamma, 0.75) == [("settings.gamma", 0.1, pytest.approx(0.075))]


def test_a_condition_that_is_scaled_stays_as_it_was():
    before = describe_condition(SKIP)
    for constant in constants([SKIP]):
        constant.scaled(SKIP, 0.75)
    assert describe_condition(SKIP) == before


def test_what_is_zero_or_no_number_is_no_constant():
    names = [one.name for one in constants([SOCIAL, SKIP])]
    assert len(names) == len(set(names))
    assert "persona: reflex" not in names  # 0 in the paper's actor
    assert "persona: only_when_attending" not in names
    assert "sleep: loudness" not in names
    assert {"play: loudness", "perception: focus", "Softmax: temperature"} <= set(names)


def test_a_constants_folder_has_a_plain_name():
    constant = Constant(name="SocialRate: center", keys=("rate", "center"), kind="x")
    assert constant.slug == "socialrate_center"

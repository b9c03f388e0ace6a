from experiments.commands.reproducing import Reproduce
from experiments.paper import EXPERIMENTS
from experiments.studies import sensitivity


def test_the_command_adds_what_it_is_asked_for_with_the_same_seeds(
    variants, monkeypatch
):
    monkeypatch.setattr(sensitivity, "variants", variants)

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

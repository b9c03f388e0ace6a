"""What is wrong with changes of what people want, and with norms, with its path."""

from collections.abc import Collection, Iterator

from household.config.faults import Fault, Sound, step_of
from household.errors import choose_from
from household.scenario.behavior import catalogue
from household.scenario.change import Change
from household.scenario.norms import Norms
from household.scenario.scenario import Scenario


def norm_faults(norms: Norms, known: Collection[str], path: str) -> Iterator[Fault]:
    """Norms that are about behaviors which nobody knows.

    Args:
        norms: What is thought.
        known: All behaviors that there are.
        path: Where the norms stand.
    """
    for activity, norm in norms.items():
        for part in ("attending", "absorbed"):
            for name in getattr(norm, part):
                if name not in known:
                    problem = choose_from(name, known, "behavior")
                    yield Fault(f"{path}.{step_of(activity)}.{part}", problem)


def change_faults(scenario: Scenario, sound: Sound) -> Iterator[Fault]:
    """Changes of nothing, of strangers, and of people who are still changing."""
    known = catalogue() | scenario.behavior
    for index, change in enumerate(scenario.changes):
        here = f"changes[{index}]"
        if not sound(here):
            continue
        if sound("behavior"):
            yield from norm_faults(change.norms, known, f"{here}.norms")
            yield from norm_faults(change.preferences, known, f"{here}.preferences")
        if sound("people"):
            yield from _strangers(change, scenario.person_names, here)
            yield from _too_early(scenario, index, sound)
        if sound("heterogeneity"):
            yield from _idle(change, scenario.heterogeneity, here)


def _strangers(change: Change, names: Collection[str], here: str) -> Iterator[Fault]:
    for place, name in enumerate(change.people):
        if name not in names:
            yield Fault(f"{here}.people[{place}]", choose_from(name, names, "person"))


def _idle(change: Change, heterogeneity: float, here: str) -> Iterator[Fault]:
    """Whatever a change names must be able to change what people want."""
    seed = change.population_seed is not None
    if not (change.norms or change.preferences or seed):
        yield Fault(here, "needs norms, preferences or population_seed")
    if change.norms and heterogeneity == 1.0:
        yield Fault(f"{here}.norms", "tell nothing where heterogeneity is 1")
    for name, given in (("preferences", change.preferences), ("population_seed", seed)):
        if given and heterogeneity == 0.0:
            yield Fault(f"{here}.{name}", "tells nothing where heterogeneity is 0")


def _too_early(scenario: Scenario, index: int, sound: Sound) -> Iterator[Fault]:
    """A change may begin only when the one before it of the same person is over."""
    change = scenario.changes[index]
    for other, before in enumerate(scenario.changes):
        first = (before.at, other) < (change.at, index)
        if not (first and before.ends > change.at and sound(f"changes[{other}]")):
            continue
        for name in scenario.person_names:
            if before.concerns(name) and change.concerns(name):
                yield Fault(
                    f"changes[{index}].at",
                    f"{change.at:g}, while {name} still changes; "
                    f"allowed: at least {before.ends:g}, when changes[{other}] is over",
                )
                break

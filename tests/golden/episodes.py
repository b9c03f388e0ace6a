"""Golden episodes: a household lived through by robots that act by chance."""

from functools import partial

import numpy as np

from household import household_v0
from household.config.toml import shipped
from household.home.sources.generator import generate

from .digest import Digests
from .records import of_cause, of_situation, of_touch

SEED = 7
STEPS = 1400
"""Of each episode; the second phase of experiment 5 begins after 1200."""

INTERRUPTS, IDLES = 0.1, 0.2
"""Chance in each step that a robot breaks off what it does, and that one which is done
waits before it goes on."""


KINDS = (
    *("absorbed", "child", "easygoing", "elder", "fickle"),
    *("light_sleeper", "moody", "paper_actor"),
)
"""Personas of the crowd: by name, so that new ones change no history."""


def crowded(**settings):
    """A generated home with eight people of all kinds and three robots.

    Everybody is just as its persona has it: what individuals depart from it is NumPy's
    exponential, whose last bit depends on the processor.
    """
    home = generate(3, rooms=8)
    return household_v0.parallel_env(
        "evening",
        home=home,
        people=[{"name": f"person_{i}", "persona": k} for i, k in enumerate(KINDS)],
        robots=[{"position": region.center} for region in home.regions[1:4]],
        heterogeneity=0.0,
        **settings,
    )


HOMES = {
    "generated": crowded,
    **{name: partial(household_v0.parallel_env, name) for name in shipped("scenario")},
}
"""Scenario -> what makes its environment."""


def episode(scenario: str) -> dict[str, str]:
    """The digests of a scenario's golden episode, by what they are of."""
    make = HOMES[scenario]
    home = make(max_cycles=STEPS)
    # Lives through the same episode and shows it in the other encoding.
    other = make(max_cycles=STEPS, observation="situation")
    digests = Digests()
    chance = np.random.default_rng(SEED)
    digests.add("features", home.reset(seed=SEED)[0])
    digests.add("encoded situations", other.reset(seed=SEED)[0])
    note_moment(digests, home)
    while home.agents:
        actions = chosen(home, chance)
        observations, rewards, *_ = home.step(actions)
        digests.add("features", observations)
        digests.add("encoded situations", other.step(actions)[0])
        digests.add("rewards", rewards)
        note_moment(digests, home)
    note_judgments(digests, home)
    return digests.told()


def chosen(home, chance: np.random.Generator) -> dict[str, int]:
    """Actions by chance; a robot without one goes on with what it does."""
    choices = {agent: choice(home, agent, chance) for agent in home.agents}
    return {agent: action for agent, action in choices.items() if action is not None}


def choice(home, agent: str, chance: np.random.Generator) -> int | None:
    """Begins a behavior, breaks one off, goes on with it, or says nothing."""
    dice, behavior = chance.random(), int(chance.integers(len(home.behaviors)))
    if home.behavior_over(agent):
        return behavior if dice >= IDLES else None
    if dice < INTERRUPTS:
        return behavior
    return home.behavior(agent).behavior if dice < 0.5 else None


def note_moment(digests: Digests, home) -> None:
    """Takes in what can be seen of this moment."""
    digests.add("state", home.state())
    for agent in home.possible_agents:
        digests.add("situations", of_situation(home.situation(agent)))
        digests.add("touches", [of_touch(touch) for touch in home.feedback(agent)])
        digests.add("causes", [of_cause(cause) for cause in home.causes(agent)])


def note_judgments(digests: Digests, home) -> None:
    """Takes in what people think of the robots in the end."""
    for agent in home.possible_agents:
        digests.add("opinions", home.opinion(agent))
        digests.add("appropriateness", home.appropriateness(agent))

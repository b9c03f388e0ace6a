"""Personas: the kinds of people that a household can hold."""

from typing import Annotated

import msgspec

from household.config.quantities import Name, Seconds, Share, Text
from household.config.toml import Record, load, locate
from household.scenario.norms import Norms


class Persona(Record, frozen=True, kw_only=True):
    """How a person moves, looks, judges and gives feedback.

    Every constant without a source is our choice (docs/deviations.md).

    Attributes:
        walking_speed: [m/s]; 1.2 is an adult's usual pace indoors.
        field_of_view: Full angle in which it sees [degrees]; about 120 for both eyes.
        head_speed: How fast it turns its head [degrees/s].
        absorption: What its activity holds back from the attention it can give to
            others; in units of a person's salience.
        praise: Chance that it caresses for a wholly polite bout that it did not
            come to expect.
        sanction: Chance that it taps for a wholly impolite bout; larger than
            ``praise``, as people "tend to sanction social faults, but rarely reward
            correct behavior" (paper, section 3.1).
        habituation: Share by which each polite bout takes away from the wish to
            praise the next one (paper, section 5.1: rewards become fewer).
        recovery: Time constant with which that wish comes back while nothing that
            pleases goes on [s]; habituation recovers when its stimulus is withheld.
        contrast: Share of the lost wish that comes back when it gave the robot a
            wholehearted tap (paper, section 5.2: "most of the positive rewards are
            given after the system has been punished and changed its behavior"). A
            fault that it did not sanction brings back nothing.
        tolerance: What it would mind or like less than this it does not judge; it may
            still judge the same bout when it perceives it better.
        reaction: Median time from a judgement to setting about a touch, for the
            faintest feelings [s]. 1.54 in CHARM (arXiv 2506.13079: 46 people, 4,967
            ratings of a robot arm), for ratings of 0.
        haste: Share of that time by which the strongest feelings are faster; 0.51, as
            the strongest ratings took 0.75 s there.
        reaction_spread: Standard deviation of its logarithm within a person; 0.48 is
            what is left of CHARM's 0.62 without the differences between people (0.3)
            and between strong and weak ratings (0.2).
        patience: How long it tries to reach a robot before it gives up [s].
        mistakes: Chance that a touch comes out as the opposite of what was meant.
        doubt: How untruly touches tell faint feelings: for a bout valued at v, a touch
            is the opposite of what was meant with chance 1 / (1 + exp(2 abs(v) /
            doubt)); 0: never. It is 1 / rationality of the stochastic teacher of B-Pref
            (Lee et al. 2021).
        myopia: Weight of what the robot did last against what made the person set
            out, in [0, 1]: where the product of it and the newer feeling is the
            larger, the touch is about the newer bout (after B-Pref's myopic
            teacher).
        only_when_attending: Judges only what goes on while it attends to the robot,
            and gives feedback for nothing else (the actors of experiments 1 and 2).
        irritability: How far a bad mood raises the chance to sanction.
        mood_change: Share by which one wholly pleasing or annoying bout moves the
            mood towards its end of the scale.
        mood_recovery: Time constant with which a mood fades [s].
        robot_interest: Chance to look at a robot whenever the gaze moves on.
        people_interest: Chance to look at a person whenever the gaze moves on.
        gaze_dwell: Mean time that the gaze rests on one thing [s].
        reflex: Chance that a loud robot draws the eye.
        wakes_at: Level at the ear that wakes it [dB]; 45 for a light sleeper, 60
            for a sound one.
        awake_for: How long it lies awake then [s].
        preferences: What it finds polite, where that departs from the household's
            norms; tells as far as the scenario's heterogeneity lets it.
    """

    name: Name
    description: Text = ""
    walking_speed: Annotated[float, msgspec.Meta(gt=0, le=3)] = 1.2
    field_of_view: Annotated[float, msgspec.Meta(gt=0, le=360)] = 120.0
    head_speed: Annotated[float, msgspec.Meta(gt=0, le=3600)] = 180.0
    absorption: Annotated[float, msgspec.Meta(ge=0.001, le=100)] = 0.3
    praise: Share = 0.5
    sanction: Share = 0.9
    habituation: Share = 0.15
    recovery: Seconds = 120.0
    contrast: Share = 0.5
    tolerance: Share = 0.1
    reaction: Annotated[float, msgspec.Meta(ge=0, le=3600)] = 1.54
    haste: Share = 0.51
    reaction_spread: Annotated[float, msgspec.Meta(ge=0, le=3)] = 0.48
    patience: Seconds = 20.0
    mistakes: Share = 0.0
    doubt: Annotated[float, msgspec.Meta(ge=0, le=100)] = 0.0
    myopia: Share = 0.0
    only_when_attending: bool = False
    irritability: Share = 0.3
    mood_change: Share = 0.2
    mood_recovery: Seconds = 300.0
    robot_interest: Share = 0.2
    people_interest: Share = 0.2
    gaze_dwell: Seconds = 4.0
    reflex: Share = 0.3
    wakes_at: Annotated[float, msgspec.Meta(gt=0, le=200)] = 55.0
    awake_for: Seconds = 20.0
    preferences: Norms = msgspec.field(default_factory=dict)


def load_persona(name: str) -> Persona:
    """Reads a shipped persona by name, or a TOML file by path, as it is now.

    Raises:
        HouseholdError: If it cannot be found or a field is wrong.
    """
    return load(locate(name, "persona"), Persona)

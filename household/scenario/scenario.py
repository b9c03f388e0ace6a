"""Scenarios: who lives where, with which robots, as frozen records read from TOML."""

from typing import Annotated, Literal

import msgspec

from household.config.quantities import (
    Angle,
    Count,
    FileName,
    Length,
    Name,
    Position,
    Seconds,
    Share,
    Text,
)
from household.config.toml import Record
from household.home.floorplan import FloorPlan, load_floorplan
from household.scenario.behavior import Behavior, catalogue
from household.scenario.change import Change
from household.scenario.norms import Norms, household_norms
from household.scenario.persona import Persona, load_persona
from household.scenario.population import Population, individual

Range = tuple[Seconds, Seconds]

MOST_PEOPLE, MOST_ROBOTS = 64, 16
"""In one household; robots perceive all of them at once."""

MOST_BEHAVIORS = 64
"""That robots choose from; learners keep numbers for each in each situation."""

MOST_LINES = 500
"""Of a script, and places of a schedule."""

PersonName = Annotated[
    str,
    msgspec.Meta(
        pattern=r"^[a-z][a-z0-9_]{0,49}\Z",
        description="a letter, then up to 49 of a-z, 0-9 and _",
    ),
]

FEW = msgspec.Meta(max_length=MOST_LINES)

Weight = Annotated[float, msgspec.Meta(ge=0, le=1e6)]
Weights = Annotated[
    dict[Name, Weight], msgspec.Meta(min_length=1, max_length=MOST_LINES)
]


class ScriptStep(Record, frozen=True, kw_only=True):
    """One line of a person's script.

    Attributes:
        place: Name of an activity region, or an activity (its first region).
        duration: Shortest and longest time spent there, drawn anew each time [s];
            it counts from arrival, and stands still while the person is away to
            give feedback. Either this or ``until``.
        until: When the line ends, in time since the episode began [s].
        look_at: Name of a robot or a person to attend to; None: gaze habits.
        look_for: Shortest and longest time of looking there at a stretch [s]; None:
            all the time.
        look_away: Shortest and longest time of not looking there, in between [s].
    """

    place: str
    duration: Range | None = None
    until: Seconds | None = None
    look_at: str | None = None
    look_for: Range | None = None
    look_away: Range = (10.0, 30.0)


class Stay(Record, frozen=True, kw_only=True):
    """One place of a person's schedule (a semi-Markov chain).

    Attributes:
        duration: Shortest and longest time spent there, from arrival [s].
        then: Weight of each place to go to afterwards; a place or an activity.
    """

    duration: Range
    then: Weights


class PersonSpec(Record, frozen=True, kw_only=True):
    """A person of the household.

    Attributes:
        name: Unique in the scenario.
        persona: Name of a shipped persona, a TOML path (from the folder of the
            scenario's file), or the record itself.
        start: Where the person begins [m]; None: in its first place.
        script: What the person does, line by line, over and over.
        schedule: What the person does by chance, by place; begins with the first.
            Without a script or a schedule, the one that is shipped is followed,
            as far as the home has places for it.
        number: Which person of the population it is, so that it is the same one
            wherever it lives; None: the one of its place in the list.
    """

    name: PersonName
    persona: FileName | Persona = "easygoing"
    start: Position | None = None
    script: Annotated[tuple[ScriptStep, ...], FEW] = ()
    schedule: Annotated[dict[Name, Stay], FEW] = msgspec.field(default_factory=dict)
    number: Annotated[int, msgspec.Meta(ge=0, lt=2**31)] | None = None


class RobotSpec(Record, frozen=True, kw_only=True):
    """A robot of the household; they are called robot_0, robot_1, ... in order.

    Attributes:
        position: Where it begins [m].
        heading: Where it faces at first [degrees].
    """

    position: Position
    heading: Angle = 0.0


class SituationModel(Record, frozen=True, kw_only=True):
    """Which relations a situation holds.

    Attributes:
        attention: none: roles alone; robot: also who attends to the robot that the
            situation is seen from; all: who attends to whom.
        near: Distance within which somebody counts as near the robot, unless a wall or
            a closed door is between [m]; None: situations do not say who is near.
        hears: Loudness of the sounds of the robot that somebody would hear or not, past
            walls and closed doors [dB at 1 m]; 75 is playing, 60 a greeting. None:
            situations do not say who would hear the robot.
    """

    attention: Literal["none", "robot", "all"] = "robot"
    near: Length | None = None
    hears: Annotated[float, msgspec.Meta(gt=0, le=120)] | None = None


class PerceptionModel(Record, frozen=True, kw_only=True):
    """Constants of sight, attention and hearing; our choice (docs/deviations.md).

    What robots notice of people who come to touch them is derived from published
    figures of walking (RiMEA's guideline) and of head turns (bioRxiv
    2025.04.29.650670).

    Attributes:
        focus: Width of the gaze's focus, sigma [degrees].
        distance: d0, at which an entity counts half [m].
        attend_above: Share of attention above which one begins to attend.
        attend_below: Share of attention below which one ceases to; lower, so that
            attending does not flicker.
        wall_loss: What a wall takes from a sound [dB]; light indoor walls 25 to 35.
        mood_noise: Standard deviation with which a robot misreads a mood.
        notice_delay: How late a robot notices that somebody sets out or turns to it
            [s]; 0.5: until then somebody at 1 m/s has walked half a meter, and a usual
            turn of the head (58 degrees at 104 degrees/s) is nearly over.
        notice_noise: Standard deviation of that time [s]; 0.3: for half a meter, people
            who walk at 0.58 to 1.61 m/s take 0.31 to 0.86 s.
    """

    focus: Annotated[float, msgspec.Meta(ge=1, le=180)] = 30.0
    distance: Annotated[float, msgspec.Meta(ge=0.01, le=100)] = 3.0
    attend_above: Share = 0.4
    attend_below: Share = 0.25
    wall_loss: Annotated[float, msgspec.Meta(ge=0, le=200)] = 25.0
    mood_noise: Annotated[float, msgspec.Meta(ge=0, le=10)] = 0.2
    notice_delay: Annotated[float, msgspec.Meta(ge=0, le=60)] = 0.5
    notice_noise: Annotated[float, msgspec.Meta(ge=0, le=60)] = 0.3


class Slots(Record, frozen=True, kw_only=True):
    """Room in the feature observations, so that scenarios can share a layout.

    Attributes:
        people: At least as many as the scenario has; None: just as many.
        robots: The same for robots.
    """

    people: Annotated[int, msgspec.Meta(ge=1, le=MOST_PEOPLE)] | None = None
    robots: Annotated[int, msgspec.Meta(ge=1, le=MOST_ROBOTS)] | None = None


class Scenario(Record, frozen=True, kw_only=True):
    """A household and what happens in it.

    Attributes:
        home: Name of a shipped home, a TOML path (from the folder of the scenario's
            file), or the floor plan itself.
        max_cycles: Decisions in an episode.
        decision_period: Time between the robots' decisions [s].
        steering_period: Time between looks at where everybody walks [s].
        physics_period: Length of a physics tick [s].
        behaviors: What the robots can choose, in the order of their actions.
        behavior: The user's own behaviors, by name.
        norms: What the household finds polite; None: the norms that are shipped.
        heterogeneity: How far people depart from the norms and from each other: 0
            makes roles interchangeable, 1 gives everybody a taste of its own.
        population: Draws in what people depart from the norms.
        changes: When people begin to want something else, and what.
    """

    name: Name
    description: Text = ""
    home: FileName | FloorPlan = "smart_room"
    max_cycles: Count = 1000
    decision_period: Annotated[float, msgspec.Meta(ge=0.01, le=60)] = 1.0
    steering_period: Annotated[float, msgspec.Meta(ge=0.01, le=1)] = 0.2
    physics_period: Annotated[float, msgspec.Meta(ge=0.001, le=0.5)] = 0.1
    behaviors: Annotated[
        tuple[Name, ...], msgspec.Meta(min_length=2, max_length=MOST_BEHAVIORS)
    ]
    behavior: Annotated[dict[Name, Behavior], FEW] = msgspec.field(default_factory=dict)
    people: Annotated[
        tuple[PersonSpec, ...], msgspec.Meta(min_length=1, max_length=MOST_PEOPLE)
    ]
    robots: Annotated[
        tuple[RobotSpec, ...], msgspec.Meta(min_length=1, max_length=MOST_ROBOTS)
    ]
    norms: Norms | None = None
    heterogeneity: Share = 0.0
    population: Population = Population()
    changes: Annotated[tuple[Change, ...], FEW] = ()
    situation: SituationModel = SituationModel()
    perception: PerceptionModel = PerceptionModel()
    slots: Slots = Slots()

    @property
    def plan(self) -> FloorPlan:
        """The home's floor plan."""
        home = self.home
        return home if isinstance(home, FloorPlan) else load_floorplan(home)

    @property
    def personas(self) -> tuple[Persona, ...]:
        """Each person's persona with its individual traits, in order."""
        return tuple(
            individual(persona_of(spec), self.population, self.heterogeneity, number)
            for spec, number in zip(self.people, self.numbers, strict=True)
        )

    @property
    def numbers(self) -> tuple[int, ...]:
        """Which person of the population each person is, in order."""
        return tuple(
            index if spec.number is None else spec.number
            for index, spec in enumerate(self.people)
        )

    @property
    def repertoire(self) -> tuple[Behavior, ...]:
        """The robots' behaviors, in the order of their actions."""
        known = catalogue() | self.behavior
        return tuple(known[name] for name in self.behaviors)

    @property
    def robot_names(self) -> tuple[str, ...]:
        """robot_0, robot_1, ..."""
        return tuple(f"robot_{index}" for index in range(len(self.robots)))

    @property
    def person_names(self) -> tuple[str, ...]:
        """The people's names, in order."""
        return tuple(person.name for person in self.people)

    @property
    def household_norms(self) -> Norms:
        """The norms that hold in this household."""
        return household_norms() if self.norms is None else self.norms


def persona_of(spec: PersonSpec) -> Persona:
    """The persona that a person is made after."""
    named = spec.persona
    return named if isinstance(named, Persona) else load_persona(named)

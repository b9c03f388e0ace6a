"""The simulation: what happens in a household between one decision and the next.

`Simulation` holds everything that exists and moves; it knows nothing of agents, spaces
or rewards. The environment steps it, and evaluators and replays look at it.
"""

import math
from collections.abc import Iterable
from functools import partial

import numpy as np

from household.compiled.arrays import Floats
from household.compiled.jit import bind
from household.feedback import Feedback
from household.home.navigation.routes import BODY
from household.motion.bodies import BodyParams, Pursuit
from household.motion.crowd import Crowd
from household.observation.kernel import View
from household.people.appropriateness import weigh_behaviors
from household.people.feelings import misread
from household.people.mind import Wish
from household.people.people import MakeMinds, People
from household.people.wishes import REACH
from household.perception.noticing import Noticing
from household.perception.proximity import Proximity
from household.perception.relations import Entities
from household.perception.senses import Senses
from household.robots.motions import MOTIONS, Mover
from household.robots.robots import Robots
from household.scenario.scenario import MOST_PEOPLE, Scenario
from household.simulation.moment import DECISION, Record, field_of, record_type
from household.simulation.random_streams import Draws, Streams
from household.state import Stateful

PERSON_RADIUS, ROBOT_RADIUS = BODY, 0.15
"""Of the bodies [m]; the robot's is that of a small dog, as the AIBO is."""

PERSON_MASS, ROBOT_MASS = 70.0, 2.0
"""Of the bodies [kg]; an AIBO weighs about 2 kg."""

ROBOT_SPEED = 0.5
"""At which robots walk [m/s]."""

ROBOT_HEAD_SPEED = 360.0
"""How fast robots turn their heads [degrees/s]."""

ROBOT_VIEW = math.radians(120.0) / 2
"""Half a robot's field of view [rad]."""

PHASES = (
    *("move_robots", "find_paths", "walk_and_touch", "turn_heads"),
    *("perceive", "appraise", "decide"),
)
"""What happens in a decision period once robots have chosen, in this order. Where many
homes are simulated, each phase goes through all of them before the next one begins: the
processor then finds in its caches what the phase needs."""


class Simulation(Stateful):
    """The people and the robots of a household, their bodies and their senses.

    Args:
        scenario: Who lives where.
        make_minds: Gives the scenario's people their minds.

    Attributes:
        scenario: Who lives where.
        people: What they think and intend.
        robots: What they do and feel.
        crowd: Everybody's body; people come first and robots after them.
        senses: Who sees, hears and attends to whom.
        moods: The people's moods as each robot reads them, (n_robots, n_people).
        view: What robots may know of this moment.
        record: What is recorded of this moment, shape (); most arrays of the others
            that change from moment to moment are views of its fields.
        half_view: Half of each one's field of view, (n,) [rad]; negative: eyes closed.
        revision: Another number whenever roles or attention are others than before.
        decision: Decisions since the beginning.
        time: Since the beginning [s].
        begun: Whether an episode was ever begun.
    """

    STATE = (
        "record",
        "decision",
        "time",
        "people",
        "robots",
        "crowd",
        "senses",
        "proximity",
        "noticing",
        "moods",
        "_salience",
        "_source",
        "_streams",
        "_noise",
    )

    def __init__(self, scenario: Scenario, make_minds: MakeMinds) -> None:
        self.scenario = scenario
        n = len(scenario.people) + len(scenario.robots)
        # One block of memory, so that a recorder copies the moment in one go.
        self.record: Record = np.zeros((), record_type(scenario))
        zeros = partial(field_of, self.record)
        self.people = People(scenario, make_minds, zeros)
        self.robots = Robots(scenario, zeros)
        self.revision, self.begun = 0, False
        self._set_clock(0)
        personas = [person.persona for person in self.people.everyone]
        n_people, n_robots = len(personas), len(self.robots.names)
        self._n_people = n_people
        self.crowd = Crowd(
            scenario.plan,
            params=BodyParams(
                np.array([PERSON_RADIUS] * n_people + [ROBOT_RADIUS] * n_robots),
                np.array([PERSON_MASS] * n_people + [ROBOT_MASS] * n_robots),
                np.array(
                    [p.walking_speed for p in personas] + [ROBOT_SPEED] * n_robots
                ),
            ),
            steering_period=scenario.steering_period,
            physics_period=scenario.physics_period,
            zeros=zeros,
        )
        self.senses = Senses(
            scenario.plan, scenario.perception, n, silent=n_people, zeros=zeros
        )
        self.proximity = Proximity(scenario.situation, n_people, n_robots)
        self.noticing = Noticing(scenario.perception, n, scenario.decision_period)
        self._pursuit = Pursuit(self.people.wishes.target, REACH)
        self._streams = Streams(n_people, n_robots)
        head_speed = [p.head_speed for p in personas] + [ROBOT_HEAD_SPEED] * n_robots
        self._head_turn = np.radians(head_speed) * scenario.decision_period
        self._absorption = np.array([p.absorption for p in personas] + [1.0] * n_robots)
        self.half_view: Floats = zeros("half_view", (n,))
        self.half_view[:] = ROBOT_VIEW
        self.moods = np.zeros((n_robots, n_people))
        self._salience = np.ones(n_people + n_robots)
        self._source = np.zeros(n_people + n_robots)
        self._moments = round(scenario.decision_period / scenario.steering_period)
        # What is perceived is always in the same arrays.
        self._entities = Entities(
            self.crowd.position,
            self.crowd.gaze,
            self.half_view,
            self._salience,
            self._absorption,
            self._source,
        )
        noise, mood = scenario.perception.mood_noise, self.people.feelings.mood
        self._misread = bind(misread, mood, noise, self.moods)
        self._motions = [MOTIONS[b.motion] for b in scenario.repertoire]
        preferences = self.people.preferences
        self._weigh_behaviors, self._weigh_on_average = (
            bind(
                weigh_behaviors,
                values,
                np.array([behavior.loudness for behavior in scenario.repertoire]),
                self.people.appearance.activity,
                self.senses.relations,
            )
            for values in (preferences.values, preferences.on_average)
        )
        self.view = self._view()

    def begin(self, seed: int | None) -> None:
        """Begins an episode.

        Args:
            seed: Begins a history of its own; None goes on with the present one.
        """
        self.begun = True
        self._set_clock(0)
        self.revision += 1
        self._streams.begin(seed)
        # Drawn for as many as could be here, so that one more shifts nobody's draws.
        self._noise = Draws(self._streams.faces, MOST_PEOPLE, "normal")
        self._movers = [
            Mover(
                body=self._n_people + robot,
                n_people=self._n_people,
                spots=self.people.places.centers,
                rng=rng,
                period=self.scenario.decision_period,
            )
            for robot, rng in enumerate(self._streams.robots)
        ]
        self.robots.begin()
        self.senses.forget()
        self.proximity.forget()
        self.noticing.begin(self._streams.noticed)
        people = self.people.begin(self._streams.people)
        robots = np.array([spec.position for spec in self.scenario.robots])
        headings = np.radians([spec.heading for spec in self.scenario.robots])
        self.crowd.place(
            np.vstack([people, robots]),
            np.concatenate([np.zeros(len(people)), headings]),
        )
        self.people.appear(self.crowd.position, self.half_view)
        self._look_around(np.full(len(self._head_turn), 2 * np.pi))
        self.perceive()

    def go_on(self, choices: Iterable[tuple[int, int]]) -> None:
        """Lets one decision period pass.

        Robots do what they chose; people walk, look around and touch; everybody
        perceives; people judge what is new to them and decide what to do next.

        Args:
            choices: Pairs of a robot and its behavior, by index; a robot without a
                choice goes on with what it does.
        """
        self.choose(choices)
        for phase in PHASES:
            getattr(self, phase)()

    def choose(self, choices: Iterable[tuple[int, int]]) -> None:
        """Robots begin what they chose; then come all `PHASES`.

        Args:
            choices: As for `go_on`.
        """
        for robot, behavior in choices:
            self.robots.choose(robot, behavior, self.decision, self.time)

    def prepare(self) -> bool:
        """Does a little of the work of later moments, which is the same whenever done.

        Returns:
            Whether there was any.
        """
        return self.begun and (self.crowd.find_paths() or self._noise.draw_ahead())

    def _set_clock(self, decision: int) -> None:
        self.decision = decision
        self.time = decision * self.scenario.decision_period
        self.record[DECISION] = decision

    def move_robots(self) -> None:
        """Robots move as their behaviors have it; who is done stands still."""
        n_people, now = self._n_people, self.time
        for robot, bout in enumerate(self.robots.bouts):
            if self.robots.is_over(robot, now):
                self.crowd.halt(n_people + robot)
                continue
            mover = self._movers[robot]
            mover.begins = bout.decision == self.decision
            self._motions[bout.behavior](mover, self.crowd)

    def find_paths(self) -> None:
        """Paths are found for all who have set out, unless that was prepared."""
        self.crowd.find_paths()

    def walk_and_touch(self) -> None:
        """People walk and touch robots that they reach, until the period is over."""
        self.robots.forget_touches()
        moment = 0
        while moment < self._moments:
            left = self._moments - moment
            moment += self.crowd.advance(left, self._pursuit)
            now = self.time + moment * self.scenario.steering_period
            at_hand = self.people.wishes_at_hand(self.crowd, self.senses)
            for i, wish in at_hand.items():
                self._touch(i, wish, now)
        self._set_clock(self.decision + 1)

    def turn_heads(self) -> None:
        """Everybody turns its head as far as it gets in a period."""
        self._look_around(self._head_turn)

    def _touch(self, i: int, wish: Wish, now: float) -> None:
        """A person touches a robot, which feels it and sees who it was."""
        person, j = self.people.everyone[i], self._n_people + wish.robot
        relations, position = self.senses.relations, self.crowd.position
        turned = relations.attention_began[i, j]
        came, turned = self.noticing.touch(i, j, position, now, turned)
        feedback = Feedback(
            giver=person.name,
            kind=wish.kind,
            strength=wish.strength,
            time=now,
            mood=float(self.moods[wish.robot, i]),
            attending=bool(relations.attends[i, j]),
            approach_began=came,
            attention_began=turned,
        )
        self.robots.feel(wish.robot, feedback, wish.cause)
        self.people.wishes.fulfill(i)
        self.crowd.halt(i)

    def _look_around(self, most: Floats) -> None:
        """Everybody turns its head towards what it wants to look at."""
        look, focus = self.people.look, self.people.appearance.focus
        self.crowd.turn_heads(look, focus, most)

    def perceive(self) -> None:
        """Everybody sees, hears and attends; robots read moods off faces."""
        since = self.time - self.scenario.decision_period
        changed = self.people.appear(self.crowd.position, self.half_view)
        self.robots.show(since, self.time, self._salience, self._source)
        changed |= self.senses.perceive(self._entities, self.time)
        changed |= self.proximity.update(
            self.senses.obstructions, self.senses.relations
        )
        self.revision += changed
        self.noticing.remember(self.decision, self.crowd.position)
        self._misread(self._noise.next())

    def appraise(self) -> None:
        """People judge what is new to them."""
        if self.time >= self.people.preferences.until:
            self.people.preferences.hold_at(self.time)
        since = self.time - self.scenario.decision_period
        self.people.appraise(self.senses, self.robots, since)

    def decide(self) -> None:
        """People decide what to do next, and set out."""
        self.people.decide(self.crowd, self.senses, self.robots, self.time)

    def _view(self) -> View:
        """What robots may know; made once, as all arrays stay the same."""
        relations, robots = self.senses.relations, self.robots
        return View(
            position=self.crowd.position,
            facing=relations.facing,
            attends=relations.attends,
            attention=relations.attention,
            walking=self.crowd.walking,
            activity=self.people.appearance.activity,
            mood=self.moods,
            behavior=robots.present.behavior,
            left=robots.left,
            touches=robots.felt,
            near=self.proximity.close.near,
            hears=self.proximity.close.hears,
        )

    def appropriateness(self, robot: int, *, on_average: bool = False) -> Floats:
        """What the people present would think of each behavior of a robot now.

        The mean over all people of their preference times how strongly each would
        see or hear that behavior.

        Args:
            robot: Index of the robot.
            on_average: As if each were the average of those who live here.

        Returns:
            Shape (n_behaviors,), in [-1, 1].
        """
        weigh = self._weigh_on_average if on_average else self._weigh_behaviors
        appropriateness = np.zeros(len(self.scenario.repertoire))
        weigh(robot, appropriateness)
        return appropriateness

"""Appropriateness: what the people who are there would think of each behavior now."""

from typing import Annotated

from household.compiled.arrays import Floats, Indices
from household.compiled.jit import compiled
from household.people.appraisal import heard_strength, seen_strength
from household.perception.relations import Relations


@compiled
def weigh_behaviors(
    preferences: Annotated[Floats, "n_people", "n_activities", 2, "n_behaviors"],
    loudness: Annotated[Floats, "n_behaviors"],
    activity: Annotated[Indices, "n_people"],
    relations: Relations,
    robot: int,
    appropriateness: Annotated[Floats, "n_behaviors"],
) -> None:
    """The mean over all people of preference times how well each would perceive it.

    Args:
        preferences: Shape (n_people, n_activities, 2, n_behaviors), in [-1, 1]; the
            third axis says whether the person attends to the robot.
        loudness: Of each behavior at 1 m, shape (n_behaviors,) [dB].
        activity: The role that each person plays, shape (n_people,).
        relations: How well everybody perceives each, people first.
        robot: Its index among the robots.
        appropriateness: Filled in, shape (n_behaviors,), in [-1, 1].
    """
    n_people = len(activity)
    target = n_people + robot
    appropriateness[:] = 0.0
    for i in range(n_people):
        seen = seen_strength(relations.attention[i, target])
        liked = preferences[i, activity[i], int(relations.attends[i, target])]
        for behavior in range(len(loudness)):
            heard = heard_strength(loudness[behavior] - relations.loss[i, target])
            appropriateness[behavior] += liked[behavior] * max(seen, heard)
    for behavior in range(len(loudness)):
        appropriateness[behavior] /= n_people

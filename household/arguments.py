"""What callers hand to an environment, checked; a mistake is one line."""

import operator
from collections.abc import Collection, Mapping

from household.errors import HouseholdError, choose_from, shown


def checked_seed(seed: object) -> int | None:
    """A seed as Python's own number.

    Raises:
        HouseholdError: If it is neither None nor a whole number from 0 up.
    """
    if seed is None:
        return None
    number = _whole(seed)
    if number < 0:
        raise HouseholdError(
            f"seed: {shown(seed)}; allowed: None or a whole number from 0 up"
        )
    return number


def checked_count(name: str, number: object, least: int) -> int:
    """How many there are to be, as Python's own number.

    Args:
        name: Of the argument.
        number: What the caller handed over.
        least: The smallest number that is allowed.

    Raises:
        HouseholdError: If it is no whole number from ``least`` up.
    """
    count = _whole(number)
    if count < least:
        raise HouseholdError(
            f"{name}: {shown(number)}; allowed: whole numbers from {least} up"
        )
    return count


def check_name(name: object, allowed: Collection[str], what: str) -> None:
    """Refuses a name that is none of those allowed.

    Raises:
        HouseholdError: Names what is nearest to it.
    """
    if not isinstance(name, str) or name not in allowed:
        raise HouseholdError(choose_from(name, allowed, what))


def robot_index(agent: str, index: Mapping[str, int]) -> int:
    """Index of a robot.

    Args:
        agent: Its name.
        index: Of each robot.

    Raises:
        HouseholdError: If there is no such robot.
    """
    try:
        return index[agent]
    except (KeyError, TypeError):
        raise HouseholdError(choose_from(agent, index, "agent")) from None


def checked_choices(
    actions: Mapping[str, int], index: Mapping[str, int], n_behaviors: int
) -> dict[int, int]:
    """The behavior that each robot chose, by the robot's index.

    Args:
        actions: By agent.
        index: Of each robot.
        n_behaviors: How many behaviors there are.

    Raises:
        HouseholdError: If an agent is none of the robots, or an action is none of the
            behaviors.
    """
    if not isinstance(actions, Mapping):
        raise HouseholdError(
            f"actions: {shown(actions)}; allowed: a behavior for each agent, "
            "as in {'robot_0': 0}"
        )
    choices = {}
    for agent, action in actions.items():
        # Asked directly, and only then in a way that says what is wrong: every step
        # comes by here.
        robot = index[agent] if agent in index else robot_index(agent, index)
        behavior = action if type(action) is int else _whole(action)
        if not 0 <= behavior < n_behaviors:
            raise HouseholdError(
                f"{agent}: action {shown(action)} is none of the behaviors; "
                f"allowed: 0 to {n_behaviors - 1}"
            )
        choices[robot] = behavior
    return choices


def _whole(number: object) -> int:
    """A whole number as Python's own, or -1 for anything else."""
    try:
        return operator.index(number)  # type: ignore[arg-type]
    except TypeError:
        return -1

"""Activities: the roles that a person can play (paper, section 4.2)."""

from enum import IntEnum


class Activity(IntEnum):
    """What a person does, read off the activity region that it stands in.

    The first six are regions of the floor plan (paper, figure 2); ``UNKNOWN``
    is every place outside them. Tables are indexed in this order.
    """

    WORKING = 0
    READING = 1
    SLEEPING = 2
    PLAYING = 3
    ENTERING = 4
    CALLING = 5
    UNKNOWN = 6

    @property
    def label(self) -> str:
        """The name used in TOML files and texts, as in "working"."""
        return self.name.lower()


ACTIVITY_NAMES: tuple[str, ...] = tuple(activity.label for activity in Activity)


def activity_of(name: str) -> Activity:
    """The activity with this TOML name.

    Raises:
        KeyError: If no activity has that name.
    """
    return Activity[name.upper()]

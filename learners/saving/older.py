"""What was called something else in files of an older version of the format."""

from typing import Any

CLASSES = {"Feedback": "Reward"}
"""Old name of a class -> its name now."""

FIELDS = {"Experience": {"feedback": "rewards"}}
"""Class, by its name now -> old name of a field -> its name now."""

FORGOTTEN = {"_credits"}
"""Fields of what was said of the last touch alone; nothing is lost without them."""


def upgraded(name: str, data: dict[str, Any]) -> tuple[str, dict[str, Any]]:
    """A saved object of version 1 as it would be saved now.

    Args:
        name: of its class.
        data: what was saved of it, by field, as JSON.

    Returns:
        Both of today.
    """
    name = CLASSES.get(name, name)
    fields = FIELDS.get(name, {})
    kept = {fields.get(k, k): v for k, v in data.items() if k not in FORGOTTEN}
    return name, kept

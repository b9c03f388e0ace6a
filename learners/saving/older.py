"""What was saved otherwise in files of an older version of the format."""

from collections.abc import Callable
from typing import Any

Data = dict[str, Any]
"""What was saved of an object, by field, as tagged JSON."""

CLASSES = {"Feedback": "Reward"}
"""Old name of a class -> its name now."""

FIELDS = {
    "Experience": {"feedback": "rewards"},
    "Advise": {"votes": "table"},
    "Tamer": {"model": "table"},
    "Coach": {"preferences": "table"},
    "ECoach": {"preferences": "table"},
}
"""Class, by its name now -> old name of a field -> its name now."""

FORGOTTEN = {"_credits"}
"""Fields of what was said of the last touch alone; nothing is lost without them."""


def upgraded(name: str, data: Data) -> tuple[str, Data]:
    """A saved object of version 1 as it would be saved now.

    Args:
        name: of its class.
        data: what was saved of it.

    Returns:
        Both of today.
    """
    name = CLASSES.get(name, name)
    fields = FIELDS.get(name, {})
    kept = {fields.get(k, k): v for k, v in data.items() if k not in FORGOTTEN}
    for (class_name, field), change in CHANGES.items():
        if field in kept and class_name in (name, ANY):
            change(kept)
    return name, kept


def _canonical_is_a_representation(data: Data) -> None:
    if data["analogy"]["object"] == "Canonical":
        data["representation"] = data["analogy"]
        data["analogy"] = {"object": "Analogy", "data": {}}


def _opinions_are_rows(data: Data) -> None:
    """Place and behavior -> person -> (touches, mean) is a row by place and person."""
    n = data["n_behaviors"]
    rows: dict[str, tuple[Any, tuple[list[float], list[float]]]] = {}
    for key, by_person in data.pop("opinions")["dict"]:
        place, behavior = key["tuple"]
        for person, told in by_person["dict"]:
            touches, mean = told["tuple"]
            part = {"tuple": [place, person]}
            _, row = rows.setdefault(str(part), (part, ([0.0] * n, [0.0] * n)))
            row[0][behavior], row[1][behavior] = mean, touches
    data["table"] = _table(n, list(rows.values()))
    deviations = ("population", "person", "touch")
    own = {name: data.pop(name) for name in deviations if name in data}
    if own:
        data["pooling"] = {"object": "HierarchicalPooling", "data": own}


def _counts_are_visits(data: Data) -> None:
    """Counts of each kind by behavior are the visits of one long row."""
    n = 3 * data["n_behaviors"]
    rows = [
        (state, ([0.0] * n, [count for kinds in counts for count in kinds]))
        for state, counts in data.pop("counts")["dict"]
    ]
    data["table"] = _table(n, rows)


def _table(n: int, rows: list[tuple[Any, tuple[list[float], list[float]]]]) -> Data:
    pairs = [[key, {"tuple": list(row)}] for key, row in rows]
    fields = {"n_behaviors": n, "initial": 0.0, "updates": 0, "rows": {"dict": pairs}}
    return {"object": "QTable", "data": {"dict": [[k, v] for k, v in fields.items()]}}


ANY = "any class"

CHANGES: dict[tuple[str, str], Callable[[Data], None]] = {
    (ANY, "analogy"): _canonical_is_a_representation,
    (ANY, "opinions"): _opinions_are_rows,
    ("ISabl", "counts"): _counts_are_visits,
}
"""Class and field of version 1 -> what makes of them what there is today."""

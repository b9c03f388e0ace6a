"""Data with faults, made whole enough to say what else is wrong with them."""

from typing import Any

from household.config.faults import faults, fields_of, items_in, record_in, table_in


class _Lost:
    """In place of what nothing can be made of."""


LOST = _Lost()


def mended(data: Any, kind: Any, spare: Any = LOST) -> Any:  # noqa: ANN401 - plain data
    """Data in which whatever is wrong is replaced by something that is not.

    What can be left out is left out; what an item of a list or table needs it takes
    from one of the others, so that all keep their places; anything else comes from a
    spare. Nothing can be learned from what was replaced: `Sound` tells what that is.

    Args:
        data: What a TOML file holds.
        kind: A record, or any annotation that a record's field may have.
        spare: Faultless data of the kind, for what cannot be left out.

    Returns:
        Plain data of the kind; `LOST` if that cannot be had.
    """
    record, table = record_in(kind), table_in(kind)
    whole: Any = data
    if isinstance(data, dict) and record is not None:
        whole = _record(data, record, spare if isinstance(spare, dict) else {})
    elif isinstance(data, dict) and table is not None:
        keys = [key for key in data if not any(faults(key, table[0]))]
        others = list(spare.values()) if isinstance(spare, dict) else []
        parts = _parts([(data[key], table[1]) for key in keys], others)
        whole = dict(zip(keys, parts, strict=True))
    elif isinstance(data, list | tuple):
        pairs = list(zip(data, items_in(kind, len(data)), strict=False))
        whole = _parts(pairs, list(spare) if isinstance(spare, list | tuple) else [])
    return spare if whole is LOST or any(faults(whole, kind)) else whole


def _parts(pairs: list[tuple[Any, Any]], spares: list[Any]) -> list[Any]:
    """Items with their kinds; what one of them lacks it takes from another."""
    items = [mended(*pair) for pair in pairs]
    others = [item for item in items if item is not LOST] + spares
    return [
        mended(*pair, *others[:1]) if item is LOST else item
        for item, pair in zip(items, pairs, strict=True)
    ]


def _record(data: dict[str, Any], record: Any, spare: dict[str, Any]) -> Any:  # noqa: ANN401
    whole = {}
    for name, field in fields_of(record).items():
        part = LOST
        if name in data:
            part = mended(data[name], field.type, spare.get(name, LOST))
        if part is LOST and field.required:
            part = spare.get(name, LOST)
        if part is not LOST:
            whole[name] = part
        elif field.required:
            return LOST
    return whole

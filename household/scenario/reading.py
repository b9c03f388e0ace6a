"""Reading scenarios: from a name, a file or a record to a record that is whole."""

from pathlib import Path
from typing import Any

import msgspec

from household.config.toml import convert, locate, read_toml
from household.errors import HouseholdError, shown, shown_path
from household.scenario.scenario import Scenario, persona_of


def described(
    scenario: str | Path | Scenario, **overrides: object
) -> tuple[str, dict[str, Any]]:
    """A scenario as plain data, with nothing checked.

    Args:
        scenario: A built-in name, a path to a TOML file, or a scenario.
        **overrides: Top-level fields to replace.

    Returns:
        What to call it in messages, and its fields.

    Raises:
        HouseholdError: If its file cannot be read, or an override is no plain data.
    """
    fields: dict[str, Any]
    if isinstance(scenario, Scenario):
        origin, fields = scenario.name, msgspec.structs.asdict(scenario)
    else:
        path = locate(str(scenario), "scenario")
        origin, fields = str(scenario), from_its_folder(read_toml(path), path.parent)
    # As plain data, so that overrides are checked like what stands in a file.
    plain = {name: _plain(value, name) for name, value in (fields | overrides).items()}
    return shown_path(origin), plain


def _plain(value: object, name: str) -> Any:  # noqa: ANN401 - nested plain data
    """Records as tables, and arrays as lists."""
    try:
        return msgspec.to_builtins(value, enc_hook=lambda array: array.tolist())
    except (AttributeError, TypeError, ValueError, RecursionError):
        kind = type(value).__name__
        raise HouseholdError(
            f"{shown_path(name)}: {shown(value)}, {kind}; "
            "allowed: numbers, texts, lists, tables"
        ) from None


def from_its_folder(fields: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Files that a scenario names are sought from where its own file lies."""

    def placed(name: object) -> object:
        return str(folder / str(name)) if _is_file(name) else name

    changed = {name: placed(fields[name]) for name in ("home",) if name in fields}
    people = fields.get("people")
    if isinstance(people, list):
        changed["people"] = [
            person | {"persona": placed(person["persona"])}
            if isinstance(person, dict) and "persona" in person
            else person
            for person in people
        ]
    return fields | changed


def read_scenario(scenario: str | Path | Scenario, **overrides: object) -> Scenario:
    """A scenario, each of its fields checked, but not yet how they fit together.

    Args:
        scenario: A built-in name, a path to a TOML file, or a scenario.
        **overrides: Top-level fields to replace.

    Raises:
        HouseholdError: Names the file, the path inside it and what is allowed.
    """
    origin, fields = described(scenario, **overrides)
    return with_its_files(convert(fields, Scenario, origin), origin)


def with_its_files(scenario: Scenario, origin: str) -> Scenario:
    """A scenario that holds what its files held when it was read.

    Files may be edited while it is in use, and are not there for another machine.

    Args:
        scenario: May name files of the user's own.
        origin: What to call it in messages.

    Raises:
        HouseholdError: If one of them cannot be used.
    """
    try:
        home = scenario.plan if _is_file(scenario.home) else scenario.home
        people = tuple(
            msgspec.structs.replace(person, persona=persona_of(person))
            if _is_file(person.persona)
            else person
            for person in scenario.people
        )
    except HouseholdError as error:
        raise HouseholdError(f"{origin}: {error}") from None
    return msgspec.structs.replace(scenario, home=home, people=people)


def _is_file(named: object) -> bool:
    return isinstance(named, str) and named.endswith(".toml")

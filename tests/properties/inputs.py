"""Whole inputs: what is shipped or drawn, changed here and there."""

from functools import cache
from pathlib import Path
from typing import Any

import msgspec
import tomli_w
from hypothesis import strategies as st

from household.config.toml import Kind, read_toml, shipped
from household.errors import HouseholdError
from household.home.floorplan import FloorPlan
from household.home.sources.generator import generate
from household.scenario.family import Family, draw
from household.scenario.norms import Norms, household_norms
from household.scenario.persona import Persona
from household.scenario.scenario import Scenario

from .plain_data import changed


def _shipped(kind: Kind) -> list[Any]:
    return [read_toml(path) for path in shipped(kind).values()]


@cache
def _homes() -> list[Any]:
    drawn = [generate(seed, rooms=rooms) for seed, rooms in enumerate((1, 3, 6))]
    return _shipped("home") + [msgspec.to_builtins(plan) for plan in drawn]


@cache
def _scenarios() -> list[Any]:
    drawn = [draw(name, seed) for seed, name in enumerate(shipped("family"))]
    return _shipped("scenario") + [msgspec.to_builtins(each) for each in drawn]


def scenarios() -> st.SearchStrategy[Any]:
    """Scenarios, those of families with their homes in them."""
    return _changed(_scenarios(), Scenario)


def homes() -> st.SearchStrategy[Any]:
    """Floor plans, shipped and generated."""
    return _changed(_homes(), FloorPlan)


def personas() -> st.SearchStrategy[Any]:
    """Kinds of people."""
    return _changed(_shipped("persona"), Persona)


def norms() -> st.SearchStrategy[Any]:
    """What is polite."""
    return _changed([msgspec.to_builtins(household_norms())], Norms)


def families() -> st.SearchStrategy[Any]:
    """Scenario families."""
    return _changed(_shipped("family"), Family)


def _changed(originals: list[Any], kind: Any) -> st.SearchStrategy[Any]:
    return st.sampled_from(originals).flatmap(lambda data: changed(data, kind))


def written(data: Any, path: Path) -> bool:
    """Writes data as a TOML file; returns whether TOML has such data at all."""
    try:
        path.write_text(tomli_w.dumps(data), encoding="utf-8")
    except (AttributeError, TypeError, ValueError):  # No table, null, no character.
        return False
    return True


def told(error: HouseholdError) -> str:
    """What a refusal says: one line that ends, and can be printed."""
    said = str(error)
    assert said.isprintable(), said
    assert 0 < len(said) < 3000, len(said)
    assert ": " in said or "unknown" in said, said
    return said

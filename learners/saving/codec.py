"""Values as tagged JSON and back.

A saved class is registered with `@saved`. Dataclasses need nothing more; any other
class (a state, say) provides `to_data()` and the class method `from_data(data)`, built
of None, bool, int, float, str, tuple, list, dict, set, frozenset and registered
classes. A field with `metadata=ATTACHED` (a callable into the world) is not written
but given again to `load`; a field with `metadata=DERIVED` is computed anew.

What is read must be what the fields are annotated with; a class that knows more of how
they fit together says so in `check_loaded`.
"""

import dataclasses
import functools
import json
from collections.abc import Callable, Mapping
from types import FunctionType
from typing import Any, TypeVar

import numpy as np

from learners.errors import SavedFileError, shown
from learners.saving.checking import check_fields
from learners.saving.older import upgraded

ATTACHED: Mapping[str, bool] = {"attached": True}
DERIVED: Mapping[str, bool] = {"derived": True}


_T = TypeVar("_T", bound=Callable[..., Any])  # a class or a function
_registry: dict[str, Any] = {}


def saved(thing: _T) -> _T:
    """Register a class or a function, by its name, as something that can be saved.

    Raises:
        ValueError: if another thing of this name is registered already.
    """
    known = _registry.setdefault(thing.__name__, thing)
    if known is not thing and known.__module__ != thing.__module__:
        raise ValueError(f"two saved things are called {thing.__name__!r}")
    _registry[thing.__name__] = thing
    return thing


def encode(value: Any) -> Any:  # noqa: ANN401 - any saved value, as JSON
    """A value as JSON, each kind under its tag.

    Raises:
        SavedFileError: if its class is not registered with `saved`.
    """
    kind: type = type(value)
    encoder = _encoder_of(kind)
    if encoder is not None:
        return encoder(value)
    name = value.__name__ if isinstance(value, FunctionType) else type(value).__name__
    if name not in _registry:
        raise SavedFileError(f"cannot save a {name}: register it with learners.saved")
    if isinstance(value, FunctionType):
        return {"function": name}
    return {"object": name, "data": _object_data(value)}


@functools.cache  # Of types there are few, of values millions.
def _encoder_of(kind: type) -> Callable[[Any], Any] | None:
    for each, encoder in _ENCODERS.items():
        if issubclass(kind, each):
            return encoder
    return None


def _object_data(value: Any) -> Any:  # noqa: ANN401 - any registered object
    if hasattr(value, "to_data"):
        return encode(value.to_data())
    return {f.name: encode(getattr(value, f.name)) for f in _written_fields(value)}


def _written_fields(value: Any) -> list[dataclasses.Field[Any]]:  # noqa: ANN401
    skipped = {"attached", "derived"}
    return [f for f in dataclasses.fields(value) if not skipped & f.metadata.keys()]


def _encode_set(value: set[Any] | frozenset[Any]) -> dict[str, Any]:
    # Sorted, so that equal learners give equal files.
    return {"set": sorted((encode(item) for item in value), key=json.dumps)}


def _encode_generator(rng: np.random.Generator) -> dict[str, Any]:
    state = rng.bit_generator.state
    return {"generator": state["bit_generator"], "state": encode(state)}


def _as_it_is(value: bool | str | None) -> bool | str | None:
    return value


_ENCODERS: dict[type, Callable[[Any], Any]] = {
    type(None): _as_it_is,
    str: _as_it_is,
    bool: _as_it_is,
    int: int,
    np.integer: int,
    np.bool_: bool,
    float: float,
    np.floating: float,
    tuple: lambda value: {"tuple": [encode(item) for item in value]},
    list: lambda value: [encode(item) for item in value],
    dict: lambda value: {"dict": [[encode(k), encode(v)] for k, v in value.items()]},
    set: _encode_set,
    frozenset: _encode_set,
    np.ndarray: lambda value: {"array": value.tolist(), "dtype": str(value.dtype)},
    np.random.Generator: _encode_generator,
}


_BIT_GENERATORS: dict[str, type[np.random.BitGenerator]] = {
    kind.__name__: kind
    for kind in (
        np.random.MT19937,
        np.random.PCG64,
        np.random.PCG64DXSM,
        np.random.Philox,
        np.random.SFC64,
    )
}
"""By name: a file may not name just anything of numpy."""


def _array(data: dict[str, Any]) -> Any:  # noqa: ANN401 - of any shape
    kind = np.dtype(data["dtype"])
    if kind.kind not in "biuf":
        raise ValueError(f"arrays of {kind}")
    return np.array(data["array"], dtype=kind)


class Decoder:
    """Turns tagged JSON back into values, with what is attached to them.

    Args:
        attached: callables that are not written, by the name of their field.
        older: whether the JSON is of an older version of the format.
    """

    def __init__(self, attached: Mapping[str, object], *, older: bool = False) -> None:
        self._attached = attached
        self._older = older
        self._by_tag: dict[str, Callable[[dict[str, Any]], Any]] = {
            "tuple": lambda data: tuple(map(self.decode, data["tuple"])),
            "dict": lambda data: {
                self.decode(k): self.decode(v) for k, v in data["dict"]
            },
            "set": lambda data: frozenset(map(self.decode, data["set"])),
            "array": _array,
            "generator": self._generator,
            "function": lambda data: self._registered(data["function"]),
            "object": self._object,
        }

    def decode(self, data: Any) -> Any:  # noqa: ANN401 - any saved value
        """The value that `encode` made this JSON of.

        Raises:
            SavedFileError: if a class or a callable that it needs is missing.
        """
        if isinstance(data, list):
            return [self.decode(item) for item in data]
        if isinstance(data, dict):
            return self._by_tag[next(iter(data))](data)
        return data

    def _registered(self, name: str) -> Any:  # noqa: ANN401 - class or function
        if not isinstance(name, str) or name not in _registry:
            raise SavedFileError(
                f"the file needs {shown(name)}: import it, or register it with "
                "learners.saved, before loading"
            )
        return _registry[name]

    def _generator(self, data: dict[str, Any]) -> np.random.Generator:
        bits = _BIT_GENERATORS[data["generator"]]()
        bits.state = self.decode(data["state"])
        return np.random.Generator(bits)

    def _object(self, data: dict[str, Any]) -> Any:  # noqa: ANN401 - any registered one
        name, raw = data["object"], data["data"]
        if self._older:
            name, raw = upgraded(name, raw)
        cls = self._registered(name)
        if hasattr(cls, "from_data"):
            return cls.from_data(self.decode(raw))
        written = {field.name for field in _written_fields(cls)}
        values = {n: self.decode(value) for n, value in raw.items() if n in written}
        check_fields(cls, values)
        for each in dataclasses.fields(cls):
            if each.metadata.get("attached"):
                values[each.name] = self._attachment(cls, each.name)
        init = {f.name for f in dataclasses.fields(cls) if f.init} & values.keys()
        made = cls(**{name: values.pop(name) for name in init})
        for name, value in values.items():  # frozen or not, the rest is set as it was
            object.__setattr__(made, name, value)
        if hasattr(made, "check_loaded"):
            made.check_loaded()
        return made

    def _attachment(self, cls: type, name: str) -> object:
        if name not in self._attached:
            raise SavedFileError(
                f"{cls.__name__} needs its {name!r} again: load(path, {name}=...)"
            )
        return self._attached[name]

"""Components of a learner as plain data, for studies that write down what they compare.

Settings are names, or tables with a name::

    make_learner("skip_silence", n, rng, **made({"credit": "designated", "gamma": 0.2}))
    make_learner("q_social", n, rng, **made({"rate": {"name": "social", "center": 1}}))
"""

import difflib
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, cast

from learners.analogy import (
    AdaptiveAnalogy,
    Analogy,
    Propagation,
    RemoveEntity,
    SwapRoles,
)
from learners.baselines.delay_density import DelayDensity
from learners.baselines.fixed_shift import FixedShift
from learners.baselines.travel_posterior import TravelPosterior
from learners.baselines.uniform_window import UniformWindow
from learners.catalog.situations import rates_of_people
from learners.credit.rules import Designated, Immediate, Trace
from learners.errors import LONGEST, ParameterError, UnknownNameError, shown
from learners.exploration import (
    EpsilonGreedy,
    Exploration,
    Greedy,
    SeekCompany,
    Softmax,
    Thompson,
    UpperConfidence,
)
from learners.pooling import (
    AdaptivePooling,
    FullPooling,
    HierarchicalPooling,
    NoPooling,
)
from learners.representation import (
    AudibleViews,
    Canonical,
    MarkedSituations,
    Named,
    Nameless,
    NestedViews,
    PersonViews,
    Views,
    ViewSet,
)
from learners.tabular.rates import (
    AsynchronousRate,
    ConstantRate,
    SocialRate,
    SynchronousRate,
)
from learners.tabular.silence import SilentSteps


def _seeking(among: object = "softmax") -> SeekCompany:
    """The rule among people is made by name as well."""
    return SeekCompany(among=cast(Exploration, _component("exploration", among)))


COMPONENTS: Mapping[str, Mapping[str, Callable[..., object]]] = {
    "rate": {
        "constant": ConstantRate,
        "synchronous": SynchronousRate,
        "asynchronous": AsynchronousRate,
        "social": SocialRate,
    },
    "credit": {
        "immediate": Immediate,
        "trace": Trace,
        "designated": Designated,
        "fixed_shift": FixedShift,
        "uniform_window": UniformWindow,
        "delay_density": DelayDensity,
        "travel_posterior": TravelPosterior,
    },
    "representation": {
        "named": Named,
        "canonical": Canonical,
        "nameless": Nameless,
        "marked": MarkedSituations,
        "view_set": ViewSet,
        "views": Views,
        "audible_views": AudibleViews,
        "nested_views": NestedViews,
        "person_views": PersonViews,
    },
    "pooling": {
        "none": NoPooling,
        "full": FullPooling,
        "hierarchical": HierarchicalPooling,
        "hierarchical_rates": rates_of_people,
        "adaptive": AdaptivePooling,
    },
    "analogy": {
        "none": Analogy,
        "swap": Propagation,
        "swap_remove": partial(Propagation, operators=(SwapRoles(), RemoveEntity())),
        "remove": partial(Propagation, operators=(RemoveEntity(),)),
        "adaptive": AdaptiveAnalogy,
    },
    "exploration": {
        "softmax": Softmax,
        "greedy": Greedy,
        "epsilon_greedy": EpsilonGreedy,
        "upper_confidence": UpperConfidence,
        "thompson": Thompson,
        "seek_company": _seeking,
    },
    "silent_steps": {
        "together": SilentSteps,
        "apart": partial(SilentSteps, apart=True),
        "held": partial(SilentSteps, held=True),
        "apart_held": partial(SilentSteps, apart=True, held=True),
    },
}
"""Setting of a learner -> name -> what makes such a component."""

_CALLED_BEFORE = {("analogy", "canonical"): ("representation", "canonical")}
"""Setting and name of a component in older configurations -> what they are now."""


def made(settings: Mapping[str, Any]) -> dict[str, Any]:
    """Returns settings for `make_learner` with every named component made.

    Args:
        settings: By setting. Of those in `COMPONENTS`, a text names a component, and
            a mapping names it under `name` beside the component's own settings; all
            else is passed on.

    Raises:
        UnknownNameError: If there is no such component or setting of it.
        ParameterError: If a setting of a component is out of range.
    """
    return dict(_made(setting, value) for setting, value in settings.items())


def name_of(setting: str, component: object) -> str:
    """Returns the first name under which components of this type are made.

    Raises:
        UnknownNameError: If there is none.
    """
    for name, make in COMPONENTS[setting].items():
        if type(make()) is type(component):
            return name
    raise UnknownNameError(f"no {setting} is made as {type(component).__name__}")


def _made(setting: str, value: object) -> tuple[str, object]:
    if isinstance(value, str):
        setting, value = _CALLED_BEFORE.get((setting, value), (setting, value))
    made = _component(setting, value) if setting in COMPONENTS else value
    return setting, made


def _component(setting: str, value: object) -> object:
    if isinstance(value, str):
        return _known(setting, value)()
    if not isinstance(value, Mapping):
        return value
    own = dict(value)
    name = str(own.pop("name", ""))
    make = _known(setting, name)
    try:
        return make(**{setting: _frozen(value) for setting, value in own.items()})
    except TypeError as error:
        raise ParameterError(f"{setting} {shown(name)}: {error}") from error


def _frozen(value: object) -> object:
    """Lists as tuples: files know no tuples, and components are frozen."""
    return tuple(map(_frozen, value)) if isinstance(value, list) else value


def _known(setting: str, name: str) -> Callable[..., object]:
    known = COMPONENTS[setting]
    if name in known:
        return known[name]
    near = difflib.get_close_matches(name[:LONGEST], sorted(known), n=1, cutoff=0.0)
    hint = f"; did you mean {near[0]!r}?" if near else ""
    raise UnknownNameError(f"there is no {setting} called {shown(name)}{hint}")

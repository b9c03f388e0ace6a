"""The views of a recording, each in the form in which blueprints arrange them."""

from typing import Any

from household.replay.scenery import lanes_of
from household.replay.sheets import (
    LANE,
    WINDOW,
    legend_height,
    margin,
    names_of,
    second,
)
from household.scenario.scenario import Scenario
from household.view.floorplan_svg import size_of

PAPER = (250, 250, 248)
"""Background of drawings, in a dark viewer as well."""


def plan(scenario: Scenario, prefix: str = "", name: str = "") -> Any:  # noqa: ANN401 - Rerun's
    """The home with everybody in it, and the legend.

    Args:
        scenario: The household.
        prefix: Of the entities' paths, as in "/a".
        name: Of the view; empty: of the household.
    """
    import rerun.blueprint as rrb

    home = scenario.plan
    width, height = size_of(home)
    left, top = float(home.lower[0]) - 0.3, float(home.upper[1]) + 0.3
    bottom = height - top + legend_height(scenario)
    return rrb.Spatial2DView(
        origin=prefix or "/",
        contents=[f"+ {prefix}/{part}/**" for part in ("plan", "legend", "world")],
        name=name or f"{scenario.name}: {home.name}",
        background=PAPER,
        visual_bounds=rrb.VisualBounds2D(
            x_range=[left, left + width], y_range=[-top, bottom]
        ),
    )


def why(robot: str, prefix: str = "") -> Any:  # noqa: ANN401
    """Why a robot does what it does."""
    import rerun.blueprint as rrb

    return rrb.TextDocumentView(origin=f"{prefix}/why/{robot}", name=f"Why? {robot}")


def attention(scenario: Scenario) -> Any:  # noqa: ANN401
    """Who attends to whom, and how much."""
    import rerun.blueprint as rrb

    n, edge = len(names_of(scenario)), margin(scenario)
    return rrb.Spatial2DView(
        origin="/attention",
        name="Attention: row looks at column",
        background=PAPER,
        visual_bounds=rrb.VisualBounds2D(x_range=[-edge, n], y_range=[-edge, n]),
    )


def situations() -> Any:  # noqa: ANN401
    """What each robot sees."""
    import rerun.blueprint as rrb

    return rrb.TextDocumentView(origin="/situation", name="Situation")


def events(prefix: str = "") -> Any:  # noqa: ANN401
    """Touches, credit, mistakes and changes of mind; a click on a time goes there."""
    return _log(
        "Events: click on a time", prefix, ["touches", "credit", "minds"], "LogLevel"
    )


def firsts() -> Any:  # noqa: ANN401
    """First visits of situations."""
    return _log("First visits", "", ["firsts"])


def _log(name: str, prefix: str, kinds: list[str], *columns: str) -> Any:  # noqa: ANN401
    import rerun.blueprint as rrb

    shown: Any = [*columns, "Body"]
    return rrb.TextLogView(
        origin=f"{prefix}/events",
        contents=[f"+ {prefix}/events/{kind}" for kind in kinds],
        name=name,
        columns=rrb.TextLogColumns(text_log_columns=shown),
    )


def values(robot: str) -> Any:  # noqa: ANN401
    """What a robot expected of its behaviors in the last minute."""
    import rerun.blueprint as rrb

    boundary = rrb.TimeRangeBoundary
    return rrb.TimeSeriesView(
        origin=f"/q/{robot}",
        name=f"Q of {robot}",
        axis_x=rrb.TimeAxis(
            view_range=rrb.TimeRange(
                boundary.cursor_relative(seq=-60), boundary.cursor_relative(seq=5)
            )
        ),
        plot_legend=rrb.PlotLegend(visible=False),  # as below the plan
    )


def moods() -> Any:  # noqa: ANN401
    """How people feel."""
    import rerun.blueprint as rrb

    return rrb.TimeSeriesView(
        origin="/mood",
        name="Moods (private)",
        axis_y=rrb.ScalarAxis(range=(-1.0, 1.0)),
    )


def rewards() -> list[Any]:
    """The touches, and their sums."""
    import rerun.blueprint as rrb

    return [
        rrb.TimeSeriesView(
            origin="/reward/sum",
            name="Sum of touches",
            plot_legend=rrb.Corner2D.LeftTop,
        ),
        rrb.TimeSeriesView(
            origin="/reward/now",
            name="Touches",
            plot_legend=rrb.PlotLegend(visible=False),
            axis_y=rrb.ScalarAxis(range=(-1.1, 1.1)),
        ),
    ]


def doings(scenario: Scenario) -> Any:  # noqa: ANN401
    """Who does what, in the seconds around the moment shown."""
    import rerun.blueprint as rrb

    boundary = rrb.TimeRangeBoundary
    around = rrb.TimeRange(
        boundary.cursor_relative(seq=-40), boundary.cursor_relative(seq=5)
    )
    return rrb.StateTimelineView(
        origin="/",
        contents=[f"+ /{lane}" for lane in lanes_of(scenario)],
        name="Activities and behaviors",
        time_view=rrb.TimeAxis(view_range=around),
    )


def credit(scenario: Scenario, prefix: str = "", name: str = "") -> Any:  # noqa: ANN401
    """Lanes of the last seconds, with what touches are about, believed and true."""
    import rerun.blueprint as rrb

    n, unit = len(scenario.robots), second(scenario)
    back = round(WINDOW / scenario.decision_period)
    boundary = rrb.TimeRangeBoundary
    ranges = [
        rrb.VisibleTimeRange(
            "decision",
            start=boundary.cursor_relative(seq=-back),
            end=boundary.cursor_relative(),
        ),
        rrb.VisibleTimeRange(
            "seconds",
            start=boundary.cursor_relative(seconds=-WINDOW),
            end=boundary.cursor_relative(),
        ),
    ]
    return rrb.Spatial2DView(
        origin=f"{prefix}/credit",
        name=name or "Credit: believed above, true below",
        background=PAPER,
        visual_bounds=rrb.VisualBounds2D(
            x_range=[-(WINDOW + 9.5) * unit, 2 * unit],
            y_range=[-0.7 * LANE, (n - 0.2) * LANE],
        ),
        time_ranges=ranges,
    )

"""The blueprint that a recording brings along: what the viewer shows where."""

from typing import TYPE_CHECKING, Any

from household.replay.scenery import LANE, MOST_ROWS, WINDOW, lanes_of, names_of, second
from household.scenario.scenario import Scenario
from household.view.floorplan_svg import size_of

if TYPE_CHECKING:
    import rerun.blueprint as rrb

PAPER = (250, 250, 248)
"""Background of drawings, in a dark viewer as well."""


def blueprint(scenario: Scenario, learns: bool, live: bool) -> "rrb.Blueprint":
    """The plan in the middle, attention and values beside it, time series below.

    Args:
        scenario: The household.
        learns: Whether there are learners whose beliefs can be shown.
        live: Whether the viewer shows the newest moment as it comes in.
    """
    import rerun.blueprint as rrb

    matrix = min(6.0, max(3.0, 0.4 * len(names_of(scenario))))
    left = rrb.Vertical(
        _attention(scenario),
        _situations(),
        _moods(),
        row_shares=[matrix, 1.2, 2],
    )
    values = _values(scenario) if learns else []
    shares = [2.0] * len(values) + [2.5]
    right = rrb.Vertical(*values, _events(), row_shares=shares)
    above = rrb.Horizontal(left, _plan(scenario), right, column_shares=[3, 6, 4])
    rewards = rrb.Vertical(*_rewards(), row_shares=[2, 3])
    below = rrb.Horizontal(
        rewards, _doings(scenario), _credit(scenario), column_shares=[3, 4, 6]
    )
    fps = 10.0 / scenario.decision_period
    return rrb.Blueprint(
        rrb.Vertical(above, below, row_shares=[5, 2.4]),
        rrb.TimePanel(
            timeline="decision",
            state="collapsed",
            play_state="following" if live else "paused",
            fps=fps,
        ),
        rrb.BlueprintPanel(state="collapsed"),
        rrb.SelectionPanel(state="collapsed"),
        auto_views=False,
    )


def _plan(scenario: Scenario) -> Any:  # noqa: ANN401 - Rerun's views
    import rerun.blueprint as rrb

    plan = scenario.plan
    width, height = size_of(plan)
    left, top = float(plan.lower[0]) - 0.3, float(plan.upper[1]) + 0.3
    return rrb.Spatial2DView(
        origin="/",
        contents=["+ /plan/**", "+ /world/**"],
        name=f"{scenario.name}: {plan.name}",
        background=PAPER,
        visual_bounds=rrb.VisualBounds2D(
            x_range=[left, left + width], y_range=[-top, height - top]
        ),
    )


def _attention(scenario: Scenario) -> Any:  # noqa: ANN401
    import rerun.blueprint as rrb

    n = len(names_of(scenario))
    names = 0.2 * n if n <= MOST_ROWS else 0.0
    return rrb.Spatial2DView(
        origin="/attention",
        name="Attention: row looks at column",
        background=PAPER,
        visual_bounds=rrb.VisualBounds2D(
            x_range=[-1 - names, 1.05 * n], y_range=[-1.0, n + 0.5]
        ),
    )


def _situations() -> Any:  # noqa: ANN401
    import rerun.blueprint as rrb

    return rrb.TextDocumentView(origin="/situation", name="Situation")


def _events() -> Any:  # noqa: ANN401
    import rerun.blueprint as rrb

    return rrb.TextLogView(
        origin="/events",
        name="Touches and credit",
        columns=rrb.TextLogColumns(text_log_columns=["Body"]),
    )


def _values(scenario: Scenario) -> list[Any]:
    import rerun.blueprint as rrb

    views = [
        rrb.TimeSeriesView(origin=f"/q/{robot}", name=f"Q-values of {robot}")
        for robot in scenario.robot_names
    ]
    return views if len(views) <= 3 else [rrb.Tabs(*views)]


def _moods() -> Any:  # noqa: ANN401
    import rerun.blueprint as rrb

    return rrb.TimeSeriesView(
        origin="/mood",
        name="Moods (private)",
        axis_y=rrb.ScalarAxis(range=(-1.0, 1.0)),
    )


def _rewards() -> list[Any]:
    import rerun.blueprint as rrb

    legend = rrb.PlotLegend(visible=False)
    return [
        rrb.TimeSeriesView(
            origin="/reward/now",
            name="Touches",
            plot_legend=legend,
            axis_y=rrb.ScalarAxis(range=(-1.1, 1.1)),
        ),
        rrb.TimeSeriesView(
            origin="/reward/sum",
            name="Sum of touches",
            plot_legend=rrb.Corner2D.LeftTop,
        ),
    ]


def _doings(scenario: Scenario) -> Any:  # noqa: ANN401
    import rerun.blueprint as rrb

    lanes = [f"+ /{lane}" for lane in lanes_of(scenario)]
    boundary = rrb.TimeRangeBoundary
    around = rrb.TimeRange(
        boundary.cursor_relative(seq=-40), boundary.cursor_relative(seq=5)
    )
    return rrb.StateTimelineView(
        origin="/",
        contents=lanes,
        name="Activities and behaviors",
        time_view=rrb.TimeAxis(view_range=around),
    )


def _credit(scenario: Scenario) -> Any:  # noqa: ANN401
    import rerun.blueprint as rrb

    n, period = len(scenario.robots), scenario.decision_period
    unit = second(scenario)
    back = round(WINDOW / period)
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
        origin="/credit",
        name="Credit: believed above, true below",
        background=PAPER,
        visual_bounds=rrb.VisualBounds2D(
            x_range=[-(WINDOW + 9) * unit, 2 * unit],
            y_range=[-0.7 * LANE, (n - 0.1) * LANE],
        ),
        time_ranges=ranges,
    )
